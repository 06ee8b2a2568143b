#include "pages/closing_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/finger_guides.hpp"
#include "core/text.hpp"
#include "drawing/chart/chart.hpp"
#include "reports/hand_report.hpp"

namespace reeve::pages {
namespace {

chart::Polyline angles(const std::vector<FingerPosture>& postures, std::size_t joint,
                       const std::string& title) {
  chart::Polyline line{{}, title};
  for (const FingerPosture& posture : postures) {
    line.through.push_back({posture.excursion_mm, in_deg(posture.flexion_rad[joint])});
  }
  return line;
}

std::string angles_text(const ShownClosing& closing) {
  std::string text =
      fmt::format("Joint angles of {} over tendon excursion.", fingers_text(closing));
  const FingerPosture& last = closing.motion.closing.back();
  for (std::size_t j = 0; j < last.flexion_rad.size(); ++j) {
    text += fmt::format(" Joint {} ends at {}°.", j + 1, fixed(in_deg(last.flexion_rad[j]), 1));
  }
  return text;
}

Figure angle_figure(const ShownClosing& closing, std::size_t number) {
  chart::Panel panel;
  panel.x.title = "excursion, mm";
  panel.y.title = "flexion, °";
  for (std::size_t j = 0; j < closing.motion.closing.front().flexion_rad.size(); ++j) {
    const std::string name = fmt::format("joint {}", j + 1);
    chart::Style style;
    style.colour = chart::series_colour(j);
    panel.layers.push_back(
        {name, style, chart::Paths{{angles(closing.motion.closing, j, name + ", closing")}}});
    style.dash = chart::Dash::dashed;
    panel.layers.push_back(
        {"", style, chart::Paths{{angles(closing.motion.opening, j, name + ", opening")}}});
  }
  chart::Chart chart;
  chart.alt = angles_text(closing);
  chart.panels.push_back(std::move(panel));
  return {fmt::format("closing-{}", number),
          fmt::format("Joint angles of {} in free motion", fingers_text(closing)),
          "Solid: the tendon is drawn in; dashed: it is let out.", chart_svg(chart)};
}

// The finger's joints and tip, from the palm at 0, straight up with the hand open.
chart::Polyline skeleton(const ShownClosing& closing, const FingerPosture& posture) {
  chart::Polyline line{{{0, 0}}, ""};
  double bend = 0;
  Point at{0, 0};
  for (std::size_t j = 0; j < posture.flexion_rad.size(); ++j) {
    bend += posture.flexion_rad[j];
    // Phalanges without a length are drawn alike.
    const double length = closing.joints[j].phalanx_mm.value_or(30);
    at = {at.x + length * std::sin(bend), at.y + length * std::cos(bend)};
    line.through.push_back(at);
  }
  return line;
}

Figure posture_figure(const ShownClosing& closing, std::size_t number) {
  constexpr std::size_t stride = 4;
  double reach = 0;
  for (const FingerJoint& joint : closing.joints) reach += joint.phalanx_mm.value_or(30);
  chart::Chart chart;
  chart.alt = fmt::format("Postures of {} at equal steps of excursion.", fingers_text(closing));
  chart.columns = 6;
  chart.width = 130;
  chart.height = 130;
  for (std::size_t i = 0; i < closing.motion.closing.size(); i += stride) {
    const FingerPosture& posture = closing.motion.closing[i];
    const chart::Polyline line = skeleton(closing, posture);
    chart::Points joints;
    for (const Point& point : line.through) joints.spots.push_back({point.x, point.y, "", ""});
    chart::Panel panel;
    panel.title = fmt::format("{} mm", fixed(posture.excursion_mm, 1));
    panel.one_scale = true;
    panel.x.hidden = true;
    panel.y.hidden = true;
    panel.x.reaches = {-reach, reach};
    panel.y.reaches = {-reach, reach};
    panel.layers.push_back({"", {}, chart::Paths{{line}}});
    panel.layers.push_back({"", {}, joints});
    chart.panels.push_back(std::move(panel));
  }
  return {fmt::format("postures-{}", number),
          fmt::format("Postures of {} in the closing", fingers_text(closing)),
          "Straight up: the open finger. Above each: the excursion of the tendon.",
          chart_svg(chart)};
}

}  // namespace

std::vector<Figure> closing_figures(const ShownClosing& closing, std::size_t number) {
  return {angle_figure(closing, number), posture_figure(closing, number)};
}

}  // namespace reeve::pages
