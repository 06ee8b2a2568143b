#include "diagnosis/verdict/withdrawal.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/chi_squared.hpp"

namespace reeve::diagnosis {
namespace {

// In log-likelihood: what parameters that are needed for nothing lose at most in 95 of 100 data
// sets.
double chance_loss(std::size_t parameters) {
  return chi_squared_quantile(0.95, static_cast<double>(parameters)) / 2;
}

// What the lower end of a gain's interval is above in 95 of 100 data sets if the later model is
// right: the gain is then normal about half its variance.
double least_if_right(double expected_gain) {
  constexpr double ends = 1.960 + 1.645;  // of the interval, and of the 95
  return expected_gain - ends * std::sqrt(2 * expected_gain);
}

bool names_a_coefficient(const Explanation& explanation) {
  return std::any_of(explanation.calibrations.begin(), explanation.calibrations.end(),
                     [](const Calibration& calibration) { return calibration.differs; });
}

}  // namespace

Withdrawal withdraw_what_may_lose(Explanation& explanation, const Dataset& held_out,
                                  const Model& nominal, std::uint64_t seed, Workers& workers) {
  Withdrawal result;
  if (held_out.cells.empty()) return result;
  const auto may_lose = [&](const Model& before) {
    const Problem unseen = problem(held_out, explanation.scatter, explanation.model, workers);
    const HeldOut gain = held_out_gain(unseen, before, explanation.model, seed);
    const std::size_t more = parameter_count(explanation.model) - parameter_count(before);
    const double refuted =
        std::min(-chance_loss(std::max<std::size_t>(more, 1)), least_if_right(gain.expected_gain));
    if (gain.gain_low >= refuted) return false;
    result.held_out = gain;
    return true;
  };
  while (!explanation.accepted.empty() && (may_lose(explanation.base) || may_lose(nominal))) {
    result.names.push_back(effect_name(explanation.accepted.back().effect));
    take_back_last(explanation, workers);
  }
  if (!names_a_coefficient(explanation) || !may_lose(nominal)) return result;
  for (Calibration& calibration : explanation.calibrations) {
    if (calibration.differs) result.names.push_back(effect_name(calibration.effect));
    calibration.differs = false;
  }
  explanation.model = nominal;
  explanation.problem =
      problem(*explanation.problem.dataset, explanation.scatter, nominal, workers);
  return result;
}

}  // namespace reeve::diagnosis
