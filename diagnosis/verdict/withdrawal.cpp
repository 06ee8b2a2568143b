#include "diagnosis/verdict/withdrawal.hpp"

#include <algorithm>

namespace reeve::diagnosis {
namespace {

// In log-likelihood, on the held-out runs. Each fitted parameter costs half on average where it is
// needed for nothing there, and of few runs some know nothing of a cause that acts in one routing.
constexpr double chance_loss = 2;

bool names_a_coefficient(const Explanation& explanation) {
  return std::any_of(explanation.calibrations.begin(), explanation.calibrations.end(),
                     [](const Calibration& calibration) { return calibration.differs; });
}

}  // namespace

Withdrawal withdraw_what_may_lose(Explanation& explanation, const Dataset& held_out,
                                  const Model& nominal, std::uint64_t seed) {
  Withdrawal result;
  if (held_out.cells.empty()) return result;
  const auto may_lose = [&](const Model& before) {
    const Problem unseen = problem(held_out, explanation.scatter, explanation.model);
    const HeldOut gain = held_out_gain(unseen, before, explanation.model, seed);
    if (gain.gain_low >= -chance_loss) return false;
    result.held_out = gain;
    return true;
  };
  while (!explanation.accepted.empty() && (may_lose(explanation.base) || may_lose(nominal))) {
    result.names.push_back(effect_name(explanation.accepted.back().effect));
    take_back_last(explanation);
  }
  if (!names_a_coefficient(explanation) || !may_lose(nominal)) return result;
  for (Calibration& calibration : explanation.calibrations) {
    if (calibration.differs) result.names.push_back(effect_name(calibration.effect));
    calibration.differs = false;
  }
  explanation.model = nominal;
  explanation.problem = problem(*explanation.problem.dataset, explanation.scatter, nominal);
  return result;
}

}  // namespace reeve::diagnosis
