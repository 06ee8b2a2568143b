#include "core/indicators.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/notation.hpp"

namespace reeve {
namespace {

Indicators indicators_of(const std::string& word, Grasp grasp, const Hardware& hardware = {}) {
  const Network network = expand(parse_routing(word));
  return indicators(network, tensions(network, mechanics(network, hardware), grasp));
}

double mean(const Indicators& of) {
  return (of.adaptability + of.torsional_balance + of.reliability + of.authors_efficiency +
          of.transmission) /
         5;
}

Hardware with_friction(double tube, double sheath) {
  Hardware hardware;
  hardware.tube.mu = tube;
  hardware.sheath.mu = sheath;
  return hardware;
}

struct Published {
  const char* word;
  double thought;  // mean of the five at the coefficients that the supplement assumes
  double fitted;   // at those that the authors' readings show
};

TEST(Indicators, HaveTheMeansOfTheSevenRoutings) {
  const std::array<Published, 7> rows{{{"M-1-T-2-F", 3.21, 7.76},
                                       {"M-1-T-2-M", 4.15, 7.64},
                                       {"F-1-P-2-F", 5.14, 7.82},
                                       {"M-1-P-2-F", 2.13, 7.04},
                                       {"M-1-P-2-M", 2.34, 7.11},
                                       {"1-T-2-P-1", 5.14, 7.82},
                                       {"1-P-2-P-1", 5.75, 7.71}}};
  for (const Published& row : rows) {
    EXPECT_NEAR(mean(indicators_of(row.word, hold({1}))), row.thought, 0.005) << row.word;
    EXPECT_NEAR(mean(indicators_of(row.word, hold({1}), with_friction(0.0525, 0.0454))), row.fitted,
                0.005)
        << row.word;
  }
}

// Two strands of s/2 behind one sheath, s = e^{-φ}, and the bearing between them without friction.
TEST(Indicators, OfFingersWithOneStrandCountStrands) {
  Hardware hardware;
  hardware.bearing.mu = 0;
  const double s = std::exp(-0.36 * std::numbers::pi);
  const Indicators found = indicators_of("M-Y1+1x-Y1-2x", hold({1}), hardware);
  EXPECT_NEAR(found.adaptability, 10, 1e-12);
  EXPECT_NEAR(found.torsional_balance, 10, 1e-12);
  EXPECT_NEAR(found.reliability, 10 * (1 - (1 - s) / s), 1e-11);
  EXPECT_NEAR(found.transmission, 10 * s / 2, 1e-12);
  // The block goes with the carriage, and both strands give up as much.
  EXPECT_NEAR(found.authors_efficiency, 10 * s, 1e-12);
  // A bar's arms pull as hard as they must; that is no friction.
  EXPECT_NEAR(indicators_of("M-W1+1x-W1/1:9-2x", {}, with_friction(0, 0)).reliability, 10, 1e-11);
}

// T1 … T4 and a by hand: 1, r, r², r³ behind one sheath.
TEST(Indicators, OfTr1FollowFromItsClosedForm) {
  const double r = std::exp(-0.18 * std::numbers::pi);
  const double sheath = std::exp(0.36 * std::numbers::pi);
  const double sum = 1 + r + r * r + r * r * r;
  const Indicators found = indicators_of("M-1-T-2-F", hold({1}));
  EXPECT_NEAR(found.adaptability, 10 * (1 - (1 + r - r * r - r * r * r) / sum), 1e-12);
  EXPECT_NEAR(found.torsional_balance, 10 * (1 - (1 - r) / sum), 1e-12);
  EXPECT_NEAR(found.reliability, 10 * (1 - (sheath - 1) / sum), 1e-12);
  EXPECT_NEAR(found.transmission, 10 * sum / (4 * sheath), 1e-12);
  EXPECT_NEAR(found.authors_efficiency, found.transmission, 1e-12);
}

TEST(Indicators, OfPartsWithoutFrictionAreTenWhereAllStrandsCloseAlike) {
  Hardware smooth = with_friction(0, 0);
  smooth.bearing.mu = 0;
  for (const char* word : {"1-P-2-P-1", "1-P-2-P-3-P-1"}) {
    const Indicators found = indicators_of(word, hold({1}), smooth);
    EXPECT_NEAR(found.adaptability, 10, 1e-12) << word;
    EXPECT_NEAR(found.torsional_balance, 10, 1e-12) << word;
    EXPECT_NEAR(found.reliability, 10, 1e-12) << word;
    EXPECT_NEAR(found.authors_efficiency, 10, 1e-12) << word;
  }
}

// Without friction the strands do all the work of the motor, whatever ties them together.
TEST(Indicators, OfBlocksAndBarsWithoutFrictionAreTenWhereAllStrandsCloseAlike) {
  Hardware smooth = with_friction(0, 0);
  smooth.bearing.mu = 0;
  Hardware uneven = smooth;
  uneven.fingers.push_back({1, {}, {}, {}, {}, {}, 3});
  for (const char* word :
       {"M-Y1+1x-Y1-2x", "M-W1+1x-W1-2x", "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", "1x-Y1+M-Y1-2b-F",
        "M-Y1+F-1b-Y1-2b-F", "M-B-Y1-B-Y1k+Y1-1x", "M-1-Y1+2-Y1-3-T-2", "M-W1+1x-W1/1:3-2x",
        "M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x"}) {
    EXPECT_NEAR(indicators_of(word, {}, smooth).authors_efficiency, 10, 1e-10) << word;
    EXPECT_NEAR(indicators_of(word, hold({1}), smooth).authors_efficiency, 10, 1e-10) << word;
    // As if all closed alike: not as the hardware lets them close.
    EXPECT_NEAR(indicators_of(word, {}, uneven).authors_efficiency, 10, 1e-10) << word;
  }
}

// Behind each block friction takes what it takes of the only sheath.
TEST(Indicators, OfATreeOfBlocksAreWhatTheSheathLetsThrough) {
  Hardware hardware;
  hardware.bearing.mu = 0;
  const double s = std::exp(-0.36 * std::numbers::pi);
  EXPECT_NEAR(
      indicators_of("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", hold({1}), hardware).authors_efficiency,
      10 * s, 1e-10);
}

// Three fingers in a row: pulls 1 + r, r² + r³, r⁴ + r⁵.
TEST(Indicators, OfMoreFingersCompareTheGreatestWithTheLeast) {
  const double r = std::exp(-0.18 * std::numbers::pi);
  double sum = 0;
  for (int i = 0; i < 6; ++i) sum += std::pow(r, i);
  const Indicators found = indicators_of("M-1-T-2-T-3-F", hold({1}));
  EXPECT_NEAR(found.adaptability, 10 * (1 - (1 + r - std::pow(r, 4) - std::pow(r, 5)) / sum),
              1e-12);
  EXPECT_NEAR(found.transmission, 10 * sum / 6 * std::exp(-0.36 * std::numbers::pi), 1e-12);
}

TEST(Indicators, OfFingersOnTwoTendonsCountAllSegmentsAtTheMotor) {
  const Indicators found = indicators_of("M-1-M+M-2-M", Grasp{}, with_friction(0, 0));
  EXPECT_NEAR(found.authors_efficiency, 10, 1e-12);
  EXPECT_NEAR(found.transmission, 2.5, 1e-12);
}

TEST(Indicators, OfABenchWithoutStrandsAreZero) {
  const Indicators found = indicators_of("M-F", Grasp{});
  EXPECT_EQ(found.adaptability, 0);
  EXPECT_EQ(found.transmission, 0);
}

}  // namespace
}  // namespace reeve
