#include "diagnosis/verdict/explained.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    const auto at = try_forecast(*part, model);
    if (!at) return std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < part->cells.size(); ++i) {
      sum += std::pow(part->cells[i].measured_N - at->reading_N[static_cast<Eigen::Index>(i)], 2);
    }
    count += static_cast<double>(part->cells.size());
  }
  return count > 0 ? sum / count : 0;
}

Explained explained_by(double before, double after, double of) {
  if (!std::isfinite(before) || !std::isfinite(after) || !(of > 0)) return {};
  const double fall = before - after;
  return {std::copysign(std::sqrt(std::abs(fall)), fall), fall / of};
}

}  // namespace

ExplainedResiduals explained_residuals(const Sample& sample, const Model& nominal,
                                       const Model& extended, const std::vector<Effect>& terms) {
  const double first = mean_square(sample, nominal);
  ExplainedResiduals result{std::sqrt(first), std::sqrt(mean_square(sample, extended)), {}};
  result.terms.resize(terms.size());
  Model model = extended;
  std::vector<Effect> own;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    own.push_back(extended.effects[place(extended, terms[i])]);
    model = without(model, place(model, terms[i]));
    left.push_back(i);
  }
  double now = mean_square(sample, model);
  while (!left.empty()) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < left.size(); ++k) {
      Model with = model;
      add_effect(with, own[left[k]]);
      const double after = mean_square(sample, with);
      if (after < least) {
        least = after;
        best = k;
      }
    }
    result.terms[left[best]] = explained_by(now, least, first);
    add_effect(model, own[left[best]]);
    now = least;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return result;
}

}  // namespace reeve::diagnosis
