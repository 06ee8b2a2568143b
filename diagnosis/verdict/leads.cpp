#include "diagnosis/verdict/leads.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/law_families.hpp"

namespace reeve::diagnosis {
namespace {

constexpr std::size_t most_screened = 4 * most_leads;
constexpr double nearly_alike = 0.9;  // cosine

// Its evidence is that of the fit; none if that is not what a term needs.
std::optional<Lead> lead(const Sample& sample, const Problem& problem, const Model& model,
                         const ScreenedLaw& law, const Scatter& scatter, Workers& workers) {
  const Effect screened = causes::with_crossing_held(law.effect);
  const Fit fitted = fit(problem, extended(model, screened).model, Precision::to_compare);
  const double gain = (misfit(problem, model) - fitted.misfit) / 2;
  const double evidence = law.evidence + gain - law.gain;
  if (!(evidence >= least_evidence)) return std::nullopt;
  const std::size_t at = place(fitted.model, screened);
  const auto spreads =
      effect_spreads(problem, fitted.model, parameter_intervals(problem, fitted.model));
  return Lead{fitted.model.effects[at],
              evidence,
              partial_residuals(sample, fitted.model, scatter, at, spreads[at], workers),
              {}};
}

}  // namespace

bool is_of_one_place(const Effect& effect) {
  const Term* term = causes::term_of(*effect.cause);
  if (term == nullptr) return false;
  const Site& site = term->site;
  return !site.runs.empty() || site.place == SitePlace::channel || site.number.has_value();
}

std::vector<Lead> leads(const Sample& sample, const Problem& problem, const Model& model,
                        const Scatter& scatter, Workers& workers) {
  const Dataset& training = sample.training;
  const Forecast at = forecast(training, model);
  const Projection projection(problem, model, at);
  std::vector<Lead> result;
  std::vector<Eigen::VectorXd> changes;  // parallel, of length 1
  for (const ScreenedLaw& law :
       best_laws(law_table(training, model, at, workers), problem, at, projection,
                 projection.taken_out(residuals(problem, at)), most_screened)) {
    if (law.evidence < least_evidence) continue;
    const Effect screened = causes::with_crossing_held(law.effect);
    const auto there = try_forecast(training, extended(model, screened).model);
    if (!there) continue;
    Eigen::VectorXd change = projection.taken_out(difference(problem, at, *there)).normalized();
    const auto same = std::ranges::find_if(
        changes, [&](const auto& other) { return std::abs(other.dot(change)) > nearly_alike; });
    if (same != changes.end()) {
      result[static_cast<std::size_t>(same - changes.begin())].alike.push_back(screened);
    } else if (result.size() < most_leads) {
      auto fitted = lead(sample, problem, model, law, scatter, workers);
      if (!fitted) continue;
      result.push_back(std::move(*fitted));
      changes.push_back(std::move(change));
    }
  }
  std::ranges::stable_sort(result, std::greater{}, &Lead::evidence);
  std::stable_partition(result.begin(), result.end(),
                        [](const Lead& lead) { return is_of_one_place(lead.effect); });
  return result;
}

}  // namespace reeve::diagnosis
