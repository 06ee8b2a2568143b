// Dimensions that follow by hand from the capstan law, T2/T1 = e^{-mu theta}.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sizing/sizing_of.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve::testing {
namespace {

constexpr double mu = 0.18;

// TR1: T1 = 1, T2 = t, T3 = t e^{-mu theta}, T4 = T3 t, so that P2/P1 = t e^{-mu theta}.
double join_angle_for(double first, double second) {
  return std::log(std::exp(-mu * std::numbers::pi) * first / second) / mu;
}

TEST(TargetShares, GiveTheAngleOfTheJoinBetweenTwoFingers) {
  for (const auto& [first, second] :
       {std::pair{0.7, 0.3}, {0.75, 0.25}, {0.8, 0.2}, {0.65, 0.35}}) {
    const std::string target = "1=" + std::to_string(first) + ",2=" + std::to_string(second);
    const SizedDesign design = sized("M-1-T-2-F", aiming(target, {"contact_angle[T3-T2]=0..9"}));
    EXPECT_NEAR(values_of(design).at(0), join_angle_for(first, second), 1e-6) << target;
    EXPECT_TRUE(is_met(design));
    EXPECT_NEAR(design.after.shares.at(0), first, 1e-9);
  }
}

TEST(TargetShares, GiveTheAngleOfAFingertip) {
  // Of finger 2 alone: T4 = T3 e^{-mu theta}; P2/P1 = t² (1 + e^{-mu theta}) / (1 + t).
  const double t = std::exp(-mu * std::numbers::pi);
  const double theta = 2.5;
  const double ratio = t * t * (1 + std::exp(-mu * theta)) / (1 + t);
  SizingOptions options = aiming("1=1,2=1", {"tip_angle[2]=0..9"});
  options.goal.target = {1 / (1 + ratio), ratio / (1 + ratio)};
  EXPECT_NEAR(values_of(sized("M-1-T-2-F", options)).at(0), theta, 1e-6);
}

TEST(TargetShares, ThatAreOutOfReachAreMissedByAsMuchAsTheBoundLeaves) {
  const SizedDesign design =
      sized("M-1-T-2-F", aiming("1=0.4,2=0.6", {"contact_angle[T2-T3]=1..9"}));
  const double ratio = std::exp(-mu * (std::numbers::pi + 1));
  const double second = ratio / (1 + ratio);
  EXPECT_FALSE(is_met(design));
  EXPECT_NEAR(*design.least_miss, std::sqrt(2.0) * (0.6 - second), 1e-9);
  EXPECT_NEAR(design.nearest_shares.at(1), second, 1e-9);
  EXPECT_EQ(design.variables.at(0).at, AtBound::low);
  EXPECT_EQ(design.variables.at(0).value, 1);
}

// All work goes through the one sheath: efficiency is e^{-mu theta} of what is behind it.
TEST(Tolerance, IsWhereOnePartInAHundredIsLost) {
  SizingOptions options = sizing("efficiency", {"sheath_angle[1]=3..9"});
  const SizedDesign design = sized("M-1-T-2-F", options);
  const SizedVariable& sheath = design.variables.at(0);
  EXPECT_EQ(sheath.value, 3);
  EXPECT_EQ(sheath.at, AtBound::low);
  EXPECT_NEAR(*sheath.sensitivity.more, -std::log(0.99) / mu, 1e-6);
  EXPECT_FALSE(sheath.sensitivity.less);
  EXPECT_NEAR(sheath.sensitivity.slope_more, -mu * design.after.goal, 1e-3 * design.after.goal);
  EXPECT_NEAR(sheath.sensitivity.slope_less, mu * design.after.goal, 1e-3 * design.after.goal);
  const double nominal = 2 * std::numbers::pi;
  EXPECT_NEAR(design.after.goal / design.before.goal, std::exp(mu * (nominal - 3)), 1e-6);
}

TEST(Tolerance, OfATargetIsWhereSharesMissByAHundredthMore) {
  const SizedDesign design =
      sized("M-1-T-2-F", aiming("1=0.7,2=0.3", {"contact_angle[T2-T3]=0..9"}));
  const SizedVariable& join = design.variables.at(0);
  // Both shares move, one up and one down.
  const double off = 0.01 / std::sqrt(2.0);
  EXPECT_NEAR(join.value + *join.sensitivity.more, join_angle_for(0.7 + off, 0.3 - off), 1e-5);
  EXPECT_NEAR(join.value - *join.sensitivity.less, join_angle_for(0.7 - off, 0.3 + off), 1e-5);
}

// Behind two sheaths of one carriage pulley each finger has its own e^{-mu theta}: shares are those
// of the differences between the angles.
TEST(TargetShares, OfASymmetricRoutingGiveSymmetricAngles) {
  SizingOptions options = aiming("1=1,2=1", {"sheath_angle=2..11"});
  options.nominal.hardware.bearing.mu = 0;
  options.nominal.hardware.fingers.push_back({1, {}, {}, {}, 5.0, {}, 1});
  const SizedDesign design = sized("1-P-2-P-1", options);
  ASSERT_EQ(design.variables.size(), 2U);
  EXPECT_GT(design.before.goal, 0.05);
  EXPECT_NEAR(design.variables[0].value, design.variables[1].value, 1e-6);
  EXPECT_NEAR(design.after.goal, 0, 1e-7);
  ASSERT_EQ(design.flat.size(), 1U);
  EXPECT_NEAR(design.flat[0].moves.at(0), design.flat[0].moves.at(1), 1e-3);
  EXPECT_NEAR(std::abs(design.flat[0].moves.at(0)), 0.9, 1e-9);
}

// The extensors follow without tension, and each flexor has the e^{-mu theta} of its own sheath.
TEST(TargetShares, LeaveOutExtensorsThatFollow) {
  SizingOptions options = aiming("1=0.7,2=0.3", {"sheath_angle[1]=1..12"});
  options.nominal.hardware.bearing.mu = 0;
  options.target_grasps = options.grasps = parse_grasps("none@1,-1", 2, 2);
  const SizedDesign design = sized("1x-P-2x+M2-1e+M2-2e", options);
  ASSERT_TRUE(is_met(design));
  EXPECT_NEAR(values_of(design).at(0), 2 * std::numbers::pi - std::log(0.7 / 0.3) / mu, 1e-6);
}

TEST(Sizing, OfTwoFlexorsOnAFingerMindsBothSheaths) {
  SizingOptions options = sizing("efficiency", {"sheath_angle[1]=3..9"}, 1);
  options.grasps = parse_grasps("none", 1);
  const SizedDesign design = sized("M-1x+M2-1x", options);
  EXPECT_EQ(values_of(design).at(0), 3);
  EXPECT_NEAR(design.after.goal, std::exp(-mu * 3), 1e-9);
}

TEST(TargetShares, OfAThumbThatPullsAsTwoFingers) {
  const SizedDesign design =
      sized("M-1-P-2-P-3-M", aiming("1=2,others=1", {"sheath_angle=1..12"}, 3));
  ASSERT_TRUE(is_met(design));
  // Twice the pull behind ln(2)/mu less of sheath; the bearings' 0.001 pi is of the order of 0.02.
  const auto angles = values_of(design);
  EXPECT_NEAR(angles.at(1) - angles.at(0), std::log(2.0) / mu, 0.6);
  EXPECT_NEAR(design.after.shares.at(0), 0.5, 1e-7);
  EXPECT_NEAR(design.after.shares.at(1), 0.25, 1e-7);
  EXPECT_NEAR(design.after.shares.at(2), 0.25, 1e-7);
}

// Only the difference of the angles counts, so that their mean stays as it is.
TEST(Sizing, GoesBackAlongWhatDoesNotMatter) {
  SizingOptions options = sizing("uniformity", {"sheath_angle=4..9"});
  options.nominal.hardware.bearing.mu = 0;
  options.nominal.hardware.fingers.push_back({1, {}, {}, {}, 5.0, {}, 1});
  options.nominal.hardware.fingers.push_back({2, {}, {}, {}, 7.0, {}, 1});
  const SizedDesign design = sized("1-P-2-P-1", options);
  EXPECT_NEAR(design.after.goal, 1, 1e-9);
  EXPECT_NEAR(design.variables.at(0).value, 6, 1e-5);
  EXPECT_NEAR(design.variables.at(1).value, 6, 1e-5);
}

TEST(Sizing, LeavesWhatDoesNotMatterAsItIsAndSaysSo) {
  // Nothing in TR1 depends on how long its strands are: all of it slides.
  const SizedDesign design =
      sized("M-1-T-2-F", sizing("efficiency", {"strand_mm[1]=50..150", "sheath_angle[1]=3..9"}));
  ASSERT_EQ(design.variables.size(), 2U);
  EXPECT_EQ(design.variables[0].variable.name, "strand_mm[1]");
  EXPECT_EQ(design.variables[0].value, 100);
  EXPECT_FALSE(design.variables[0].sensitivity.less);
  EXPECT_FALSE(design.variables[0].sensitivity.more);
  EXPECT_EQ(design.variables[1].value, 3);
  ASSERT_EQ(design.flat.size(), 1U);
  EXPECT_EQ(design.flat[0].moves, (std::vector<double>{10, 0}));
  EXPECT_EQ(design.flat[0].loss, 0);
}

// Of a bar's equal pulls the motor force is the greater of f l / a of the fingers, and the stroke
// goes with the sum of the arms a: both arms times two leave their product.
TEST(Sizing, SaysThatPowerStaysIfAllArmsGrowAlthoughItHasAnEdgeThere) {
  SizingOptions options = sizing("motor_power", {"arm_mm=4..14"});
  options.nominal.hardware = hand_of({simple_finger(9, 90, 60, 5), simple_finger(9, 90, 60, 4)});
  options.grasps = parse_grasps("none", 2);
  const SizedDesign design = sized("M-W1+1x-W1-2x", options);
  const std::vector<double> arms = values_of(design);
  ASSERT_EQ(arms.size(), 2U);
  EXPECT_NEAR(arms[0] / arms[1], 5.0 / 4, 1e-4);
  ASSERT_EQ(design.flat.size(), 1U);
  EXPECT_NEAR(design.flat[0].moves[0] / design.flat[0].moves[1], 5.0 / 4, 1e-3);
  EXPECT_NEAR(std::abs(design.flat[0].moves[0]), 1, 1e-9);
}

Hardware gripper(double sheath_angle) {
  Hardware hardware;
  hardware.bearing.mu = 0.01;
  hardware.tube.mu = 0.1;
  hardware.sheath = {0.08, sheath_angle};
  return hardware;
}

// A bar parts the pull as its arms say, whatever is before it: what a miss of 1e-16 changes by
// there is rounding.
TEST(Sizing, TakesRoundingForNoGain) {
  const std::vector<std::string> dimensions{"sheath_angle=0.5..3", "sheath_angle=1..3",
                                            "motor_side_mm=100..400", "strand_mm=50..300"};
  for (const double angle : {1.0, 1.3, 1.7, 2.2}) {
    for (const bool robust : {false, true}) {
      SizingOptions options = aiming("1=2,2=1", dimensions);
      for (const std::string& dimension : dimensions) {
        options.varied = {parse_varied(dimension)};
        options.nominal.hardware = gripper(angle);
        options.robust = robust;
        options.draws = 5;
        options.starts = 2;
        options.evaluations = 100;
        const SizedDesign design = sized("M-W1+1x-W1/2:1-2x", options);
        EXPECT_EQ(design.after.goal, design.before.goal) << dimension;
        for (const SizedVariable& variable : design.variables) {
          EXPECT_EQ(variable.value, variable.variable.nominal) << dimension << ' ' << angle;
          EXPECT_EQ(variable.sensitivity.slope_less, 0) << dimension;
          EXPECT_EQ(variable.sensitivity.slope_more, 0) << dimension;
        }
      }
    }
  }
}

// Of the sheath between carriage and block none of the shares depends.
TEST(Sizing, KeepsWhatDoesNotMatterBesideWhatDoes) {
  SizingOptions options = aiming("1=3,2=1,3=2", {"strand_mm=50..200", "sheath_angle=1..4"}, 3);
  options.nominal.hardware = gripper(2.2);
  options.nominal.hardware.block = {0.01, 3};
  const SizedDesign design = sized("M-Y1+1x-Y1-W1+2x-W1/1:2-3x", options);
  ASSERT_EQ(design.variables.size(), 4U);
  EXPECT_EQ(design.variables.back().variable.name, "contact_angle[a-h1]");
  EXPECT_EQ(design.variables.back().value, 2.2);
}

// Bounds that the hardware is outside of hold all the same.
TEST(Sizing, GoesToTheNearestBoundWithWhatDoesNotMatter) {
  SizingOptions options = aiming("1=2,2=1", {"sheath_angle=2..3"});
  options.nominal.hardware = gripper(1);
  EXPECT_EQ(values_of(sized("M-W1+1x-W1/2:1-2x", options)), std::vector<double>{2});
}

}  // namespace
}  // namespace reeve::testing
