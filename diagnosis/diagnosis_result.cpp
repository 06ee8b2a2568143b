#include "diagnosis/diagnosis_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "diagnosis/fit/fit.hpp"

namespace reeve::diagnosis {

std::string grasps_text(const Subject& subject) {
  if (!subject.recorded || !subject.actual) return {};
  return "recorded " + to_text(*subject.recorded) + ", measured " + to_text(*subject.actual);
}

NamedCause named_cause(const Effect& effect, double p_value) {
  NamedCause cause;
  cause.effect = effect;
  cause.name = effect_name(effect);
  cause.p_value = p_value;
  return cause;
}

EstimatedParameter estimated(const Effect& effect, std::size_t p, const ParameterInterval& interval,
                             const Hardware& hardware, double force_scale) {
  const Parameter parameter = searched_parameters(*effect.cause, hardware, force_scale)[p];
  const bool at_bound = !parameter.ends_by_nature && (interval.low <= parameter.range.low ||
                                                      interval.high >= parameter.range.high);
  return {parameter.name, parameter.unit,    effect.values[p],     interval.low,
          interval.high,  parameter.nominal, parameter.literature, at_bound};
}

// Readings tell the exponent of a sheath: its coefficient is only as right as its bend.
std::string sheath_exponent(const EstimatedParameter& mu, double angle_rad) {
  constexpr double degrees_in_rad = 180 / std::numbers::pi;
  const double half = (mu.high - mu.low) / 2 * angle_rad;
  const int places = static_cast<int>(std::clamp(std::ceil(-std::log10(half)), 0.0, 6.0));
  return fmt::format("mu theta = {:.{}f} ({:.{}f} to {:.{}f}) over a bend of {:.4g} deg",
                     mu.value * angle_rad, places, mu.low * angle_rad, places, mu.high * angle_rad,
                     places, angle_rad * degrees_in_rad);
}

void describe(std::vector<NamedCause>& causes, const Model& model, const Hardware& hardware,
              const std::vector<std::vector<ParameterInterval>>& intervals, double force_scale,
              bool bends_are_recorded) {
  for (NamedCause& cause : causes) {
    const std::size_t e = place(model, cause.effect);
    cause.effect = model.effects[e];
    cause.meaning = cause.effect.cause->meaning();
    cause.detail = grasps_text(cause.effect.subject);
    for (std::size_t p = 0; p < cause.effect.values.size(); ++p) {
      cause.parameters.push_back(
          estimated(cause.effect, p, intervals[e][p], hardware, force_scale));
    }
    if (cause.name == "sheath_friction" && !bends_are_recorded) {
      cause.detail = sheath_exponent(cause.parameters.front(), hardware.sheath.whole_angle_rad());
    }
  }
}

const char* verdict_name(Verdict verdict) {
  constexpr std::array names{"none", "cause", "unexplained", "indistinguishable", "too_few"};
  return names[static_cast<std::size_t>(verdict)];
}

}  // namespace reeve::diagnosis
