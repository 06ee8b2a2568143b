#include "diagnosis/verdict/confirmation.hpp"

#include "diagnosis/search/weighed.hpp"

namespace reeve::diagnosis {

Confirmation confirmation(const Problem& training, const Scatter& scatter, const Model& nominal,
                          const Model& extended, const std::vector<AppliedCause>& causes,
                          const std::vector<std::vector<Rival>>& rivals, const Dataset& held_out,
                          std::uint64_t seed, Workers& workers) {
  std::vector<std::string> names;
  for (const AppliedCause& cause : causes) names.push_back(cause.name);
  const auto weighed = weighed_models(training, nominal, extended, names, rivals);
  Confirmation result;
  result.of_causes.resize(causes.size());
  for (const WeighedModel& model : weighed) {
    result.weighed.push_back({model.causes, model.gain, std::nullopt});
  }
  if (held_out.cells.empty()) return result;
  const Problem unseen = problem(held_out, scatter, extended, workers);
  for (std::size_t c = 0; c < causes.size(); ++c) {
    const Fit before = fit(training, without(extended, place(extended, causes[c].effect)));
    result.of_causes[c] = held_out_gain(unseen, before.model, extended, seed + c);
  }
  for (std::size_t i = 0; i < weighed.size(); ++i) {
    // In some held-out row it may have no tensions: nothing to weigh it by.
    if (!try_forecast(held_out, weighed[i].model)) continue;
    result.weighed[i].held_out = held_out_gain(unseen, nominal, weighed[i].model, seed);
  }
  result.noise_limit = noise_limit(unseen, nominal);
  result.run_gains = run_gains(unseen, nominal, extended);
  if (!causes.empty()) result.together = held_out_gain(unseen, nominal, extended, seed);
  return result;
}

}  // namespace reeve::diagnosis
