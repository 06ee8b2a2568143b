#include "diagnosis/verdict/losses.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve::testing {
namespace {

constexpr double tube_loss = 0.18 * std::numbers::pi;
constexpr double sheath_loss = 0.36 * std::numbers::pi;
constexpr double bearing = 0.001 * std::numbers::pi;

// Forecasts as measured, but for a loss that the model thinks twice as large.
std::vector<ComparedCell> compared(const MeasuredData& data) {
  std::vector<ComparedCell> cells = cells_as_measured(data);
  for (ComparedCell& cell : cells) {
    cell.before_N = std::pow(cell.cell.measured_N, 2);
    cell.deviation_N = 0.01 * cell.cell.measured_N;
  }
  return cells;
}

// Of TR1 to TR7 with finger 1 held, whose directions and ratios the paper derives by hand.
TEST(Losses, AreTheExponentsBetweenNeighbouringSensors) {
  const double t = std::exp(-tube_loss), s = std::exp(-sheath_loss), b = std::exp(-bearing);
  const std::string tr4 =
      fmt::format("{},{},{},{}", 50.0, 50 * t, 50 * t * s * s * b, 50 * t * t * s * s * b);
  const MeasuredData data =
      read_data("run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,M-1-P-2-F,1," + tr4 + "\n");
  const auto found = losses(data, Model{}, compared(data));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(segment_name(found[0].high), "T1");
  EXPECT_EQ(segment_name(found[0].low), "T2");
  EXPECT_NEAR(found[0].measured, tube_loss, 1e-12);
  EXPECT_NEAR(found[1].measured, 2 * sheath_loss + bearing, 1e-12);
  EXPECT_NEAR(found[1].before, 2 * found[1].measured, 1e-12);
  EXPECT_NEAR(found[1].after, found[1].measured, 1e-12);
  EXPECT_NEAR(found[1].deviation, std::hypot(0.01, 0.01), 1e-12);
  EXPECT_EQ(found[1].over, (std::vector<ContactKind>{ContactKind::sheath, ContactKind::bearing,
                                                     ContactKind::sheath}));
  EXPECT_NEAR(found[2].measured, tube_loss, 1e-12);
}

// In TR7 the tips hold with less than they could, and the sheaths at P work against each other; in
// TR3 only the tips' friction is used up, from the inner strands outward.
TEST(Losses, LeaveOutContactsWhoseFrictionIsNotUsedUp) {
  const MeasuredData data = read_data(
      "run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,1-P-2-P-1,1,25,25,25,25\n1,TR3,1,20,30,30,20\n");
  const auto found = losses(data, Model{}, compared(data));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(segment_name(found[0].high) + segment_name(found[0].low), "T2T1");
  EXPECT_EQ(segment_name(found[1].high) + segment_name(found[1].low), "T3T4");
}

// Finger 1 of TR4 closes by more than slides round its tip: its guides lose as much on both
// strands.
TEST(Losses, OfATipLeaveOutGuidesThatBothStrandsPassAlike) {
  FingerParts parts = three_joint_finger();
  for (FingerJoint& joint : parts.joints) joint.guide = JointGuide::tube;
  const MeasuredData data =
      read_data("run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,M-1-P-2-F,none,40,30,20,10\n");
  const auto found = losses(data, Model{hand_of({parts, parts})}, compared(data));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(segment_name(found[0].high) + segment_name(found[0].low), "T1T2");
  EXPECT_NEAR(found[0].measured, std::log(4.0 / 3), 1e-12);
}

TEST(Losses, SkipWhatIsNotMeasuredBetween) {
  const MeasuredData data =
      read_data("run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,M-1-T-2-F,1,40,,20,10\n");
  const auto found = losses(data, Model{}, compared(data));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(segment_name(found[0].high) + segment_name(found[0].low), "T1T3");
  EXPECT_NEAR(found[0].measured, std::log(2.0), 1e-12);
  EXPECT_EQ(found[0].over.size(), 2U);
}

// Four mountings of three contacts each, with a little scatter, and one contact that loses far
// more.
TEST(Losses, OneThatIsFarFromTheOthersStandsApart) {
  std::string apart = "run,routing,held,direction,T1_N,T2_N,T3_N,T4_N\n";
  const char* routings[] = {"M-1-T-2-F", "M-1-T-2-F", "M-2-T-1-F", "M-2-T-1-F"};
  int k = 0;
  for (int i = 0; i < 4; ++i) {
    double tension = 40;
    apart += fmt::format("{},{},{},pull", i, routings[i], i % 2 == 0 ? "1" : "2");
    double strands[4];
    for (double& strand : strands) {
      strand = tension;
      tension *= std::exp(-tube_loss - (k++ == 6 ? 0.4 : 0.01 * ((7 * k) % 5 - 2)));
    }
    const bool second_first = i >= 2;
    for (int j = 0; j < 4; ++j)
      apart += fmt::format(",{}", strands[second_first ? (j + 2) % 4 : j]);
    apart += "\n";
  }
  const MeasuredData data = read_data(apart);
  std::vector<ComparedCell> cells = compared(data);
  for (ComparedCell& cell : cells) {
    const auto walk = cell.cell.segment;
    cell.after_N = 40 * std::exp(-tube_loss * static_cast<double>(walk));
  }
  const auto found = losses(data, Model{}, cells);
  ASSERT_EQ(found.size(), 12U);
  std::size_t marked = 0;
  for (const Loss& loss : found) {
    marked += loss.stands_apart ? 1 : 0;
    EXPECT_EQ(loss.stands_apart, loss.measured > tube_loss + 0.2);
  }
  EXPECT_EQ(marked, 1U);
}

TEST(Losses, NameTheContactsFromTheHigherTensionOn) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,T1_N,T2_N,T4_N\n1,M-1-P-2-F,1,pull,40,30,10\n"
      "1,M-1-P-2-F,1,release,5,10,40\n");
  const auto found = losses(data, Model{}, compared(data));
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(segment_name(found[1].high) + segment_name(found[1].low), "T2T4");
  EXPECT_EQ(segment_name(found[3].high) + segment_name(found[3].low), "T4T2");
  const auto reversed = std::vector<ContactKind>(found[3].over.rbegin(), found[3].over.rend());
  EXPECT_EQ(found[1].over, reversed);
  EXPECT_EQ(found[3].over.front(), ContactKind::tube);
}

TEST(Losses, AreMeansOverTheRowsOfAGraspAndDirection) {
  const MeasuredData data = read_data(
      "run,routing,direction,T1_N,T2_N\n1,M-1-F,pull,40,20\n1,M-1-F,pull,40,10\n"
      "1,M-1-F,release,20,40\n");
  const auto found = losses(data, Model{}, compared(data));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].rows, 2U);
  EXPECT_NEAR(found[0].measured, std::log(40 / std::sqrt(200.0)), 1e-12);
  EXPECT_NEAR(found[0].before, 2 * found[0].measured, 1e-12);
  // Of a mean of two, of two tensions each.
  EXPECT_NEAR(found[0].deviation, 0.01, 1e-12);
  EXPECT_EQ(found[1].rows, 1U);
  EXPECT_EQ(found[1].direction, Direction::release);
  EXPECT_EQ(segment_name(found[1].high) + segment_name(found[1].low), "T2T1");
}

// The second row's readings scatter three times as far: it weighs a ninth.
TEST(Losses, AreMeansWeighedByTheNoise) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-F,40,20\n1,M-1-F,40,10\n");
  std::vector<ComparedCell> cells = compared(data);
  for (std::size_t i = 2; i < 4; ++i) cells[i].deviation_N *= 3;
  const auto found = losses(data, Model{}, cells);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].measured, (0.9 * std::log(2) + 0.1 * std::log(4)), 1e-12);
  EXPECT_NEAR(found[0].deviation, std::sqrt(2e-4 * 0.9), 1e-12);
}

// Whatever is read: chosen by that, what is left would read too much.
TEST(Losses, LeaveOutRowsWhereATensionOfNoneIsForecast) {
  const MeasuredData data = read_data(
      "run,routing,T1_N,T2_N\n1,M-1-F,40,20\n1,M-1-F,40,0.5\n1,M-1-F,40,0.5\n1,M-1-F,40,0\n");
  std::vector<ComparedCell> cells = compared(data);
  for (ComparedCell& cell : cells) {
    cell.deviation_N = 0.2;
    cell.before_N = cell.after_N = cell.cell.segment == cells[0].cell.segment ? 40 : 20;
  }
  cells[3].after_N = 0.5;
  const auto found = losses(data, Model{}, cells);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].rows, 2U);
}

Effect effect_on(const char* cause, const Subject& subject) {
  return {find_cause(cause), subject, {}};
}

TEST(Losses, AreNotKnownBehindASeizedContact) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-F,40,20\n1,F-1-M,20,40\n");
  Model model;
  Subject tip;
  tip.routing = "M-1-F";
  tip.contact = "T1-T2";
  add_effect(model, effect_on("seized_contact", tip));
  const auto found = losses(data, model, compared(data));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(data.routings[found[0].routing].word, "F-1-M");
}

// With the grasp that was written down nothing is known of the sheaths.
TEST(Losses, AreThoseOfTheGraspThatItReallyWas) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N,T3_N,T4_N\n1,M-1-P-2-F,50,28,3,2\n");
  const auto over_sheaths = [&](const Model& model) {
    std::size_t count = 0;
    for (const Loss& loss : losses(data, model, compared(data))) {
      count += loss.over.size() == 3 ? 1 : 0;
    }
    return count;
  };
  Model wrong;
  Subject grasp;
  grasp.routing = "M-1-P-2-F";
  grasp.recorded = Grasp{};
  grasp.actual = hold({1});
  add_effect(wrong, effect_on("wrong_grasp", grasp));
  EXPECT_EQ(over_sheaths(wrong) - over_sheaths(Model{}), 1U);
}

// Stretches of one tube each, that lose so much more than tubes do, of which the model expects
// some. The noise is a share of each reading, of the last one another.
std::vector<bool> apart(const std::vector<double>& more, double noise,
                        const std::vector<double>& expected = std::vector<double>(9),
                        std::optional<double> noise_of_last = std::nullopt) {
  std::string text = "run,routing,held,T1_N,T2_N,T3_N,T4_N\n";
  const char* grasps[] = {"", "1", "2"};
  for (std::size_t k = 0; k < more.size(); k += 3) {
    double tension = 40;
    text += fmt::format("1,M-1-T-2-F,{},{}", grasps[k / 3], tension);
    for (std::size_t i = k; i < k + 3; ++i) {
      tension *= std::exp(-tube_loss - more[i]);
      text += fmt::format(",{}", tension);
    }
    text += '\n';
  }
  const MeasuredData data = read_data(text);
  std::vector<ComparedCell> cells = compared(data);
  for (ComparedCell& cell : cells) {
    cell.after_N = 40;
    for (std::size_t i = 0; i < cell.cell.channel; ++i) {
      cell.after_N *= std::exp(-tube_loss - expected[3 * cell.cell.reading + i]);
    }
    cell.deviation_N = noise * cell.cell.measured_N;
  }
  cells.back().deviation_N = noise_of_last.value_or(noise) * cells.back().cell.measured_N;
  std::vector<bool> result;
  for (const Loss& loss : losses(data, Model{}, cells)) result.push_back(loss.stands_apart);
  return result;
}

// Median and typical distance 0.01: that of 0.07 is 4 of them by the score, that of 0.05 is 2.7.
TEST(Losses, OneStandsApartBeyondAScoreOfThreeAndAHalf) {
  const std::vector<double> more{0, 0.02, 0, 0.02, 0.01, 0, 0.02, 0.01, 0.07};
  std::vector<bool> expected(9, false);
  EXPECT_EQ(apart({0, 0.02, 0, 0.02, 0.01, 0, 0.02, 0.01, 0.05}, 1e-4), expected);
  expected.back() = true;
  EXPECT_EQ(apart(more, 1e-4), expected);
  // 0.06 from the median is less than two standard deviations of √2 · 0.03.
  EXPECT_EQ(apart(more, 0.03), std::vector<bool>(9, false));
}

// Of the last stretch, 0.06 are 2.4 deviations of its noise; distances of the others are 1.4 of
// theirs.
TEST(Losses, OfNoisierReadingsDoNotStandApart) {
  const std::vector<double> more{0, 0.02, 0, 0.02, 0.01, 0, 0.02, 0.01, 0.07};
  const std::vector<double> nothing(9);
  EXPECT_TRUE(apart(more, 0.005, nothing, 0.005).back());
  EXPECT_FALSE(apart(more, 0.005, nothing, 0.024).back());
}

// The median is 0.05, and so are all distances but one, of 0.45: a score of 6. From 0.1, the upper
// of the two in the middle, half of the distances would be 0.1, and the score 2.7.
TEST(Losses, OfAnEvenNumberHaveTheirMedianBetweenTheTwoInTheMiddle) {
  EXPECT_EQ(apart({0, 0, 0, 0.1, 0.1, 0.5}, 1e-4),
            (std::vector<bool>{false, false, false, false, false, true}));
}

TEST(Losses, AreTooFewToStandApart) {
  EXPECT_EQ(apart({0, 0.01, 0.5}, 1e-4), std::vector<bool>(3, false));
}

TEST(Losses, AreComparedByWhatTheModelDoesNotExpect) {
  const std::vector<double> more{0, 0.01, 0.02, 0.01, 0, 0.5};
  std::vector<bool> apart_by_itself(6, false);
  apart_by_itself.back() = true;
  EXPECT_EQ(apart(more, 1e-4), apart_by_itself);
  EXPECT_EQ(apart(more, 1e-4, {0, 0, 0, 0, 0, 0.5}), std::vector<bool>(6, false));
}

// Releasing TR2, the tendon sticks at the tip between T3 and T4 with less friction than there is.
TEST(Losses, LeaveOutContactsThatHoldWithLess) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,T1_N,T2_N,T3_N,T4_N\n1,M-1-T-2-M,1,release,10,15,20,25\n");
  const auto found = losses(data, Model{}, compared(data));
  EXPECT_FALSE(found.empty());
  for (const Loss& loss : found) {
    EXPECT_FALSE(segment_name(loss.high) == "T4" || segment_name(loss.low) == "T4");
  }
}

// Two sheaths lose far more than the model says, but there is nothing else of their kind.
TEST(Losses, AreComparedWithThoseOverTheSameContacts) {
  const double t = std::exp(-tube_loss), s = std::exp(-2 * sheath_loss - bearing);
  std::string text = "run,routing,held,T1_N,T2_N,T3_N,T4_N\n";
  for (const char* held : {"", "2"}) {
    text += fmt::format("1,M-1-T-2-F,{},50,{},{},{}\n", held, 50 * t, 50 * t * t, 50 * t * t * t);
  }
  text += fmt::format("1,M-1-P-2-F,1,50,{},{},{}\n", 50 * t, 25 * t * s, 25 * t * t * s);
  const MeasuredData data = read_data(text);
  std::vector<ComparedCell> cells = compared(data);
  for (ComparedCell& cell : cells) {
    if (cell.cell.reading == 2 && cell.cell.channel > 1) cell.after_N *= 2;
  }
  const auto found = losses(data, Model{}, cells);
  ASSERT_EQ(found.size(), 9U);
  EXPECT_NEAR(found[7].measured - found[7].after, std::log(2.0), 1e-9);
  for (const Loss& loss : found) EXPECT_FALSE(loss.stands_apart) << segment_name(loss.high);
}

}  // namespace
}  // namespace reeve::testing
