#include "diagnosis/search/searched_model.hpp"

#include <cmath>
#include <utility>

namespace reeve::diagnosis {

double SearchedModel::price_of_parameter() const {
  return std::log(dataset.degrees_of_freedom()) / 2;
}

double SearchedModel::cost(const AcceptedTerm& term) const {
  return term.price + static_cast<double>(term.parameters) * price_of_parameter();
}

double SearchedModel::description(const std::vector<AcceptedTerm>& terms) const {
  double sum = 0;
  for (const AcceptedTerm& term : terms) sum += cost(term);
  return sum;
}

Scored SearchedModel::scored(Model model, std::optional<ScatterLevel> level) const {
  Scored result;
  const auto at = try_forecast(dataset, model);
  if (!at) return result;
  result.model = std::move(model);
  result.likelihood =
      level ? likelihood(dataset, shape, *at, *level) : likelihood(dataset, shape, *at);
  result.evidence = result.likelihood.value - description(accepted);
  return result;
}

Scored SearchedModel::fitted(const Model& model) const {
  return scored(fit(now.likelihood.problem, model).model);
}

double SearchedModel::evidence_of(const Model& model,
                                  const std::vector<AcceptedTerm>& terms) const {
  const Fit fitted = fit(now.likelihood.problem, model, Precision::to_compare);
  if (!has_tensions(fitted)) return -std::numeric_limits<double>::infinity();
  return scored(fitted.model).likelihood.value - description(terms);
}

Scored SearchedModel::without_term(std::size_t c) const {
  Scored result = fitted(without(now.model, place(now.model, accepted[c].effect)));
  Scored unshared = scored(fit(result.likelihood.problem, result.model).model);
  if (unshared.evidence > result.evidence) result = std::move(unshared);
  result.evidence += cost(accepted[c]);
  return result;
}

void SearchedModel::reshape(const Model& model) {
  shape = scatter_shape(dataset, model, mounting_scatter, workers);
  now = scored(model);
}

void SearchedModel::settle(const Model& model) {
  reshape(model);
  reshape(fit(now.likelihood.problem, model).model);
}

}  // namespace reeve::diagnosis
