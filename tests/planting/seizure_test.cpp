#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/support/planting_nature.hpp"
#include "tests/support/planting_seizure.hpp"

namespace reeve::testing {
namespace {

const double s = std::exp(-0.18 * 2 * std::numbers::pi);  // what a sheath lets through
const double t = std::exp(-0.18 * std::numbers::pi);      // a tube
const double b = std::exp(-0.001 * std::numbers::pi);     // a bearing

using Tensions = std::map<std::string, double>;

Tensions seized(const std::string& word, const std::string& contact,
                const std::set<int>& held = {}) {
  Nature nature;
  nature.seized.push_back({word, contact});
  Condition condition;
  condition.word = word;
  condition.held = held;
  condition.motor_tension_N = 1;
  return planted_tensions(nature, condition);
}

void expect(const Tensions& tension, const Tensions& expected) {
  ASSERT_EQ(tension.size(), expected.size());
  for (const auto& [segment, value] : expected) {
    EXPECT_NEAR(tension.at(segment), value, 1e-7) << segment;
  }
}

TEST(Seizure, AtAHandJoinLeavesWhatHangsOnNoMotorSlack) {
  const Tensions expected{{"a", 1}, {"T1", s}, {"T2", s * t}, {"T3", 0}, {"T4", 0}};
  expect(seized("M-1-T-2-F", "T2-T3"), expected);
  expect(seized("M-1-T-2-F", "T2-T3", {2}), expected);
  expect(seized("M-1-T-2-F", "T2-T3", {1}), expected);  // jams
}

TEST(Seizure, OfASymmetricTendonGivesTwoThatShareTheMotor) {
  expect(
      seized("M-1-T-2-M", "T2-T3"),
      {{"a", 0.5}, {"T1", s / 2}, {"T2", s * t / 2}, {"T3", s * t / 2}, {"T4", s / 2}, {"b", 0.5}});
}

TEST(Seizure, LetsAJammedPieceTakeTheWholeMotorTension) {
  expect(seized("M-1-T-2-M", "T2-T3", {1}),
         {{"a", 1}, {"T1", s}, {"T2", s * t}, {"T3", 0}, {"T4", 0}, {"b", 0}});
}

// The second piece has two motor-side segments and takes up twice as much; what finger 2 gives up
// for b slides over the pulley, from c.
TEST(Seizure, OfAPulleySheathLeavesItsSegmentWithThePulley) {
  const double first = 1 / (1 + s + s * t);
  const double second = 2 / (1 + b + b * s + b * s * t);
  const double motor = first + second * (1 + b);
  expect(seized("M-1-P-2-F", "T2-b"), {{"a", first / motor},
                                       {"T1", first * s / motor},
                                       {"T2", first * s * t / motor},
                                       {"b", second / motor},
                                       {"c", second * b / motor},
                                       {"T3", second * b * s / motor},
                                       {"T4", second * b * s * t / motor}});
}

TEST(Seizure, OfAPulleyTiesBothSidesToTheCarriage) {
  const Tensions tension = seized("M-1-P-2-M", "b-c", {1});
  // Finger 1 is held and jams; finger 2's tendon is slack.
  for (const char* segment : {"c", "T3", "T4", "d"}) EXPECT_EQ(tension.at(segment), 0) << segment;
  EXPECT_NEAR(tension.at("a") + tension.at("b"), 1, 1e-9);
  EXPECT_NEAR(tension.at("T1"), tension.at("a") * s, 1e-7);
}

// Opened at T2-T3, with finger 1 held, the tendon slides from finger 2 over the pulley to b.
TEST(Seizure, OpensALoop) {
  const double motor = 1 + b;
  expect(seized("1-T-2-P-1", "T2-T3", {1}), {{"a", b / motor},
                                             {"b", 1 / motor},
                                             {"T4", b * s / motor},
                                             {"T3", b * s * t / motor},
                                             {"T1", s / motor},
                                             {"T2", s * t / motor}});
}

TEST(Seizure, OfAnEndSheathBlocksTheCarriage) {
  expect(seized("M-1-T-2-M", "a-T1"),
         {{"a", 1}, {"T1", 0}, {"T2", 0}, {"T3", 0}, {"T4", 0}, {"b", 0}});
  EXPECT_EQ(seized("M-1-T-2-M", "T4-b").at("b"), 1);
}

TEST(Seizure, OfATipLeavesTheStrandBehindItSlack) {
  const Tensions expected{{"a", 1}, {"T1", s}, {"T2", s * t}, {"T3", s * t * t}, {"T4", 0}};
  for (const std::set<int>& held : {std::set<int>{}, {1}, {2}}) {
    expect(seized("M-1-T-2-F", "T3-T4", held), expected);
  }
}

TEST(Seizure, IsOfOneRoutingOnly) {
  Nature nature;
  nature.seized.push_back({"M-1-T-2-F", "T2-T3"});
  Condition condition;
  condition.word = "M-1-T-2-M";
  condition.motor_tension_N = 1;
  EXPECT_EQ(planted_tensions(nature, condition), planted_tensions({}, condition));
}

TEST(Seizure, WritesPiecesAsWords) {
  EXPECT_EQ(cut_at("M-1-T-2-M", "T2-T3").word, "M-1-F+F-2-M");
  EXPECT_EQ(cut_at("M-1-P-2-F", "b-c").word, "M-1-M+M-2-F");
  EXPECT_EQ(cut_at("F-1-P-2-F", "T2-a").word, "F-P-2-F");
  EXPECT_EQ(cut_at("M-1-P-2-F", "c-T3").word, "M-1-P-F");
}

TEST(Seizure, RefusesContactsThatItCannotCut) {
  EXPECT_THROW(cut_at("M-1-T-2-F", "T1-T3"), std::invalid_argument);
  EXPECT_THROW(cut_at("F-1-P-2-F", "T1-T2"), std::invalid_argument);
  EXPECT_THROW(cut_at("M-1-F+M-2-F", "a-T1"), std::invalid_argument);
  EXPECT_TRUE(seizable_contacts("M-1-F+M-2-F").empty());
  EXPECT_EQ(seizable_contacts("F-1-P-2-F").size(), 3U);
  EXPECT_EQ(seizable_contacts("1-P-2-P-1").size(), 8U);
}

}  // namespace
}  // namespace reeve::testing
