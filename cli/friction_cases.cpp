#include "cli/friction_cases.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "cli/inputs.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::cli {
namespace {

constexpr double greatest_mu = 1;
constexpr std::size_t most_cases = 6;

FrictionCase read_case(const std::string& item, const Model& model) {
  if (item == "model") return {FrictionKind::model, model};
  const auto mu = number_in(item);
  if (!mu || *mu < 0 || *mu > greatest_mu) {
    throw InputError(
        {.value = item,
         .expected = "friction coefficients from 0 to 1, or 'model', such as 0.18,0.09,model"});
  }
  FrictionCase result = with_coefficient(model, *mu);
  validate(effective_hardware(result.model));
  return result;
}

}  // namespace

std::vector<FrictionCase> read_friction_cases(const std::string& text, const Model& model) {
  return for_option(fmt::format("--mu '{}'", text), [&] {
    std::vector<FrictionCase> cases;
    std::set<std::pair<FrictionKind, double>> seen;
    std::istringstream items(text + ",");
    items.exceptions(std::ios::badbit);  // no memory is no end of the text
    for (std::string item; std::getline(items, item, ',');) {
      cases.push_back(read_case(item, model));
      const FrictionCase& last = cases.back();
      const double mu =
          last.kind == FrictionKind::coefficient ? last.model.hardware.tube.mu : greatest_mu;
      if (!seen.emplace(last.kind, mu).second) {
        throw InputError(fmt::format("{} is given twice", item));
      }
    }
    if (cases.size() > most_cases) {
      throw InputError({.expected = fmt::format("at most {} of them", most_cases)});
    }
    return cases;
  });
}

}  // namespace reeve::cli
