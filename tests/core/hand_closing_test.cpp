#include "core/hand_closing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tests/core/network_of.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::network_of;
using testing::simple_finger;

// A finger whose strands give up this much; an arm of so many mm over one radian.
FingerParts finger_with(double excursion_mm) {
  return simple_finger(excursion_mm, 180 / std::numbers::pi, 60, 5);
}

Hardware hand_with(const std::vector<double>& excursions_mm) {
  std::vector<FingerParts> fingers;
  for (const double excursion : excursions_mm) fingers.push_back(finger_with(excursion));
  return hand_of(fingers);
}

HandClosing closing_of(const std::string& word, const Hardware& hardware, const Grasp& open = {}) {
  const Network net = network_of(word);
  Kinematics kinematics;
  Motion motion;
  return close_hand(*hand(hardware), net, mechanics(net, hardware), kinematics, motion, open);
}

// It is then fixed, as one at F is.
TEST(HandClosing, WithALockedEndIsThatOfATendonThatIsFixedThere) {
  const Hardware hardware = hand_with({10, 10});
  const HandClosing locked = closing_of("M-1-T-2-M", hardware, {0, {}, 2});
  EXPECT_DOUBLE_EQ(locked.stroke_mm, closing_of("M-1-T-2-F", hardware).stroke_mm);
  EXPECT_DOUBLE_EQ(locked.stroke_mm, 40);
  EXPECT_EQ(locked.closure, 1);
}

TEST(HandClosing, EndsOfUnequalSpoolsCloseFingersOfUnequalExcursionsTogether) {
  Hardware hardware = hand_with({12, 6});
  EXPECT_DOUBLE_EQ(closing_of("1x-M+2x-M", hardware).stroke_mm, 6);
  hardware.spools = {{"b", 0.5}};
  const HandClosing closing = closing_of("1x-M+2x-M", hardware);
  EXPECT_DOUBLE_EQ(closing.stroke_mm, 12);
  EXPECT_EQ(closing.closure, 1);
}

// Finger 2 begins after 5 mm. Finger 1 has closed after 12 mm, and its tendon then blocks the
// carriage.
TEST(HandClosing, OfATendonWithSlackBeginsLater) {
  Hardware hardware = hand_with({12, 12});
  hardware.tendon = {{}, 40, {{2, {}, 5}}};
  const HandClosing closing = closing_of("1x-M+2x-M", hardware);
  EXPECT_DOUBLE_EQ(closing.stroke_mm, 12);
  EXPECT_DOUBLE_EQ(closing.closed[2], 7.0 / 12);
  EXPECT_EQ(closing.closed[1], 1);
  // Both ends take slack in, and slack of all tendons is travel before anything moves.
  hardware.tendon = {{}, 40, {{1, {}, 3}, {2, {}, 10}}};
  const HandClosing later = closing_of("1x-M+M-2x", hardware);
  EXPECT_DOUBLE_EQ(later.stroke_mm, 3 + 12);
  EXPECT_DOUBLE_EQ(later.closed[2], 5.0 / 12);
  const HandClosing both = closing_of("1x-M+M-2-M", hardware);
  EXPECT_DOUBLE_EQ(both.stroke_mm, 3 + 12);
  EXPECT_DOUBLE_EQ(both.closed[2], 10.0 / 12);
}

struct ClosedForm {
  const char* word;
  std::vector<double> excursions_mm;
  double stroke_mm;
  std::vector<double> closed;
};

// By hand: what the motor-side segments take is what strands and blocks give.
TEST(HandClosing, OfRoutingsWorkedByHand) {
  const std::vector<ClosedForm> cases{
      {"M-1-T-2-F", {12, 20}, 2 * (12 + 20), {1, 1}},
      {"1-P-2-P-1", {12, 20}, 2 * (12 + 20) / 4.0, {1, 1}},
      {"M-1x", {12}, 12, {1}},
      // The shorter tendon blocks the carriage for the longer one.
      {"M-1-M+M-2-M", {12, 20}, 12, {1, 0.6}},
      {"M-1-F+M-2-M", {12, 20}, 20, {20 / 24.0, 1}},
      // A pulley at the hand: 2 z = E1 + E2, and the carriage goes with it.
      {"M-Y1+1x-Y1-2x", {12, 20}, 16, {1, 1}},
      {"M-Y1+F-1-Y1-2x", {12, 20}, (2 * 12 + 20) / 2.0, {1, 1}},
      // Two tendons over one block: the one with less to give stops it.
      {"M-Y1+1x-Y1-2x+3x-Y1-4x", {12, 20, 14, 30}, 16, {1, 1, -1, -1}},
      // And the finger on the block's own tendon goes on.
      {"M-5-Y1+1x-Y1-2x+3x-Y1-4x", {12, 20, 14, 30, 50}, 16 + 2 * 50, {1, 1, -1, -1, 1}},
  };
  for (const ClosedForm& expected : cases) {
    SCOPED_TRACE(expected.word);
    const HandClosing found = closing_of(expected.word, hand_with(expected.excursions_mm));
    EXPECT_NEAR(found.stroke_mm, expected.stroke_mm, 1e-9);
    for (std::size_t f = 0; f < expected.closed.size(); ++f) {
      if (expected.closed[f] < 0) continue;
      EXPECT_NEAR(found.closed[f + 1], expected.closed[f], 1e-9) << "finger " << f + 1;
    }
    EXPECT_EQ(found.closure,
              *std::min_element(
                  found.closed.begin() + 1,
                  found.closed.begin() + 1 + static_cast<std::ptrdiff_t>(expected.closed.size())));
  }
}

TEST(HandClosing, IsExactlyWholeWhereNothingBlocksTheCarriage) {
  EXPECT_EQ(closing_of("1-P-2-T-3-P-1", hand_with({12.3, 20.1, 17.7})).closure, 1);
}

// The carriage pulled in by steps, each finger held from where its excursion is used up.
double stroke_by_steps(const std::string& word, const Hardware& hardware, double step_mm) {
  const Network net = network_of(word);
  const Mechanics parts = mechanics(net, hardware);
  const Hand known = *hand(hardware);
  std::vector<double> given(static_cast<std::size_t>(net.fingers), 0.0);
  Grasp at_end;
  for (double travel = 0;; travel += step_mm) {
    const TensionState state = tensions(net, parts, at_end);
    if (state.jams || *std::max_element(state.closing.begin(), state.closing.end()) == 0) {
      return travel;
    }
    for (int f = 1; f <= net.fingers; ++f) {
      double& length = given[static_cast<std::size_t>(f) - 1];
      length += step_mm * state.closing[static_cast<std::size_t>(f) - 1];
      if (length >= known.finger(f).excursion_mm) at_end.held |= std::uint64_t{1} << (f - 1);
    }
  }
}

TEST(HandClosing, IsWhatTheCarriageTravelsInSmallSteps) {
  constexpr double step = 0.01;
  for (const char* word : {"M-1-T-2-P-3-F+M-4-M", "M-Y1+1x-Y1-2x+3x-Y1-4x",
                           "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", "M-Y1+1x-Y1-Y2+2x-Y2-3x+M-4-F"}) {
    const Hardware hardware = hand_with({12, 20, 14, 31});
    // Each finger may be seen to have closed a step late.
    EXPECT_NEAR(closing_of(word, hardware).stroke_mm, stroke_by_steps(word, hardware, step),
                10 * step)
        << word;
  }
}

}  // namespace
}  // namespace reeve
