// Horizontal places of fittings: no others that keep all distances cost less.
#include "drawing/schematic/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "drawing/schematic/places.hpp"
#include "tests/support/random_rigging.hpp"

namespace reeve {
namespace {

// An arrangement in the order of a drawing of it.
struct Arranged {
  Network network;
  Fittings all;
  Ranks ranks;
  Lanes lanes;
  Heights heights;
  std::vector<Strip> strips;

  explicit Arranged(const Routing& routing) : network(expand(routing)), all(fittings(network)) {
    const Places drawn = places_in_levels(network, all);
    all = drawn.fittings;
    for (const Point& port : drawn.ports) ranks.push_back(port.x);
    lanes = drawing::lanes(all, ranks);
    heights = drawing::heights(network, all, lanes);
    strips = drawing::strips(network, all, lanes, heights, ranks);
  }

  // Infinite if two strips are too close.
  double cost(const std::vector<double>& x) const {
    double left = infinity;
    double right = -infinity;
    for (const Strip& a : strips) {
      left = std::min(left, x[a.fitting] - std::ceil(-a.left));
      right = std::max(right, x[a.fitting] + std::ceil(a.right));
      for (const Strip& b : strips) {
        const bool ordered = a.fitting != b.fitting && a.rank < b.rank;
        const bool beside = a.top + 0.01 <= b.bottom && b.top + 0.01 <= a.bottom &&
                            a.bottom - a.top >= 0.01 && b.bottom - b.top >= 0.01;
        const bool one_line = a.segment != nowhere && a.segment == b.segment && a.rises != b.rises;
        const double gap = x[b.fitting] + b.left - x[a.fitting] - a.right;
        if (ordered && beside && !one_line && gap < 0) return infinity;
      }
    }
    double sum = (right - left) / 4;
    for (const LaneStretch& stretch : lanes.stretches) {
      const Columns columns{x};
      sum +=
          std::abs(column(all, columns, stretch.port[0]) - column(all, columns, stretch.port[1]));
    }
    return sum;
  }
};

// The cost is convex over whole numbers (L-natural). So places are best if no set of fittings that
// moves by a pixel lowers it.
void expect_no_set_to_gain(const Arranged& arranged, const std::vector<double>& x,
                           const std::vector<std::size_t>& columns) {
  const double cost = arranged.cost(x);
  for (std::size_t set = 0; set < std::size_t{1} << columns.size(); ++set) {
    for (const double step : {-1.0, 1.0}) {
      std::vector<double> moved = x;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if ((set >> i) % 2 == 1) moved[columns[i]] += step;
      }
      ASSERT_GE(arranged.cost(moved), cost);
    }
  }
}

TEST(Columns, OfRandomRoutingsAreTheBest) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 150 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Arranged arranged(testing::random_rigging(dice, {3, 2}));
    const auto found = columns(arranged.all, arranged.lanes, arranged.strips, infinity);
    std::set<std::size_t> own;
    for (const Strip& strip : arranged.strips) own.insert(strip.fitting);
    if (!found || own.size() > 9) continue;
    const double cost = arranged.cost(found->middle);
    EXPECT_GE(cost, found->cost) << seed;
    EXPECT_LT(cost, infinity) << seed;
    if (cost > found->cost) continue;  // small steps were straightened
    expect_no_set_to_gain(arranged, found->middle, {own.begin(), own.end()});
    EXPECT_FALSE(columns(arranged.all, arranged.lanes, arranged.strips, cost)) << seed;
    ++compared;
  }
  EXPECT_GE(compared, 60);
}

}  // namespace
}  // namespace reeve
