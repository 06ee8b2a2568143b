#include "cli/flags/sweep_flags.hpp"

#include "cli/inputs.hpp"

namespace reeve::cli {

void SweepFlags::add_to(CLI::App& command, const std::string& designs) {
  given_ = command.add_option(
      "--sweep", text,
      "Vary one coefficient, such as mu=0.02..0.3 or sheath_angle=3..9, and show " + designs);
}

std::optional<CoefficientRange> SweepFlags::read() const {
  if (given_->count() == 0) return std::nullopt;
  return for_name("--", [&] { return parse_sweep(text); });
}

void require_sweep(const std::optional<CoefficientRange>& over, const UncertaintyOptions& evaluated,
                   bool draws) {
  if (over) for_name("--", [&] { validate(SweepOptions{evaluated, draws, *over}); });
}

}  // namespace reeve::cli
