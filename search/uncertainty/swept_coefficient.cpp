#include "search/uncertainty/swept_coefficient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::search {
namespace {

constexpr std::array<CoefficientRow, 5> coefficients{{
    {Coefficient::mu, "mu", "friction coefficient of tubes and sheaths alike", "", 1},
    {Coefficient::tube_mu, "tube_mu", "friction coefficient of the tubes", "", 1},
    {Coefficient::sheath_mu, "sheath_mu", "friction coefficient of the sheaths", "", 1},
    {Coefficient::bearing_mu, "bearing_mu", "friction coefficient of the bearings", "", 1},
    {Coefficient::sheath_angle, "sheath_angle", "wrap angle of the sheaths", "rad", 50},
}};

InputError no_sweep(const std::string& text, const std::string& expected) {
  return InputError({.what = "sweep", .value = text, .expected = expected});
}

std::string coefficient_names() {
  std::string names;
  for (const CoefficientRow& about : coefficients) {
    names += (names.empty() ? "" : ", ") + std::string(about.name);
  }
  return names;
}

bool sets_tubes(Coefficient coefficient) {
  return coefficient == Coefficient::mu || coefficient == Coefficient::tube_mu;
}

bool sets_sheaths(Coefficient coefficient) {
  return coefficient == Coefficient::mu || coefficient == Coefficient::sheath_mu;
}

bool would_replace(const Effect& effect, Coefficient coefficient) {
  const std::string_view name = effect.cause->name();
  return (name == "tube_friction" && sets_tubes(coefficient)) ||
         (name == "sheath_friction" && sets_sheaths(coefficient)) ||
         (name == "bearing_friction" && coefficient == Coefficient::bearing_mu);
}

}  // namespace

const CoefficientRow& row(Coefficient coefficient) {
  return coefficients[static_cast<std::size_t>(coefficient)];
}

CoefficientRange parse_sweep(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = trimmed(std::string_view(text).substr(0, equals));
  const auto* about =
      std::find_if(coefficients.begin(), coefficients.end(),
                   [&](const CoefficientRow& candidate) { return name == candidate.name; });
  if (about == coefficients.end()) {
    throw no_sweep(
        text, fmt::format("one of {}, and its range, such as mu=0.02..0.3", coefficient_names()));
  }
  const std::string_view range = std::string_view(text).substr(std::min(equals + 1, text.size()));
  const std::size_t dots = range.find("..");
  if (dots != std::string_view::npos) {
    const auto low = number_in(trimmed(range.substr(0, dots)));
    const auto high = number_in(trimmed(range.substr(dots + 2)));
    if (low && high && *low >= 0 && *low < *high && *high <= about->greatest) {
      return {about->coefficient, {*low, *high}};
    }
  }
  throw no_sweep(text, fmt::format("{}= and a lesser and a greater number from 0 to {}{}{} with "
                                   ".. between them, such as mu=0.02..0.3",
                                   about->name, about->greatest, *about->unit == '\0' ? "" : " ",
                                   about->unit));
}

Model at_coefficient(Model model, Coefficient coefficient, double value) {
  Hardware& hardware = model.hardware;
  if (sets_tubes(coefficient)) hardware.tube.mu = value;
  if (sets_sheaths(coefficient)) hardware.sheath.mu = value;
  if (coefficient == Coefficient::bearing_mu) {
    // Of blocks of which the file gives the wrap alone.
    if (hardware.block && hardware.block->mu == hardware.bearing.mu) hardware.block->mu = value;
    hardware.bearing.mu = value;
  }
  if (coefficient == Coefficient::sheath_angle) hardware.sheath.angle_rad = value;
  std::erase_if(model.effects,
                [&](const Effect& effect) { return would_replace(effect, coefficient); });
  return model;
}

}  // namespace reeve::search
