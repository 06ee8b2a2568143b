#include "pages/figure_captions.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/version.hpp"
#include "pages/routing_labels.hpp"

namespace reeve::pages {
namespace {

std::string computed() {
  return fmt::format("computed with reeve {}, not measured", version().number);
}

std::string captioned_routing(const ShownRouting& report) {
  return report.name.empty() ? report.word : fmt::format("{} ({})", report.name, report.word);
}

// What differs at one finger; its joints are no friction.
std::string finger_text(const FingerHardware& finger) {
  std::string text;
  const auto add = [&](const char* what, const std::optional<double>& value, const char* unit) {
    if (!value) return;
    text += fmt::format("{}{} {:.4g}{}", text.empty() ? "" : ", ", what, *value, unit);
  };
  add("tip", finger.tip_mu, "");
  add("tip", finger.tip_angle_rad, " rad");
  add("sheaths", finger.sheath_mu, "");
  add("sheaths", finger.sheath_angle_rad, " rad");
  return text.empty() ? "" : fmt::format("; finger {}: {}", finger.finger, text);
}

}  // namespace

std::string coefficients_text(const Model& model) {
  const Hardware& hardware = model.hardware;
  std::string text = fmt::format(
      "friction coefficients of {:.4g} (tubes), {:.4g} (sheaths) and {:.4g} (bearings), wraps of "
      "{:.4g} rad (tubes) and {:.4g} rad (sheaths, in all)",
      hardware.tube.mu, hardware.sheath.mu, hardware.bearing.mu, hardware.tube.angle_rad,
      hardware.sheath.angle_rad);
  for (const FingerHardware& finger : hardware.fingers) text += finger_text(finger);
  if (!hardware.contacts.empty()) {
    text += fmt::format(", others at {} contact{}", hardware.contacts.size(),
                        hardware.contacts.size() == 1 ? "" : "s");
  }
  if (!model.effects.empty()) {
    text += fmt::format(
        ", and {} of a model beyond plain friction",
        model.effects.size() == 1 ? "an effect" : fmt::format("{} effects", model.effects.size()));
  }
  return text;
}

std::string schematic_caption(const ShownRouting& report, const ShownGrasp& shown) {
  const char* verb = report.direction == Direction::pull ? "pulling" : "releasing";
  return fmt::format(
      "Routing {} with {}, the carriage {}{}: simulated tensions in newton per newton of motor "
      "tension, and which way the tendon slides at each contact, with {}; {}.\n",
      captioned_routing(report), grasp_words(shown.grasp), verb,
      shown.state.jams ? " (it jams)" : "", coefficients_text(report.model), computed());
}

FigureFile captioned(const Figure& figure, const Model& model) {
  std::string what = figure.title;
  while (!what.empty() && what.back() == '.') what.pop_back();
  std::string caption =
      fmt::format("{}: simulated, with {}; {}.", what, coefficients_text(model), computed());
  if (!figure.caption.empty()) caption += " " + figure.caption;
  return {figure.id, figure.svg, caption + "\n"};
}

}  // namespace reeve::pages
