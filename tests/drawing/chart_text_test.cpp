#include "drawing/chart/chart_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "numerics/random.hpp"

namespace reeve::drawing::chart {
namespace {

const Box frame{0, 0, 300, 200};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Box around(Point at, double radius) {
  return {at.x - radius, at.y - radius, at.x + radius, at.y + radius};
}

TEST(ChartLabels, LieToTheRightOfTheirMarkIfThereIsRoom) {
  const auto placed = place_labels({{{100, 100}, 4, 40, 15}}, {around({100, 100}, 4)}, frame);
  ASSERT_TRUE(placed.front());
  EXPECT_NEAR(placed.front()->box.left, 107, 1e-9);
  EXPECT_NEAR((placed.front()->box.top + placed.front()->box.bottom) / 2, 100, 1e-9);
  EXPECT_FALSE(placed.front()->needs_leader);
}

TEST(ChartLabels, LieToTheLeftAtTheRightEdge) {
  const auto placed = place_labels({{{290, 100}, 4, 40, 15}}, {}, frame);
  ASSERT_TRUE(placed.front());
  EXPECT_NEAR(placed.front()->box.right, 283, 1e-9);
}

TEST(ChartLabels, LeaveOtherMarksVisible) {
  const auto placed = place_labels({{{100, 100}, 4, 40, 15}}, {around({130, 100}, 4)}, frame);
  ASSERT_TRUE(placed.front());
  EXPECT_FALSE(overlap(placed.front()->box, around({130, 100}, 4)));
}

TEST(ChartLabels, CoverMarksRatherThanLoseAName) {
  std::vector<Box> everywhere;
  for (int x = 0; x <= 300; x += 10) {
    for (int y = 0; y <= 200; y += 10) everywhere.push_back(around({1.0 * x, 1.0 * y}, 4));
  }
  EXPECT_TRUE(place_labels({{{100, 100}, 4, 40, 15}}, everywhere, frame).front());
}

TEST(ChartLabels, AreLeftOutWhereNothingFits) {
  EXPECT_FALSE(place_labels({{{150, 100}, 4, 400, 15}}, {}, frame).front());
}

TEST(ChartLabels, NeverLieOverEachOtherNorBeyondTheFrame) {
  std::size_t placed_in_all = 0;
  std::size_t with_leader = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::vector<WantedLabel> wanted;
    std::vector<Box> marks;
    const auto count = static_cast<std::size_t>(1 + 24 * uniform(seed, 1, 0));
    for (std::size_t i = 0; i < count; ++i) {
      const Point at{300 * uniform(seed, 2, i), 200 * uniform(seed, 3, i)};
      marks.push_back(around(at, 4));
      wanted.push_back({at, 4, 20 + 60 * uniform(seed, 4, i), 15});
    }
    std::vector<Box> boxes;
    for (const auto& label : place_labels(wanted, marks, frame)) {
      if (!label) continue;
      const Box& box = label->box;
      EXPECT_TRUE(box.left >= 0 && box.right <= 300 && box.top >= 0 && box.bottom <= 200) << seed;
      for (const Box& other : boxes) EXPECT_FALSE(overlap(box, other)) << seed;
      boxes.push_back(box);
      with_leader += label->needs_leader ? 1U : 0U;
    }
    placed_in_all += boxes.size();
    if (count <= 8) {
      EXPECT_EQ(boxes.size(), count) << seed;  // few find room
    }
  }
  EXPECT_GT(placed_in_all, 3000U);  // the checks above looked at something
  EXPECT_GT(with_leader, 0U);
}

}  // namespace
}  // namespace reeve::drawing::chart
