#include "core/performance.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/core/network_of.hpp"

namespace reeve {
namespace {

using testing::network_of;

Performance performance_of(const std::string& word, Grasp grasp,
                           Direction direction = Direction::pull, const Hardware& hardware = {}) {
  const Network net = network_of(word);
  return performance(net, tensions(net, mechanics(net, hardware), grasp, direction), direction);
}

// ---- the reference values of the design ----

struct ReferenceRow {
  const char* word;
  std::array<const char*, 4> values;  // finger 1 held, finger 2 held, both close, mean
};

const std::vector<ReferenceRow> reference_rows{
    {"M-1-T-2-F", {"0.183 / 0.082", "0.183 / 0.253", "0.183 / 0.167", "0.183 / 0.167"}},
    {"M-1-T-2-M", {"0.323 / 0.183", "0.323 / 0.183", "0.568 / 0.253", "0.405 / 0.207"}},
    {"F-1-P-2-F", {"0.566 / 0.253", "0.566 / 0.253", "0.568 / 0.253", "0.567 / 0.253"}},
    {"M-1-P-2-F", {"0.034 / 0.040", "0.566 / 0.295", "0.322 / 0.279", "0.307 / 0.205"}},
    {"M-1-P-2-M", {"0.034 / 0.052", "0.034 / 0.052", "1.000 / 0.323", "0.356 / 0.142"}},
    {"1-T-2-P-1", {"0.566 / 0.253", "0.566 / 0.253", "0.568 / 0.253", "0.567 / 0.253"}},
    {"1-P-2-P-1", {"0.997 / 0.322", "0.997 / 0.322", "1.000 / 0.323", "0.998 / 0.322"}}};

std::string printed(double uniformity, double efficiency) {
  return fmt::format("{:.3f} / {:.3f}", uniformity, efficiency);
}

TEST(Performance, OfThePublishedRoutingsIsThatOfTheReferenceTable) {
  const std::array<Grasp, 3> grasps{hold({1}), hold({2}), Grasp{}};
  for (const auto& [word, values] : reference_rows) {
    double uniformity = 0;
    double efficiency = 0;
    for (std::size_t g = 0; g < 3; ++g) {
      const Performance found = performance_of(word, grasps[g]);
      EXPECT_EQ(printed(found.uniformity, found.efficiency), values[g])
          << word << " held " << to_text(grasps[g]);
      uniformity += found.uniformity / 3;
      efficiency += found.efficiency / 3;
    }
    EXPECT_EQ(printed(uniformity, efficiency), values[3]) << word << " mean";
  }
}

// ---- definitions ----

TensionState state(const std::vector<double>& tension, const std::vector<double>& closing) {
  TensionState result;
  result.tension = tension;
  result.closing = closing;
  return result;
}

TEST(Performance, FollowsItsDefinitions) {
  // a T1 T2 T3 T4
  const Performance found =
      performance(network_of("M-1-T-2-F"), state({1, 0.8, 0.4, 0.5, 0.2}, {0.1, 0.4}));
  EXPECT_DOUBLE_EQ(found.uniformity, 0.25);
  EXPECT_DOUBLE_EQ(found.force_transmission, 1.9);
  EXPECT_DOUBLE_EQ(found.efficiency, 0.1 * 1.2 + 0.4 * 0.7);
}

// Of M-1-T-2x the strands stand as 1 : r : r² behind the sheath, both tubes slide, so that finger 1
// is pulled with 1 + r and finger 2 with r².
TEST(Performance, OfFingersAddsTheStrandsOfEach) {
  const double r = std::exp(-0.18 * std::numbers::pi);
  const Performance found = performance_of("M-1-T-2x", hold({1}));
  EXPECT_NEAR(found.uniformity, r * r, 1e-12);
  EXPECT_NEAR(found.finger_uniformity, r * r / (1 + r), 1e-12);
  // As many strands on every finger.
  const Performance single = performance_of("M-Y1+1x-Y1-2x", hold({1}));
  EXPECT_NEAR(single.finger_uniformity, single.uniformity, 1e-12);
  EXPECT_TRUE(std::isnan(performance_of("M-F", Grasp{}).finger_uniformity));
}

TEST(PartCount, HasBlocksBarsAndAnchoredTips) {
  const PartCount tree = parts(network_of("1x-W1-2b-B-Y1+3x-Y2-4x+W1-Y2-F+Y2-M+Y1k-F+Y1-M"));
  EXPECT_EQ(tree.blocks, 2);
  EXPECT_EQ(tree.bars, 1);
  EXPECT_EQ(tree.anchors, 3);
  EXPECT_EQ(tree.pulleys, 2);
  EXPECT_EQ(tree.sheaths, 2);
  EXPECT_EQ(tree.total(), 10);
}

TEST(Performance, ReleasingTheMotorReceivesTheWorkOfTheFingers) {
  const Performance found =
      performance(network_of("M-1-F"), state({1, 2, 3}, {0.5}), Direction::release);
  EXPECT_DOUBLE_EQ(found.efficiency, 1 / (0.5 * 2 + 0.5 * 3));
  EXPECT_DOUBLE_EQ(found.force_transmission, 5);
}

// Summed up, these products of tension and travel give 1.0000000000000002.
TEST(Performance, NeverExceedsOneWithoutFriction) {
  Hardware smooth;
  smooth.tube.mu = 0;
  smooth.sheath.mu = 0;
  smooth.bearing.mu = 0;
  for (const char* word : {"M-1-P-2-T-3-F", "M-1-T-2-P-3-F", "M-1-P-2b-T-3-F", "M-1-T-2-F"}) {
    for (const Direction direction : {Direction::pull, Direction::release}) {
      const double efficiency = performance_of(word, {}, direction, smooth).efficiency;
      EXPECT_LE(efficiency, 1.0) << word;
      EXPECT_DOUBLE_EQ(efficiency, 1.0) << word;
    }
  }
}

TEST(Performance, LooksAtStrandsOnly) {
  // a h1 T1 T2 h2
  const Performance found =
      performance(network_of("M-T-1-T-F"), state({1, 0.9, 0.5, 0.4, 0.01}, {0.5}));
  EXPECT_DOUBLE_EQ(found.uniformity, 0.8);
  EXPECT_DOUBLE_EQ(found.force_transmission, 0.9);
}

TEST(Performance, OfABenchHasNoUniformity) {
  const Performance found = performance_of("M-F", Grasp{});
  EXPECT_TRUE(std::isnan(found.uniformity));
  EXPECT_EQ(found.efficiency, 0);
  EXPECT_EQ(found.force_transmission, 0);
}

TEST(Performance, OfAJamDoesNoWork) {
  EXPECT_EQ(performance_of("M-1-T-2-F", hold({1, 2})).efficiency, 0);
}

TEST(Performance, SlackBesideAJamMeansUniformityZero) {
  EXPECT_EQ(performance_of("M-1-F+M-2-F", hold({2})).uniformity, 0);
}

// ---- return friction ----

TEST(ReturnFriction, IsWhatAPullAndAReleaseLose) {
  // M-1-F: e^{-s}(1 + e^{-t})/2 pulling, 2/(e^{s}(1 + e^{t})) releasing.
  const Performance pull = performance_of("M-1-F", Grasp{});
  const Performance release = performance_of("M-1-F", Grasp{}, Direction::release);
  const double s = Hardware{}.sheath.exponent();
  const double t = Hardware{}.tube.exponent();
  EXPECT_NEAR(round_trip_efficiency(pull.efficiency, release.efficiency), std::exp(-2 * s - t),
              1e-12);
}

TEST(ReturnFriction, IsOneWithoutFriction) {
  Hardware smooth;
  smooth.tube.mu = smooth.bearing.mu = smooth.sheath.mu = 0;
  for (const ReferenceRow& row : reference_rows) {
    EXPECT_NEAR(round_trip_efficiency(
                    performance_of(row.word, hold({1}), Direction::pull, smooth).efficiency,
                    performance_of(row.word, hold({1}), Direction::release, smooth).efficiency),
                1, 1e-12);
  }
}

TEST(ReturnFriction, IsZeroWhereTheGraspJams) {
  const Grasp all = hold({1});
  EXPECT_EQ(round_trip_efficiency(performance_of("M-1-F", all).efficiency,
                                  performance_of("M-1-F", all, Direction::release).efficiency),
            0);
}

// ---- parts ----

TEST(Parts, AreCountedFromTheNetwork) {
  struct Row {
    const char* word;
    int sheaths, pulleys, knots;
  };
  for (const Row& row : std::vector<Row>{{"M-1-T-2-F", 1, 0, 0},
                                         {"M-1-T-2-M", 2, 0, 0},
                                         {"F-1-P-2-F", 2, 1, 0},
                                         {"M-1-P-2-F", 3, 1, 0},
                                         {"M-1-P-2-M", 4, 1, 0},
                                         {"1-T-2-P-1", 2, 1, 1},
                                         {"1-P-2-P-1", 4, 2, 1},
                                         {"M-1b-B-2-F+3b-P-3b", 3, 4, 1}}) {
    const PartCount count = parts(network_of(row.word));
    EXPECT_EQ(count.sheaths, row.sheaths) << row.word;
    EXPECT_EQ(count.pulleys, row.pulleys) << row.word;
    EXPECT_EQ(count.knots, row.knots) << row.word;
    EXPECT_EQ(count.total(), row.sheaths + row.pulleys + row.knots) << row.word;
  }
}

}  // namespace
}  // namespace reeve
