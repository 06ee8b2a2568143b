#include "diagnosis/verdict/leads.hpp"

#include <algorithm>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/law_screening.hpp"

namespace reeve::diagnosis {
namespace {

std::optional<PartialResiduals> partial_of(const Sample& sample, const Problem& problem,
                                           const Extended& with, const Scatter& scatter,
                                           Workers& workers) {
  if (!try_forecast(sample.training, with.model)) return std::nullopt;
  const auto spreads =
      effect_spreads(problem, with.model, parameter_intervals(problem, with.model));
  return partial_residuals(sample, with.model, scatter, with.effect, spreads[with.effect],
                           workers);
}

}  // namespace

bool is_of_one_place(const Effect& effect) {
  const Term* term = causes::term_of(*effect.cause);
  if (term == nullptr) return false;
  const Site& site = term->site;
  return !site.run.empty() || site.place == SitePlace::channel || site.number.has_value();
}

std::vector<Lead> leads(const Sample& sample, const Problem& problem, const Model& model,
                        const Scatter& scatter, Workers& workers) {
  const Dataset& training = sample.training;
  const Forecast at = forecast(training, model);
  const Projection projection(problem, model, at);
  const LawScreening screening(training, model, at, workers);
  std::vector<Lead> result;
  for (const ScreenedLaw& law : screening.best(
           problem, at, projection, projection.taken_out(residuals(problem, at)), most_leads)) {
    if (!(law.evidence > 0)) continue;
    const Effect effect = causes::with_crossing_held(law.effect);
    result.push_back({effect, law.evidence,
                      partial_of(sample, problem, extended(model, effect), scatter, workers)});
  }
  std::stable_partition(result.begin(), result.end(),
                        [](const Lead& lead) { return is_of_one_place(lead.effect); });
  return result;
}

}  // namespace reeve::diagnosis
