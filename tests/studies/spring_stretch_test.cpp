// The stroke of hands whose springs in series stretch, against closed forms and a solver of tendons
// in parallel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Dice;

constexpr double stiff_EA_N = 1e9;

// Each newton of pull is arm over lever newtons at the tip; an arm of this excursion over 1 rad.
FingerParts finger_of(double excursion_mm, double lever_mm, double force_N) {
  return testing::simple_finger(excursion_mm, 180 / std::numbers::pi, lever_mm, force_N);
}

Hardware sprung_hand(const std::vector<FingerParts>& fingers, double EA_N,
                     const std::vector<double>& stiffnesses) {
  Hardware hardware = testing::hand_of(fingers);
  hardware.tendon.EA_N = EA_N;
  for (const double stiffness : stiffnesses) {
    hardware.tendon.own.push_back(
        {static_cast<int>(hardware.tendon.own.size()) + 1, stiffness, {}});
  }
  return hardware;
}

MotorForce need_of(const std::string& word, const Hardware& hardware,
                   const std::string& grasps = "none") {
  const Routing routing = parse_routing(word);
  UncertaintyOptions options{Model{hardware},
                             {},
                             parse_grasps(grasps, finger_count(routing), carriage_count(routing)),
                             {}};
  options.draws = 1;
  return *search::motor_force(routing, options);
}

TEST(SpringStretch, OfOneTendonIsTheMotorForceOverTheStiffness) {
  const Hardware hardware = sprung_hand({finger_of(10, 60, 5)}, stiff_EA_N, {4});
  const MotorForce need = need_of("M-1-F", hardware, "none/1");
  EXPECT_NEAR(need.stroke_mm, 2 * 10 + need.nominal_N / 4, 1e-9);
  EXPECT_NEAR(need.motors.at(0).stroke_mm, need.stroke_mm, 1e-9);
  EXPECT_FALSE(need.springs);
}

// The spring of a block's tail carries the whole motor force, whatever hangs on the block.
TEST(SpringStretch, OfATailIsThatOfItsOwnTension) {
  const Hardware hardware =
      sprung_hand({finger_of(12, 60, 5), finger_of(20, 60, 5)}, stiff_EA_N, {4});
  const MotorForce need = need_of("M-Y1+1x-Y1-2x", hardware, "single");
  EXPECT_NEAR(need.stroke_mm, 16 + need.nominal_N / 4, 1e-9);
}

// Both springs stretch alike: F = (k1 + k2) s. The softer one sets the stretch.
TEST(SpringStretch, OfUnequalSpringsOnACarriageIsThatOfSpringsInParallel) {
  const Hardware hardware =
      sprung_hand({finger_of(10, 60, 5), finger_of(10, 60, 5)}, stiff_EA_N, {2, 6});
  const MotorForce need = need_of("M-1x+M-2x", hardware);
  const double stretch_mm = 5 * 60 / 10.0 / std::exp(-hardware.sheath.exponent()) / 2;
  EXPECT_NEAR(need.nominal_N, (2 + 6) * stretch_mm, 1e-3);
  EXPECT_NEAR(need.stroke_mm, 10 + stretch_mm, 1e-5);
}

// Half a spool takes half as much in, and pulls its motor with half the tension.
TEST(SpringStretch, IsTravelOfTheCarriageBehindASpool) {
  Hardware hardware = sprung_hand({finger_of(10, 60, 5)}, stiff_EA_N, {4});
  hardware.spools = {{"a", 0.5}};
  const MotorForce need = need_of("M-1-F", hardware);
  EXPECT_NEAR(need.stroke_mm, (2 * 10 + need.nominal_N / 0.5 / 4) / 0.5, 1e-9);
}

TEST(SpringStretch, IsOfEachMotorAndNotOfOneThatLetsOut) {
  const Hardware hardware =
      sprung_hand({finger_of(10, 60, 5), finger_of(10, 60, 8)}, stiff_EA_N, {4, 5, 3});
  const MotorForce need = need_of("M-1x+M2-2x+M3-1e", hardware, "none@1,1,-1");
  ASSERT_EQ(need.motors.size(), 3U);
  EXPECT_NEAR(need.motors[0].stroke_mm, 10 + need.motors[0].force_N / 4, 1e-9);
  EXPECT_NEAR(need.motors[1].stroke_mm, 10 + need.motors[1].force_N / 5, 1e-9);
  EXPECT_NEAR(need.motors[2].stroke_mm, 10, 1e-9);
}

// A carriage that is blocked before the hand has closed would go on as far as springs let it.
TEST(SpringStretch, IsLeftOutAndSaidSoWhereTheHandDoesNotClose) {
  const Hardware hardware =
      sprung_hand({finger_of(10, 60, 5), finger_of(14, 60, 5)}, stiff_EA_N, {4, 4});
  const MotorForce need = need_of("M-1x+M-2x", hardware);
  EXPECT_EQ(need.stroke_mm, 10);
  EXPECT_TRUE(need.springs);
  const Hardware alike =
      sprung_hand({finger_of(10, 60, 5), finger_of(10, 60, 5)}, stiff_EA_N, {4, 4});
  const MotorForce held = need_of("M-1x+M-2x", alike, "single");
  EXPECT_TRUE(std::isinf(held.nominal_N));
  EXPECT_EQ(held.stroke_mm, 10);
  EXPECT_TRUE(held.springs);
}

TEST(SpringStretch, TakesItsEnergyFromTheMotor) {
  const Hardware hardware = sprung_hand({finger_of(10, 60, 5)}, stiff_EA_N, {4});
  const std::string word = "M-1-F";
  const MotorDemand demand = studies::shown_hand(expand(parse_routing(word)), word, Model{hardware},
                                                 parse_grasps("none", 1))
                                 ->demand;
  const double force_N = demand.force_N;
  EXPECT_NEAR(demand.stroke_mm, 20 + force_N / 4, 1e-9);
  EXPECT_NEAR(demand.springs_J, force_N * force_N / 4 / 2 / 1000, 1e-9);
  EXPECT_NEAR(demand.work_J, force_N * 20 / 1000 + demand.springs_J, 1e-9);
  EXPECT_NEAR(demand.work_J, demand.springs_J + demand.friction_J + demand.fingers_J, 1e-9);
  const ObjectiveValues values =
      DesignEvaluator(Model{hardware}, parse_grasps("none", 1)).evaluate(parse_routing(word));
  EXPECT_NEAR(value(values, Objective::motor_power), demand.power_W, 1e-9);
  EXPECT_NEAR(value(values, Objective::stroke), demand.stroke_mm, 1e-9);
}

// A tendon of one finger that stands at its stop, and its spring.
struct ParallelTendon {
  std::string word;
  double need_N = 0;     // at the motor, for the wanted force
  double give_mm_N = 0;  // of tendon and spring, per newton at the motor
  double stiffness_N_mm = 0;
};

struct ParallelHand {
  std::vector<ParallelTendon> tendons;
  Hardware hardware;
};

// Fingers whose tendons are closed at the same travel.
ParallelHand random_hand(Dice& dice, double stroke_mm) {
  constexpr double EA_N = 5000;
  ParallelHand made;
  std::vector<FingerParts> fingers;
  std::vector<double> stiffnesses;
  const Hardware plain;
  for (int f = 1; f <= 3; ++f) {
    const bool is_tied = dice.chance(0.5);
    const double lever_mm = dice.real(20, 80);
    const double force_N = dice.real(1, 10);
    const double excursion_mm = stroke_mm / (is_tied ? 1 : 2);
    fingers.push_back(finger_of(excursion_mm, lever_mm, force_N));
    stiffnesses.push_back(dice.log_real(0.5, 50));
    const double in = std::exp(-plain.sheath.exponent());
    const double out = is_tied ? 0 : in * std::exp(-plain.tube.exponent());
    made.tendons.push_back(
        {fmt::format("M-{}{}", f, is_tied ? "x" : "-F"),
         force_N * lever_mm / excursion_mm / (in + out),
         1 / stiffnesses.back() + (plain.motor_side_mm + plain.strand_mm * (in + out)) / EA_N,
         stiffnesses.back()});
  }
  made.hardware = sprung_hand(fingers, EA_N, stiffnesses);
  return made;
}

TEST(SpringStretch, IsThatOfTendonsThatTheCarriageStretchesAlike) {
  constexpr double closed_mm = 15;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    const ParallelHand made = random_hand(dice, closed_mm);
    double beyond_mm = 0;
    std::string word;
    for (const ParallelTendon& tendon : made.tendons) {
      beyond_mm = std::max(beyond_mm, tendon.need_N * tendon.give_mm_N);
      word += (word.empty() ? "" : "+") + tendon.word;
    }
    double force_N = 0;
    double stretch_mm = 0;
    for (const ParallelTendon& tendon : made.tendons) {
      const double tension_N = beyond_mm / tendon.give_mm_N;
      force_N += tension_N;
      stretch_mm = std::max(stretch_mm, tension_N / tendon.stiffness_N_mm);
    }
    SCOPED_TRACE(word);
    const MotorForce need = need_of(word, made.hardware);
    EXPECT_NEAR(need.nominal_N, force_N, 1e-9 * force_N);
    EXPECT_NEAR(need.stroke_mm, closed_mm + stretch_mm, 1e-8);
  }
}

}  // namespace
}  // namespace reeve
