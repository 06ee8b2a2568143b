#include "diagnosis/verdict/explained.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/forecast.hpp"

namespace reeve::diagnosis {
namespace {

// N²; infinite where the model has no tensions.
double mean_square(const Sample& sample, const Model& model) {
  double sum = 0;
  double count = 0;
  for (const Dataset* part : {&sample.training, &sample.held_out}) {
    if (part->cells.empty()) continue;
    const auto at = try_forecast(*part, model, MotorSlopes::left_out);
    if (!at) return std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < part->cells.size(); ++i) {
      sum += std::pow(part->cells[i].measured_N - at->reading_N[static_cast<Eigen::Index>(i)], 2);
    }
    count += static_cast<double>(part->cells.size());
  }
  return count > 0 ? sum / count : 0;
}

Explained explained_by(double fall, double of) {
  if (!std::isfinite(fall) || !(of > 0)) return {};
  return {std::copysign(std::sqrt(std::abs(fall)), fall), fall / of};
}

struct Step {
  std::size_t term = 0;
  double fall = 0;  // of the mean square, N²
};

// Terms without which the next one explains nothing share with it: a coefficient, and a law that
// takes it back in one direction.
void share_alike(std::vector<Step>& steps) {
  for (auto from = steps.begin(); from != steps.end();) {
    double sum = from->fall;
    auto to = from + 1;
    while (sum < 0 && to != steps.end()) sum += (to++)->fall;
    const double each = sum / static_cast<double>(to - from);
    for (; from != to; ++from) from->fall = each;
  }
}

// N² that a model of these terms leaves once it is fitted.
double fitted_mean_square(const Sample& sample, const Problem& problem, Model model,
                          const std::vector<Effect>& apart) {
  for (const Effect& effect : apart) add_effect(model, effect);
  model = fit(problem, model, Precision::to_compare).model;
  for (const Effect& effect : apart) model = without(model, place(model, effect));
  return mean_square(sample, model);
}

}  // namespace

ExplainedResiduals explained_residuals(const Sample& sample, const Problem& problem,
                                       const Model& nominal, const Model& extended,
                                       const std::vector<Effect>& terms,
                                       const std::vector<Effect>& apart) {
  const double first = mean_square(sample, nominal);
  const double last = mean_square(sample, extended);
  ExplainedResiduals result{std::sqrt(first), std::sqrt(last), {}};
  result.terms.resize(terms.size());
  Model model = nominal;
  std::vector<std::size_t> left(terms.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<Step> steps;
  double now = first;
  while (!left.empty()) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    Model chosen;
    for (std::size_t k = 0; k < left.size(); ++k) {
      Model with = model;
      add_effect(with, extended.effects[place(extended, terms[left[k]])]);
      const double after =
          left.size() == 1 ? last : fitted_mean_square(sample, problem, with, apart);
      if (k > 0 && !(after < least)) continue;
      least = after;
      best = k;
      chosen = std::move(with);
    }
    steps.push_back({left[best], now - least});
    model = std::move(chosen);
    now = least;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  share_alike(steps);
  for (const Step& step : steps) result.terms[step.term] = explained_by(step.fall, first);
  return result;
}

}  // namespace reeve::diagnosis
