#include "drawing/chart/chart_mark_labels.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/chart/chart_labels.hpp"

namespace reeve::drawing::chart {
namespace {

constexpr double widest = 0.45;  // of the frame

struct Wanted {
  std::vector<WantedLabel> labels;
  std::vector<ChartText> texts;
  std::vector<Box> marks;
};

void want(const std::string& text, Point at, double radius, const Box& frame, Wanted& wanted) {
  const ChartText shown =
      cut(text, small_text, Weight::normal, widest * (frame.right - frame.left));
  wanted.labels.push_back(
      {at, radius, measures::text_width(shown.drawn.text, small_text, false), line_of(small_text)});
  wanted.texts.push_back(shown);
}

void add_points(const LaidPanel& panel, const Layer& layer, const Points& points, Wanted& wanted) {
  const double radius = layer.style.size;
  for (const Spot& spot : points.spots) {
    if (!can_be_drawn(spot.x) || !can_be_drawn(spot.y)) continue;
    const Point at = place(panel, spot.x, spot.y);
    wanted.marks.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
    if (!spot.label.empty()) want(spot.label, at, radius, panel.frame, wanted);
  }
}

// Just inside the frame, at the end where the rule leaves it.
void add_rules(const LaidPanel& panel, const Rules& rules, Wanted& wanted) {
  const double inside = line_of(small_text) / 2 + 2;
  for (const Level& rule : rules.rules) {
    if (!can_be_drawn(rule.at) || rule.label.empty()) continue;
    const Point at = rules.on == Along::x
                         ? Point{place(panel.x.scale, rule.at), panel.frame.top + inside}
                         : Point{panel.frame.right - inside, place(panel.y.scale, rule.at)};
    want(rule.label, at, 1, panel.frame, wanted);
  }
}

// Where the line from the mark meets the text's box, and where it leaves the mark.
LaidLabel laid(ChartText text, const WantedLabel& wanted, const PlacedLabel& placed) {
  const Box& box = placed.box;
  text.drawn.box = box;
  LaidLabel label{std::move(text), placed.needs_leader, wanted.at, {}};
  label.to = {std::clamp(wanted.at.x, box.left, box.right),
              std::clamp(wanted.at.y, box.top, box.bottom)};
  const double length = std::hypot(label.to.x - wanted.at.x, label.to.y - wanted.at.y);
  if (length > 0) {
    const double share = std::min(1.0, (wanted.radius + 1) / length);
    label.from = {wanted.at.x + share * (label.to.x - wanted.at.x),
                  wanted.at.y + share * (label.to.y - wanted.at.y)};
  }
  return label;
}

}  // namespace

std::vector<LaidLabel> mark_labels(const LaidPanel& panel) {
  Wanted wanted;
  for (const Layer& layer : panel.panel->layers) {
    if (const auto* points = std::get_if<Points>(&layer.marks)) {
      add_points(panel, layer, *points, wanted);
    } else if (const auto* rules = std::get_if<Rules>(&layer.marks)) {
      add_rules(panel, *rules, wanted);
    }
  }
  const auto placed = place_labels(wanted.labels, wanted.marks, panel.frame);
  std::vector<LaidLabel> labels;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (placed[i]) labels.push_back(laid(wanted.texts[i], wanted.labels[i], *placed[i]));
  }
  return labels;
}

}  // namespace reeve::drawing::chart
