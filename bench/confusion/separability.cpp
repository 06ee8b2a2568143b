#include "bench/confusion/separability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "bench/confusion/planted_likelihood.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/search/calibration.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/least_squares.hpp"

namespace reeve::bench {
namespace {

using causes::Effect;
using causes::Model;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Found {
  Model model;
  double surprise = infinite;  // -ln L
};

bool is_likelier(const Found& a, const Found& b) { return a.surprise < b.surprise; }

class Fitting {
 public:
  Fitting(const PlantedLikelihood& likelihood, double force_scale)
      : likelihood_(likelihood), force_scale_(force_scale) {}

  double force_scale() const { return force_scale_; }

  double surprise(const Model& model) const {
    const auto e = likelihood_.residuals(model);
    return e ? e->squaredNorm() / 2 : infinite;
  }

  // All of the model's parameters, from where they stand.
  Found refined(Model model) const {
    std::vector<numerics::Interval> box;
    std::vector<double> start;
    for (const Effect& effect : model.effects) {
      const auto parameters =
          diagnosis::searched_parameters(*effect.cause, model.hardware, force_scale_);
      for (std::size_t p = 0; p < parameters.size(); ++p) {
        box.push_back({parameters[p].range.low, parameters[p].range.high});
        start.push_back(effect.values[p]);
      }
    }
    if (start.empty()) return {model, surprise(model)};
    const auto at = [&](const std::vector<double>& x) {
      std::size_t i = 0;
      for (Effect& effect : model.effects) {
        for (double& value : effect.values) value = x[i++];
      }
      return likelihood_.residuals(model);
    };
    const numerics::LeastSquares best = numerics::least_squares(at, box, start);
    at(best.minimum.at);
    return {model, best.minimum.value / 2};
  }

 private:
  const PlantedLikelihood& likelihood_;
  double force_scale_;
};

// Sizes from small to all that is searched, of either sign, for each shape of the law.
std::vector<std::vector<double>> starts(const Effect& candidate, double force_scale) {
  const auto parameters = diagnosis::searched_parameters(*candidate.cause, {}, force_scale);
  std::vector<std::vector<double>> result;
  for (const std::vector<double>& shape : diagnosis::shapes(candidate, parameters)) {
    if (shape.empty()) return {shape};
    const causes::Parameter& size = parameters.front();
    for (const double part : {0.7, 0.3, 0.1, 0.03, 0.01}) {
      for (const double end : {size.range.low, size.range.high}) {
        result.push_back(shape);
        result.back().front() = *size.nominal + part * (end - *size.nominal);
      }
    }
  }
  return result;
}

// With the candidate in the model; coefficients start where they are and as the hardware says. A
// model less likely than `near` after one refinement gets no other.
Found with(const Fitting& fitting, const Model& model, const Effect& candidate,
           double near = infinite) {
  constexpr std::size_t most = 3;
  std::vector<Found> tried;
  for (const Model& from : {model, diagnosis::with_hardware_coefficients(model)}) {
    for (const std::vector<double>& values : starts(candidate, fitting.force_scale())) {
      diagnosis::Extended trial = diagnosis::extended(from, candidate);
      trial.model.effects[trial.effect].values = values;
      const double surprise = fitting.surprise(trial.model);
      tried.push_back({std::move(trial.model), surprise});
    }
  }
  std::stable_sort(tried.begin(), tried.end(), is_likelier);
  Found best;
  for (std::size_t i = 0; i < std::min(most, tried.size()); ++i) {
    if (!(tried[i].surprise < infinite) || (i > 0 && best.surprise > near)) break;
    best = std::min(best, fitting.refined(tried[i].model), is_likelier);
  }
  return best;
}

class Separating {
 public:
  Separating(const Fitting& fitting, const std::vector<Effect>& candidates)
      : fitting_(fitting), candidates_(candidates) {
    for (const Effect& candidate : candidates) {
      if (is_open(candidate)) add_effect(free_, candidate);
    }
  }

  Separability from_others(const std::vector<std::string>& hidden) const {
    constexpr double far = 50;
    Model truth = free_;
    for (const std::string& name : hidden) truth = best_of(truth, name).model;
    const Found all = fitting_.refined(truth);
    Separability least{infinite, {}, infinite};
    for (const std::string& name : hidden) {
      Model rest = all.model;
      std::erase_if(rest.effects,
                    [&](const Effect& effect) { return effect_name(effect) == name; });
      const Found none = fitting_.refined(rest);
      rest = none.model;
      least.over_none = std::min(least.over_none, none.surprise - all.surprise);
      for (const Effect& other : candidates_) {
        if (has(all.model, effect_name(other))) continue;
        const double margin =
            with(fitting_, rest, other, all.surprise + far).surprise - all.surprise;
        if (margin >= least.margin) continue;
        least.margin = margin;
        least.nearest = effect_name(other);
      }
    }
    return least;
  }

 private:
  static bool is_open(const Effect& candidate) {
    return diagnosis::is_open_coefficient(candidate, {});
  }
  static bool has(const Model& model, const std::string& name) {
    return std::any_of(model.effects.begin(), model.effects.end(),
                       [&](const Effect& effect) { return effect_name(effect) == name; });
  }

  // Several wrong grasps bear one name.
  Found best_of(const Model& model, const std::string& name) const {
    Found best{model, infinite};
    if (has(model, name)) return fitting_.refined(model);
    for (const Effect& candidate : candidates_) {
      if (effect_name(candidate) != name) continue;
      best = std::min(best, with(fitting_, model, candidate), is_likelier);
    }
    return best;
  }

  const Fitting& fitting_;
  const std::vector<Effect>& candidates_;
  Model free_;
};

}  // namespace

std::optional<Separability> separability(const testing::Planted& planted,
                                         const diagnosis::MeasuredData& data) {
  const auto candidates =
      diagnosis::candidates(diagnosis::survey(data), {}, diagnosis::force_scale(data));
  std::vector<std::string> hidden;
  for (const testing::PlantedCause& cause : planted.causes) {
    const bool known =
        std::any_of(candidates.begin(), candidates.end(),
                    [&](const Effect& candidate) { return effect_name(candidate) == cause.name; });
    if (!known) return std::nullopt;
    hidden.push_back(cause.name);
  }
  if (hidden.empty()) return std::nullopt;
  std::vector<std::size_t> readings(data.readings.size());
  std::iota(readings.begin(), readings.end(), std::size_t{0});
  const diagnosis::Dataset dataset = diagnosis::dataset(data, readings);
  const PlantedLikelihood likelihood(planted, dataset);
  const Fitting fitting(likelihood, diagnosis::force_scale(data));
  return Separating(fitting, candidates).from_others(hidden);
}

}  // namespace reeve::bench
