#include "diagnosis/fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "numerics/least_squares.hpp"

namespace reeve::diagnosis {
namespace {

// A parameter that spans orders of magnitude is searched by its logarithm.
struct Coordinate {
  std::size_t effect = 0;
  std::size_t parameter = 0;
  Range range;
  bool logarithmic = false;

  double to_search(double value) const { return logarithmic ? std::log(value) : value; }
  double from_search(double x) const {
    return std::clamp(logarithmic ? std::exp(x) : x, range.low, range.high);
  }
};

constexpr double no_tensions = 1e300;

std::vector<Coordinate> coordinates(const Problem& problem, const Model& model) {
  constexpr double orders = 100;
  std::vector<Coordinate> result;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const auto parameters =
        searched_parameters(*model.effects[e].cause, model.hardware, problem.force_scale);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const Range range = parameters[p].range;
      result.push_back({e, p, range, range.low > 0 && range.high / range.low > orders});
    }
  }
  return result;
}

}  // namespace

bool has_tensions(const Fit& fit) { return fit.misfit < no_tensions; }

Fit fit(const Problem& problem, const Model& model, Precision precision) {
  constexpr int evaluations = 25;
  const std::vector<Coordinate> free = coordinates(problem, model);
  if (free.empty()) return {model, misfit(problem, model)};
  std::vector<Interval> box;
  std::vector<double> start;
  for (const Coordinate& x : free) {
    box.push_back({x.to_search(x.range.low), x.to_search(x.range.high)});
    start.push_back(x.to_search(model.effects[x.effect].values[x.parameter]));
  }
  Model trial = model;
  const auto set = [&](const std::vector<double>& at) {
    for (std::size_t i = 0; i < free.size(); ++i) {
      trial.effects[free[i].effect].values[free[i].parameter] = free[i].from_search(at[i]);
    }
  };
  const auto residuals_at = [&](const std::vector<double>& at) -> std::optional<Eigen::VectorXd> {
    set(at);
    const auto there = try_forecast(problem, trial);
    if (!there) return std::nullopt;
    return residuals(problem, *there);
  };
  LeastSquares found = least_squares(residuals_at, box, start, precision);
  if (!found.converged) {
    found.minimum = refine(
        [&](const std::vector<double>& at) {
          const auto left = residuals_at(at);
          return left ? std::min(left->squaredNorm(), no_tensions) : no_tensions;
        },
        box, found.minimum.at, evaluations * static_cast<int>(free.size() + 1));
  }
  set(found.minimum.at);
  return {std::move(trial), found.minimum.value};
}

Fit fit(const Problem& problem, const Model& model, std::size_t effect,
        const std::vector<std::vector<double>>& starts, Precision precision) {
  constexpr std::size_t refined = 2;
  std::vector<Fit> trials;
  for (const std::vector<double>& values : starts) {
    Model trial = model;
    trial.effects[effect].values = values;
    const double value = misfit(problem, trial);
    trials.push_back({std::move(trial), value});
  }
  if (trials.empty()) trials.push_back({model, misfit(problem, model)});
  std::ranges::stable_sort(trials, {}, &Fit::misfit);
  Fit best = fit(problem, trials.front().model, precision);
  if (parameter_count(model) == 0) return best;
  for (std::size_t i = 1; i < std::min(refined, trials.size()); ++i) {
    Fit other = fit(problem, trials[i].model, precision);
    if (other.misfit < best.misfit) best = std::move(other);
  }
  return best;
}

bool same_effect(const Effect& a, const Effect& b) {
  return is_about_the_same(a, b) && a.subject.actual == b.subject.actual;
}

std::size_t place(const Model& model, const Effect& effect) {
  std::size_t i = 0;
  while (!same_effect(model.effects[i], effect)) ++i;
  return i;
}

Extended extended(const Model& model, const Effect& effect) {
  Extended result{model, 0};
  add_effect(result.model, effect);
  result.effect = place(result.model, effect);
  return result;
}

Model without(Model model, std::size_t effect) {
  model.effects.erase(model.effects.begin() + static_cast<std::ptrdiff_t>(effect));
  return model;
}

}  // namespace reeve::diagnosis
