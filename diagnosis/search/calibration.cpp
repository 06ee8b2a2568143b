#include "diagnosis/search/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "diagnosis/fit/evidence.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

// Rigs are mostly smoother than they are thought; one may be rougher.
constexpr std::array starts{1.0, 0.3, 2.5};
// Share of the searched range: with a greater standard error the value is unknown.
constexpr double vague = 1.0 / 6;

// The first effect of which the data say too little; the number of effects if there is none.
std::size_t first_vague(const Problem& problem, const Model& model) {
  const auto intervals = parameter_intervals(problem, model);
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Range range = model.effects[e].cause->parameters(model.hardware).front().range;
    if (!(intervals[e].front().deviation <= vague * (range.high - range.low))) return e;
  }
  return model.effects.size();
}

Model from_each_start(const Problem& problem, const Model& model, Workers& workers) {
  std::array<Fit, starts.size()> fits;
  workers.for_each_block(starts.size(), 1, [&](const IndexBlock& block) {
    const double part = starts[block.begin];
    Model start = model;
    for (Effect& effect : start.effects) {
      const Range range = effect.cause->parameters(model.hardware).front().range;
      effect.values.front() = std::min(part * effect.values.front(), range.high);
    }
    fits[block.begin] = fit(problem, start);
  });
  const auto best = std::ranges::min_element(fits, {}, &Fit::misfit);
  return best->model;
}

}  // namespace

bool is_open_coefficient(const Effect& effect, const Hardware& hardware) {
  const ContactLaw* law = effect.cause->law(hardware);
  return law != nullptr && !law->known && law->mu > 0;
}

Model with_hardware_coefficients(Model model) {
  for (Effect& effect : model.effects) {
    if (!is_open_coefficient(effect, model.hardware)) continue;
    effect.values.front() = *effect.cause->parameters(model.hardware).front().nominal;
  }
  return model;
}

Model calibrated(const Problem& problem, const Model& nominal,
                 const std::vector<Effect>& coefficients, Workers& workers) {
  Model model = nominal;
  for (const Effect& coefficient : coefficients) add_effect(model, coefficient);
  if (model.effects.empty()) return model;
  model = from_each_start(problem, model, workers);
  for (std::size_t e = first_vague(problem, model); e < model.effects.size();
       e = first_vague(problem, model)) {
    model = without(model, e);
    if (!model.effects.empty()) model = fit(problem, model).model;
  }
  return model;
}

std::vector<Calibration> calibrations(const Problem& problem, const Model& model,
                                      double mounting_degrees, double alpha) {
  const auto intervals = parameter_intervals(problem, model, mounting_degrees);
  std::vector<Calibration> result;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    if (!is_open_coefficient(model.effects[e], model.hardware)) continue;
    result.push_back({model.effects[e], intervals[e].front(), 1, 0, false});
  }
  const double now = misfit(problem, model);
  for (Calibration& found : result) {
    const double nominal = *found.effect.cause->parameters(model.hardware).front().nominal;
    const double off = std::abs(found.effect.values.front() - nominal);
    const double chance = two_sided_p_value(off / found.interval.deviation, found.interval.degrees);
    found.p_value = std::min(1.0, chance * static_cast<double>(result.size()));
    const Fit pinned = fit(problem, without(model, place(model, found.effect)));
    found.gain = (pinned.misfit - now) / 2;
    found.differs = found.p_value < alpha && found.gain >= least_evidence;
  }
  return result;
}

}  // namespace reeve::diagnosis
