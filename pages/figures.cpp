#include "pages/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "core/version.hpp"

namespace reeve::pages {
namespace {

// With the grasp and the ending a name has to stay below 255 bytes; words of many fingers are long.
constexpr std::size_t longest_stem = 120;

std::string safe(const std::string& label) {
  std::string stem;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = byte < 0x80 && (std::isalnum(byte) != 0 || c == '-');
    if (stays) {
      stem += c;
    } else if (stem.empty() || stem.back() != '_') {
      stem += '_';
    }
  }
  // A name that begins with '-' is taken for an option by every program that reads the file.
  if (stem.empty() || stem.front() == '-') stem.insert(stem.begin(), '_');
  if (stem.size() > longest_stem) stem.resize(longest_stem);
  return stem;
}

std::string folded(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

std::string computed() {
  return fmt::format("computed with reeve {}, not measured", version().number);
}

std::string captioned_routing(const SolvedRouting& report) {
  return report.is_named() ? fmt::format("{} ({})", report.name, report.word) : report.word;
}

// Describes the own values of one finger; its joints are no friction.
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

std::vector<std::string> file_stems(const std::vector<NamedRouting>& routings) {
  std::set<std::string> taken{"tensions", "figure-9"};  // charts with grasps in their names
  std::vector<std::string> stems;
  for (const std::string& label : labels(routings)) {
    const std::string wanted = safe(label);
    std::string stem = wanted;
    for (int number = 2; !taken.insert(folded(stem)).second; ++number) {
      stem = fmt::format("{}-{}", wanted, number);
    }
    stems.push_back(stem);
  }
  return stems;
}

std::string schematic_name(const std::string& stem, Grasp grasp) {
  return stem + "-" + grasp_id(grasp);
}

std::string coefficients_text(const Model& model) {
  const Hardware& hardware = model.hardware;
  std::string text = fmt::format(
      "friction coefficients of {:.4g} (tubes), {:.4g} (sheaths) and {:.4g} (bearings), wraps of "
      "{:.4g} rad (tubes) and {:.4g} rad (sheaths, in all)",
      hardware.tube.mu, hardware.sheath.mu, hardware.bearing.mu, hardware.tube.angle_rad,
      hardware.sheath.whole_angle_rad());
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

std::string schematic_caption(const SolvedRouting& report, const ShownGrasp& shown) {
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
