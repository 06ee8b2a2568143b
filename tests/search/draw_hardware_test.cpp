// The model of one draw.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/search/uncertain.hpp"

namespace reeve {
namespace {

using testing::options_for;

std::vector<double> drawn(const Hardware& hardware) {
  return {hardware.tube.mu, hardware.sheath.mu, hardware.bearing.mu, hardware.sheath.angle_rad};
}

TEST(DrawHardware, StaysWithinItsRangesAndFillsThem) {
  UncertaintyOptions options = options_for(1);
  options.nominal.hardware.bearing.mu = 0.002;
  const double angle = options.nominal.hardware.sheath.angle_rad;
  const std::vector<double> low{0.05, 0.05, 0.001, 0.8 * angle};
  const std::vector<double> high{0.20, 0.20, 0.003, 1.2 * angle};
  std::vector<double> least = high;
  std::vector<double> most = low;
  for (std::uint64_t draw = 0; draw < 2000; ++draw) {
    const std::vector<double> quantities = drawn(draw_model(options, draw).hardware);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      EXPECT_GE(quantities[q], low[q] * (1 - 1e-12));
      EXPECT_LE(quantities[q], high[q] * (1 + 1e-12));
      least[q] = std::min(least[q], quantities[q]);
      most[q] = std::max(most[q], quantities[q]);
    }
  }
  for (std::size_t q = 0; q < low.size(); ++q) {
    EXPECT_LT(least[q], low[q] + 0.01 * (high[q] - low[q])) << q;
    EXPECT_GT(most[q], high[q] - 0.01 * (high[q] - low[q])) << q;
  }
}

TEST(DrawHardware, DrawsTheQuantitiesIndependentlyOfEachOther) {
  const UncertaintyOptions options = options_for(1);
  constexpr int draws = 4000;
  std::vector<int> above(16, 0);
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    const std::vector<double> quantities = drawn(draw_model(options, draw).hardware);
    const std::vector<double> middle{0.125, 0.125, options.nominal.hardware.bearing.mu,
                                     options.nominal.hardware.sheath.angle_rad};
    std::size_t corner = 0;
    for (std::size_t q = 0; q < 4; ++q) corner = 2 * corner + (quantities[q] > middle[q] ? 1 : 0);
    ++above[corner];
  }
  // 250 in each of the 16 corners, give or take five standard deviations.
  for (const int count : above) EXPECT_NEAR(count, draws / 16, 80);
}

TEST(DrawHardware, IsAFunctionOfSeedAndNumberAlone) {
  const UncertaintyOptions options = options_for(10);
  UncertaintyOptions others = options_for(5000);
  others.threads = 8;
  others.order = {Objective::sheaths};
  others.grasps = paper_grasps();
  for (const std::uint64_t draw : {9U, 3U, 0U, 3U}) {
    EXPECT_EQ(drawn(draw_model(options, draw).hardware), drawn(draw_model(others, draw).hardware));
  }
}

TEST(DrawHardware, OtherSeedsAndNumbersDrawOtherHardware) {
  std::set<double> tubes;
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL, 1ULL << 32, (1ULL << 32) + 1}) {
    UncertaintyOptions options = options_for(1);
    options.seed = seed;
    for (const std::uint64_t draw : {0ULL, 1ULL, 2ULL, 1ULL << 32}) {
      tubes.insert(draw_model(options, draw).hardware.tube.mu);
    }
  }
  EXPECT_EQ(tubes.size(), 20U);
}

TEST(DrawHardware, OfBlocksOfTheirOwnIsAsThatOfTheBearingsInProportion) {
  UncertaintyOptions plain = options_for(1);
  plain.nominal.hardware.bearing.mu = 0.05;
  UncertaintyOptions own = plain;
  own.nominal.hardware.block = {0.05, 2};
  UncertaintyOptions other = plain;
  other.nominal.hardware.block = {0.02, 2};
  UncertaintyOptions smooth = other;
  smooth.nominal.hardware.bearing.mu = 0;
  for (std::uint64_t draw = 0; draw < 50; ++draw) {
    const double bearing = draw_model(plain, draw).hardware.bearing.mu;
    EXPECT_FALSE(draw_model(plain, draw).hardware.block);
    EXPECT_EQ(drawn(draw_model(own, draw).hardware), drawn(draw_model(plain, draw).hardware));
    EXPECT_EQ(draw_model(own, draw).hardware.block->mu, bearing);
    EXPECT_EQ(draw_model(own, draw).hardware.block->angle_rad, 2);
    EXPECT_NEAR(draw_model(other, draw).hardware.block->mu, bearing * 0.4, 1e-15);
    // Also where the bearings have no friction that could vary.
    EXPECT_EQ(draw_model(smooth, draw).hardware.bearing.mu, 0);
    EXPECT_NEAR(draw_model(smooth, draw).hardware.block->mu, bearing * 0.4, 1e-15);
  }
}

TEST(DrawHardware, LeavesEverythingElseAsItIs) {
  UncertaintyOptions options = options_for(1);
  options.nominal.hardware.tube.angle_rad = 3;
  options.nominal.hardware.strand_mm = 80;
  options.nominal.hardware.fingers.push_back({1, 0.3, {}, 0.25, {}, 90.0, 2});
  options.nominal.hardware.contacts.push_back({"T1", "T2", 0.4, {}});
  const Hardware hardware = draw_model(options, 5).hardware;
  EXPECT_EQ(hardware.tube.angle_rad, 3);
  EXPECT_EQ(hardware.bearing.angle_rad, options.nominal.hardware.bearing.angle_rad);
  EXPECT_EQ(hardware.strand_mm, 80);
  EXPECT_EQ(hardware.motor_side_mm, options.nominal.hardware.motor_side_mm);
  EXPECT_EQ(hardware.hand_mm, options.nominal.hardware.hand_mm);
  EXPECT_EQ(hardware.fingers, options.nominal.hardware.fingers);
  EXPECT_EQ(hardware.contacts, options.nominal.hardware.contacts);
}

}  // namespace
}  // namespace reeve
