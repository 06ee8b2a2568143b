#include "drawing/chart/chart_labels.hpp"

#include <algorithm>
#include <array>

namespace reeve::drawing::chart {
namespace {

constexpr double gap = 3;  // between a mark and its text, and between two texts
constexpr std::array<double, 5> rings{0, 12, 26, 44, 66};

bool overlap(const Box& a, const Box& b, double apart) {
  return a.left < b.right + apart && b.left < a.right + apart && a.top < b.bottom + apart &&
         b.top < a.bottom + apart;
}

bool within(const Box& box, const Box& frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
         box.bottom <= frame.bottom;
}

// Where a text can stand as seen from its mark: -1, 0 or 1 in x and in y. Right before left, since
// texts are read from there.
constexpr std::array<Point, 8> sides{
    {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};

Box beside(const WantedLabel& label, Point side, double away) {
  const double reach = label.radius + gap + away;
  // Diagonally the corner of the text is near, not its side.
  const double share = side.x != 0 && side.y != 0 ? 0.7 : 1;
  const double x = label.at.x + side.x * (share * reach + label.width / 2);
  const double y = label.at.y + side.y * (share * reach + label.height / 2);
  return {x - label.width / 2, y - label.height / 2, x + label.width / 2, y + label.height / 2};
}

std::size_t covered(const Box& box, const std::vector<Box>& marks) {
  return static_cast<std::size_t>(std::count_if(
      marks.begin(), marks.end(), [&](const Box& mark) { return overlap(box, mark, 0); }));
}

std::optional<PlacedLabel> best_place(const WantedLabel& label, const std::vector<Box>& marks,
                                      const std::vector<Box>& taken, const Box& frame) {
  std::optional<PlacedLabel> best;
  std::size_t fewest = 0;
  for (const double ring : rings) {
    for (const Point& side : sides) {
      const Box box = beside(label, side, ring);
      const auto in_the_way = [&](const Box& other) { return overlap(box, other, gap); };
      if (!within(box, frame) || std::any_of(taken.begin(), taken.end(), in_the_way)) continue;
      const std::size_t covers = covered(box, marks);
      if (best && covers >= fewest) continue;
      best = PlacedLabel{box, ring > 0};
      fewest = covers;
      if (covers == 0) return best;
    }
  }
  return best;
}

}  // namespace

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<WantedLabel>& wanted,
                                                     const std::vector<Box>& marks,
                                                     const Box& frame) {
  std::vector<std::optional<PlacedLabel>> placed;
  std::vector<Box> taken;
  for (const WantedLabel& label : wanted) {
    placed.push_back(best_place(label, marks, taken, frame));
    if (placed.back()) taken.push_back(placed.back()->box);
  }
  return placed;
}

}  // namespace reeve::drawing::chart
