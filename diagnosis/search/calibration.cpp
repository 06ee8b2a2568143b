#include "diagnosis/search/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

// Rigs are mostly smoother than they are thought; one may be rougher.
constexpr std::array starts{1.0, 0.3, 2.5};
// Of the range that is searched, a standard error beyond which nothing is known.
constexpr double vague = 1.0 / 6;

const ContactLaw& law_of(const Effect& effect, const Hardware& hardware) {
  const std::string name = effect.cause->name();
  if (name == "tube_friction") return hardware.tube;
  return name == "sheath_friction" ? hardware.sheath : hardware.bearing;
}

// The first effect of which the data say too little; the number of effects if there is none.
std::size_t first_vague(const Problem& problem, const Model& model) {
  const auto intervals = parameter_intervals(problem, model);
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    if (!is_coefficient(model.effects[e])) continue;
    const Range range = model.effects[e].cause->parameters(model.hardware).front().range;
    if (!(intervals[e].front().deviation <= vague * (range.high - range.low))) return e;
  }
  return model.effects.size();
}

Model from_each_start(const Problem& problem, const Model& model) {
  Fit best;
  for (const double part : starts) {
    Model start = model;
    for (Effect& effect : start.effects) {
      const Range range = effect.cause->parameters(model.hardware).front().range;
      effect.values.front() = std::min(part * effect.values.front(), range.high);
    }
    Fit fitted = fit(problem, start);
    if (best.model.effects.empty() || fitted.misfit < best.misfit) best = std::move(fitted);
  }
  return best.model;
}

}  // namespace

bool is_coefficient(const Effect& effect) {
  return effect.cause->reach() == Reach::hardware &&
         effect.cause->subject_kind() == SubjectKind::rig;
}

bool is_open(const Effect& effect, const Hardware& hardware) {
  const ContactLaw& law = law_of(effect, hardware);
  return !law.known && law.mu > 0;
}

Model with_hardware_coefficients(Model model) {
  for (Effect& effect : model.effects) {
    if (!is_coefficient(effect)) continue;
    effect.values.front() = *effect.cause->parameters(model.hardware).front().nominal;
  }
  return model;
}

Model calibrated(const Problem& problem, const Model& nominal,
                 const std::vector<Candidate>& candidates) {
  Model model = nominal;
  for (const Candidate& candidate : candidates) {
    if (is_coefficient(candidate.effect) && is_open(candidate.effect, nominal.hardware)) {
      add_effect(model, candidate.effect);
    }
  }
  if (model.effects.empty()) return model;
  const Model open = model;
  model = from_each_start(problem, open);
  for (std::size_t e = first_vague(problem, model); e < model.effects.size();
       e = first_vague(problem, model)) {
    model = without(model, e);
    if (!model.effects.empty()) model = fit(problem, model).model;
  }
  return model;
}

std::vector<Calibration> calibrations(const Problem& problem, const Model& model,
                                      double mounting_degrees) {
  const auto intervals = parameter_intervals(problem, model, mounting_degrees);
  std::vector<Calibration> result;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    if (!is_coefficient(model.effects[e])) continue;
    result.push_back({model.effects[e], intervals[e].front(), 1, 0});
  }
  const double now = misfit(problem, model);
  for (Calibration& found : result) {
    const double nominal = *found.effect.cause->parameters(model.hardware).front().nominal;
    const double off = std::abs(found.effect.values.front() - nominal);
    const double chance = two_sided_p_value(off / found.interval.deviation, found.interval.degrees);
    found.p_value = std::min(1.0, chance * static_cast<double>(result.size()));
    const Fit pinned = fit(problem, without(model, place(model, found.effect)));
    found.gain = (pinned.misfit - now) / 2;
  }
  return result;
}

}  // namespace reeve::diagnosis
