// The reference model with floating blocks, anchored tips and bars: against values worked out by
// hand or by other programs. The library has no part in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve {
namespace {

using testing::ReferenceDirection;
using testing::ReferenceHardware;
using testing::ReferenceResult;
using testing::work_on_fingers;

constexpr double pi = std::numbers::pi;

ReferenceHardware paper_hardware() {
  ReferenceHardware hardware{};
  hardware.tube = {0.18, pi};
  hardware.bearing = {0.001, pi};
  hardware.sheath = {0.18, 2 * pi};
  return hardware;
}

ReferenceResult pulled(const std::string& word, const std::set<int>& held = {},
                       const ReferenceHardware& hardware = paper_hardware()) {
  return testing::reference_tensions(word, held, ReferenceDirection::pull, hardware);
}

std::vector<double> strands(const ReferenceResult& result) {
  std::vector<double> found;
  for (const auto& [segment, tension] : result.tension)
    if (segment.front() == 'T') found.push_back(tension);
  return found;
}

struct Indicators {
  double uniformity = 0, efficiency = 0;
};

Indicators mean_of_grasps(const std::string& word) {
  Indicators mean;
  for (const std::set<int>& held : {std::set<int>{}, {1}, {2}}) {
    const ReferenceResult result = pulled(word, held);
    const std::vector<double> tensions = strands(result);
    const auto [least, most] = std::minmax_element(tensions.begin(), tensions.end());
    mean.uniformity += *least / *most / 3;
    mean.efficiency += work_on_fingers(result) / 3;
  }
  return mean;
}

void expect_tensions(const ReferenceResult& result, const std::map<std::string, double>& expected) {
  for (const auto& [segment, tension] : expected)
    EXPECT_NEAR(result.tension.at(segment), tension, 5e-5) << segment;
}

// ---- values ----

TEST(ReferenceBlocks, UniformityAndEfficiencyAreThoseOfTheDesign) {
  const struct {
    const char* word;
    double uniformity, efficiency;
  } rows[] = {{"1-P-2-P-1", 0.998, 0.322},
              {"M-Y1+1x-Y1-2x", 0.998, 0.322},
              {"1x-P-2x", 0.998, 0.322},
              {"M-Y1+F-1b-Y1-2b-F", 0.995, 0.322},
              {"M-Y1+F-1-Y1-2-F", 0.567, 0.253}};
  for (const auto& [word, uniformity, efficiency] : rows) {
    const Indicators found = mean_of_grasps(word);
    EXPECT_NEAR(found.uniformity, uniformity, 6e-4) << word;
    EXPECT_NEAR(found.efficiency, efficiency, 6e-4) << word;
  }
}

TEST(ReferenceBlocks, ATreeOfThreeBlocksHasTheTensionsOfTheDesign) {
  expect_tensions(pulled("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", {1}),
                  {{"h1", 0.3227}, {"T1", 0.0809}, {"T3", 0.0807}, {"T5", 0.0806}, {"T7", 0.0806}});
}

TEST(ReferenceBlocks, ALoopThroughABlockBelowAMotorHasTheTensionsOfTheDesign) {
  const ReferenceResult result = pulled("M-1-Y1+2-Y1-3-T-2", {2});
  expect_tensions(result, {{"T1", 0.3227},
                           {"T2", 0.1833},
                           {"T3", 0.0522},
                           {"T4", 0.0918},
                           {"T5", 0.0915},
                           {"T6", 0.0520}});
  EXPECT_NEAR(work_on_fingers(result), 0.2165, 5e-5);
}

TEST(ReferenceBlocks, ALuffTackleLosesOneBearingMoreWithEachPart) {
  const ReferenceResult result = pulled("M-B-Y1-B-Y1k+Y1-1x");
  const double r = std::exp(-0.001 * pi);
  EXPECT_NEAR(result.tension.at("T1") / result.tension.at("h1"), r + r * r + r * r * r, 1e-12);
  EXPECT_NEAR(result.closing.at(1), 1.0 / 3, 1e-15);
}

TEST(ReferenceBlocks, ABlockHasTheBearingsLawUnlessItHasItsOwn) {
  ReferenceHardware hardware = paper_hardware();
  EXPECT_NEAR(pulled("M-Y1-F+Y1-1x", {}, hardware).tension.at("T1"),
              std::exp(-0.36 * pi) * (1 + std::exp(-0.001 * pi)), 1e-12);
  hardware.block = {0.1, pi};
  EXPECT_NEAR(pulled("M-Y1-F+Y1-1x", {}, hardware).tension.at("T1"),
              std::exp(-0.36 * pi) * (1 + std::exp(-0.1 * pi)), 1e-12);
}

TEST(ReferenceBlocks, WithoutFrictionATackleMultipliesByItsParts) {
  const struct {
    const char* word;
    double parts;
  } tackles[] = {{"M-B-Y1-B-Y1k+Y1-1x", 3},
                 {"M-Y1-F+Y1-1x", 2},
                 {"M-Y1k+Y1-1x", 1},
                 {"M-Y1-F+Y1-Y2-F+Y2-1x", 4},
                 {"M-Y2-B-Y1k+Y2-Y1-F+Y1-1x", 5},
                 {"M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x", 7},
                 {"M-B-Y1-B-Y1-F+Y1-1x", 4},
                 {"M-Y1+F-Y1-1x", 0.5}};
  for (const auto& [word, parts] : tackles)
    for (const auto direction : {ReferenceDirection::pull, ReferenceDirection::release}) {
      const ReferenceResult result = testing::reference_tensions(word, {}, direction, {});
      EXPECT_NEAR(result.tension.at("T1"), parts, 1e-12) << word;
      EXPECT_NEAR(result.closing.at(1), 1 / parts, 1e-12) << word;
    }
}

TEST(ReferenceBlocks, ABarSharesInItsRatioWhateverTheFriction) {
  for (const std::set<int>& held : {std::set<int>{}, {1}, {2}, {1, 2}}) {
    const ReferenceResult result = pulled("1x-W1/2:1-2x+W1-M", held);
    EXPECT_NEAR(result.tension.at("T1"), 2 * result.tension.at("T3"), 1e-15);
    EXPECT_NEAR(result.tension.at("T1") + result.tension.at("T3"), result.tension.at("h1"), 1e-15);
  }
  EXPECT_NEAR(pulled("1x-W1/2:1-2x+W1-M", {2}).closing.at(1), 1.5, 1e-15);
  EXPECT_NEAR(pulled("1x-W1/2:1-2x+W1-M", {1}).closing.at(2), 3, 1e-15);
}

TEST(ReferenceBlocks, AWhiffletreeMovesWithItsFreeFingers) {
  const ReferenceResult result = pulled("1x-W1-2x+3x-W2-4x+W1-W3-W2+W3-M", {1});
  for (const char* strand : {"T1", "T3", "T5", "T7"})
    EXPECT_NEAR(result.tension.at(strand), std::exp(-0.36 * pi) / 4, 1e-15);
  for (const int finger : {2, 3, 4}) EXPECT_NEAR(result.closing.at(finger), 4.0 / 3, 1e-15);
}

TEST(ReferenceBlocks, FingersCloseAsAlikeAsABlockOfSeveralTendonsLets) {
  const ReferenceResult result = pulled("M-Y1+1x-Y1-2x+3x-Y1-4x", {3});
  EXPECT_NEAR(result.closing.at(1), 1, 1e-15);
  EXPECT_NEAR(result.closing.at(2), 1, 1e-15);
  EXPECT_NEAR(result.closing.at(4), 2, 1e-15);
}

// Finger 4 held: 2 z2 = dl3 and 2 = dl5 + z2 leave one freedom beside dl1 = dl2 = 1.
TEST(ReferenceBlocks, WhatTheConstraintsLeaveOpenHasTheLeastWeightedVariance) {
  const char* word = "M-Y1+1x-Y1-2x+Y2-Y1-5x+3x-Y2-4x";
  const ReferenceResult equivalent = pulled(word, {4});
  EXPECT_NEAR(equivalent.closing.at(3), 24.0 / 19, 1e-15);
  EXPECT_NEAR(equivalent.closing.at(5), 26.0 / 19, 1e-15);
  ReferenceHardware hardware = paper_hardware();
  hardware.closing_weight[5] = 2;
  const ReferenceResult weighed = pulled(word, {4}, hardware);
  EXPECT_NEAR(weighed.closing.at(3), 36.0 / 43, 1e-15);
  EXPECT_NEAR(weighed.closing.at(5), 68.0 / 43, 1e-15);
}

// ---- jams and slack ----

TEST(ReferenceBlocks, ABranchThatIsHeldAnchorsTheOthersAndNoneIsAJam) {
  const char* word = "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x";
  EXPECT_FALSE(pulled(word, {1, 2}).jams);
  EXPECT_EQ(pulled(word, {1, 2}).closing.at(3), 2);
  const ReferenceResult jammed = pulled(word, {1, 2, 3, 4});
  EXPECT_TRUE(jammed.jams);
  for (const auto& contact : jammed.contacts) EXPECT_EQ(contact.slip, 0);
}

TEST(ReferenceBlocks, AJammedTreeTakesAllFromTheTreesThatMove) {
  const ReferenceResult result = pulled("M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x", {1, 2});
  EXPECT_TRUE(result.jams);
  EXPECT_EQ(result.tension.at("a"), 1);
  EXPECT_EQ(result.tension.at("T5"), 0);
}

TEST(ReferenceBlocks, ATailOfTwoWhoseFingersDifferJams) {
  EXPECT_FALSE(pulled("M-Y1-F+Y1-1x+Y1-2x").jams);
  EXPECT_TRUE(pulled("M-Y1-F+Y1-1x+Y1-2x", {1}).jams);
}

// The motor on the tail pulls the block down, that on the third tendon pulls it up by as much
// again.
TEST(ReferenceBlocks, ATendonThatTheOthersSlackenCarriesNothing) {
  for (const char* word : {"M-Y1+1x-Y1-2x+M-Y1-3x", "M-Y1-3x+M-Y1+1x-Y1-2x"}) {
    const ReferenceResult result = pulled(word, {1, 2, 3});
    EXPECT_EQ(result.tension.at("T1"), 0) << word;
    EXPECT_EQ(result.tension.at("T3"), 0) << word;
    EXPECT_GT(result.tension.at("T5"), 0.1) << word;
  }
}

// ---- what is refused ----

TEST(ReferenceBlocks, IllFormedWordsAreRefused) {
  for (const char* word : {"M-Y1",              // neither pass nor becket
                           "M-Y1-1x",           // no tail
                           "Y1-T-Y1-M",         // hangs on itself
                           "M-Y1+1x-T-Y1k-2x",  // a becket inside a walk
                           "M-1x-2x",           // an anchored tip inside a walk
                           "M-Yx+1x-Y1-2x", "M-W1+1x-W1/0:1-2x", "M-W1+1x-W1/2-2x",
                           "M-W1+1-W1/2:1-2-T-1",     // unequal arms in a loop
                           "M-W1+1x-W1-2x+3x-W1-4x",  // four arms
                           "F-Y1+1x-Y1-2x",           // no motor
                           "M-Y1-Y2-F+Y1-1-Y2"})      // which block moves is open
    EXPECT_THROW(pulled(word), std::invalid_argument) << word;
}

TEST(ReferenceBlocks, TheFirstDisagreementOfTwoAnswersIsNamed) {
  const char* word = "M-Y1+1x-Y1-2x";
  const ReferenceResult expected = pulled(word, {1});
  EXPECT_EQ(testing::disagreement(word, expected, expected), "");
  ReferenceResult other = expected;
  other.tension["T3"] *= 1.00001;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 3), "T3:");
  other = expected;
  other.contacts.back().slip = 1;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 13), "slip at T1-T3");
  other = expected;
  other.closing[2] = 1;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 19), "closing of finger 2");
  other = expected;
  other.jams = true;
  EXPECT_EQ(testing::disagreement(word, expected, other), "jams");
}

}  // namespace
}  // namespace reeve
