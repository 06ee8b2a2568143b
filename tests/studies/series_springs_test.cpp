// Strokes and work of hands whose springs in series stretch: closed forms, and the equilibrium of
// tendons without friction, solved at once for carriage, blocks and tensions.
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/random_mechanism.hpp"

namespace reeve {
namespace {

using testing::Dice;

// An arm of this excursion over one radian, and no spring at the joint.
FingerParts finger_of(double excursion_mm, double force_N = 5) {
  return testing::simple_finger(excursion_mm, 180 / std::numbers::pi, 60, force_N);
}

Hardware sprung_hand(const std::vector<double>& excursions_mm,
                     const std::vector<TendonHardware>& springs) {
  std::vector<FingerParts> fingers;
  for (const double excursion : excursions_mm) fingers.push_back(finger_of(excursion));
  Hardware hardware = testing::hand_of(fingers);
  hardware.tendon = {1e9, {}, springs};
  return hardware;
}

Hardware without_friction(Hardware hardware) {
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  return hardware;
}

ShownHand shown_of(const std::string& word, const Hardware& hardware,
                   const std::string& grasps = "none") {
  const Network network = expand(parse_routing(word));
  return *studies::shown_hand(network, word, Model{hardware},
                              parse_grasps(grasps, network.fingers, 1, motor_ends(network)));
}

MotorDemand demand_of(const std::string& word, const Hardware& hardware,
                      const std::string& grasps = "none") {
  return shown_of(word, hardware, grasps).demand;
}

void expect_balance(const MotorDemand& demand) {
  EXPECT_NEAR(demand.work_J,
              demand.springs_J + demand.series_J + demand.friction_J + demand.fingers_J, 1e-9);
}

// E = 10, k = 4: D = 2 E + F / k. The sheath passes s of F, the tip t of that, so that the finger
// gets F s (1 + t).
TEST(SeriesSprings, OfOneTendonStretchByTheMotorForceOverTheStiffness) {
  const Hardware hardware = sprung_hand({10}, {{1, 4.0, {}}});
  const MotorDemand demand = demand_of("M-1-F", hardware, "none/1");
  const double s = std::exp(-hardware.sheath.exponent());
  const double t = std::exp(-hardware.tube.exponent());
  const double F = 5 * 60 / 10.0 / (s * (1 + t));
  EXPECT_NEAR(demand.force_N, F, 1e-9);
  EXPECT_NEAR(demand.stretch_mm(), F / 4, 1e-9);
  EXPECT_NEAR(demand.stroke_mm, 20 + F / 4, 1e-9);
  EXPECT_NEAR(demand.series_J, F * F / 8 / 1000, 1e-9);
  EXPECT_NEAR(demand.friction_J, F * (20 - 10 * s * (1 + t)) / 1000, 1e-9);
  EXPECT_NEAR(demand.work_J, (F * 20 + F * F / 8) / 1000, 1e-9);
  EXPECT_NEAR(demand.power_W, F * (20 + F / 4) / 1000, 1e-9);
  expect_balance(demand);
}

// Half a spool takes half as much in and pulls its motor with half the tension.
TEST(SeriesSprings, BehindASpoolStretchByMoreOfTheCarriagesTravel) {
  Hardware hardware = sprung_hand({10}, {{1, 4.0, {}}});
  hardware.spools = {{"a", 0.5}};
  const MotorDemand demand = demand_of("M-1-F", hardware);
  EXPECT_NEAR(demand.stroke_mm, (20 + demand.force_N / 0.5 / 4) / 0.5, 1e-9);
  EXPECT_NEAR(demand.series_J, std::pow(demand.force_N / 0.5, 2) / 8 / 1000, 1e-9);
  expect_balance(demand);
}

// Both ends take D in, and one of them gives s = F / 2 k back: 2 D − s = 2 E.
TEST(SeriesSprings, AtOneOfTwoEndsStretchByHalfOfTheirCarriagesTravel) {
  const Network network = expand(parse_routing("M-1-M"));
  Hardware hardware;
  Mechanics parts = mechanics(network, hardware);
  const TensionState state = tensions(network, parts, Grasp{});
  parts.EA_N = 1000;
  parts.springs_mm = {parts.EA_N / 4, 0, 0, 0};
  const SeriesStretch stretch = series_stretch(network, parts, Grasp{}, state);
  EXPECT_NEAR(stretch.travel_mm(80), 80 / 2.0 / 4 / 2, 1e-12);
  EXPECT_NEAR(stretch.stored_J(80), 40 * 40 / 8.0 / 1000, 1e-12);
  EXPECT_FALSE(stretch.is_lossless);  // tendon slips out of one sheath and into the other
  // It slips there by s / 2 = 2 D, and the other way on the way, by D.
  EXPECT_NEAR(stretch.sliding_mm_N * 80, 80 / 2.0 / 4 / 2, 1e-12);
  // A hardware file says no end, and none is the only one.
  hardware = sprung_hand({10}, {{1, 4.0, {}}});
  EXPECT_EQ(MechanicsBuilder(hardware).unmatched_tendons(network), (std::vector<std::string>{"1"}));
}

// Three sides, all sliding in: T_b = t T_a, T_c = t r T_a. 3 D − T_a / k = 2 (E1 + E2).
TEST(SeriesSprings, BesideAPulleyOfTheCarriageTakeAThirdOfTheirStretch) {
  const Hardware hardware = sprung_hand({12, 12}, {{1, 200.0, {}}});
  const double t = std::exp(-hardware.tube.exponent());
  const double r = std::exp(-hardware.bearing.exponent());
  const MotorDemand demand = demand_of("M-1-P-2-F", hardware);
  const double T = demand.force_N / (1 + t + t * r);
  EXPECT_NEAR(demand.stretch_mm(), T / 200 / 3, 1e-9);
  EXPECT_NEAR(demand.stroke_mm, (48 + T / 200) / 3, 1e-9);
  EXPECT_NEAR(demand.series_J, T * T / 400 / 1000, 1e-9);
  // At most F D, since the force rises with the stretch; friction then is not told apart.
  EXPECT_NEAR(demand.work_J, demand.force_N * demand.stroke_mm / 1000, 1e-9);
  EXPECT_TRUE(std::isnan(demand.friction_J));
  EXPECT_TRUE(std::isnan(demand.fingers_J));
  const MotorDemand ideal = demand_of("M-1-P-2-F", without_friction(hardware));
  EXPECT_NEAR(ideal.stretch_mm(), ideal.force_N / 3 / 200 / 3, 1e-9);
  EXPECT_NEAR(ideal.work_J, (ideal.force_N * 16 + std::pow(ideal.force_N / 3, 2) / 400) / 1000,
              1e-9);
  EXPECT_NEAR(ideal.friction_J, 0, 1e-12);
  expect_balance(ideal);
}

// Side a takes D₀ in, and strand 1 gives 3/4 D₀ up: 1/4 D₀ slips round tip 1. Back slips
// T_a / k − ΔD = 2 ΔD, at most that.
TEST(SeriesSprings, SoSoftThatTendonSlipsBackRoundATipAreNotCounted) {
  const auto shown = [](double stiffness) {
    return shown_of("M-1-P-2-F", sprung_hand({12, 12}, {{1, stiffness, {}}}));
  };
  const double force_N = shown(200).demand.force_N;
  const double limit = 200 * shown(200).demand.stretch_mm() * 8 / 16;
  EXPECT_EQ(shown(1.01 * limit).demand.force_N, force_N);
  EXPECT_TRUE(shown(1.01 * limit).demand.stretch);
  EXPECT_FALSE(shown(0.99 * limit).demand.stretch);
  EXPECT_TRUE(shown(0.99 * limit).leaves_out_springs());
  EXPECT_NEAR(shown(0.99 * limit).demand.stroke_mm, 16, 1e-9);
}

// With all ends free 3 D = 2 (E1 + E2) + T_a / k, with a locked 2 D = 2 (E1 + E2) + T_a / k. The
// first grasp has the greater stretch, the second the longer way: the stroke is that of one grasp.
class SpringsOfTwoGrasps : public ::testing::Test {
 protected:
  static constexpr double E = 12;
  static constexpr double k = 50;

  ShownHand shown_with(std::optional<double> stroke_mm, std::optional<double> force_N) {
    Hardware hardware = sprung_hand({E, E}, {{1, k, {}}});
    hardware.motor.stroke_mm = stroke_mm;
    hardware.motor.force_N = force_N;
    return shown_of("M-1-P-2-F", hardware, "none/a");
  }
  // Per newton of the motor.
  double stretch_mm_N(const std::string& grasp) const {
    const Network network = expand(parse_routing("M-1-P-2-F"));
    const Mechanics parts = mechanics(network, sprung_hand({E, E}, {{1, k, {}}}));
    const Grasp held = parse_grasp(grasp, 2, 1, motor_ends(network));
    return tensions(network, parts, held).tension[0] / k / (grasp == "a" ? 2 : 3);
  }
};

TEST_F(SpringsOfTwoGrasps, LengthenTheWayOfTheirOwnGrasp) {
  const MotorDemand demand = shown_with({}, {}).demand;
  const double F = demand.force_N;
  ASSERT_TRUE(demand.stretch);
  ASSERT_GT(stretch_mm_N("none"), 2 * stretch_mm_N("a"));
  ASSERT_LT(16 + F * stretch_mm_N("none"), 24 + F * stretch_mm_N("a"));
  EXPECT_NEAR(demand.stretch_mm(), F * stretch_mm_N("a"), 1e-9);
  EXPECT_NEAR(demand.stroke_mm, 24 + F * stretch_mm_N("a"), 1e-9);
  EXPECT_NEAR(demand.power_W, F * demand.stroke_mm / 1000, 1e-9);
  EXPECT_NEAR(demand.work_J, F * demand.stroke_mm / 1000, 1e-9);
}

TEST_F(SpringsOfTwoGrasps, TakeTheirPartOfAShortStrokeEachInItsOwnGrasp) {
  const double F = shown_with({}, {}).demand.force_N;
  const StrokeReach reach = *shown_with(20, {}).stroke_reach;
  EXPECT_NEAR(reach.closure, (20 - F * stretch_mm_N("a")) / 24, 1e-9);
  EXPECT_NEAR(reach.stretch_mm, F * stretch_mm_N("a"), 1e-9);
  EXPECT_NEAR(reach.stroke_mm, 20, 1e-9);
}

TEST_F(SpringsOfTwoGrasps, LengthenTheStrokeAtTheMotorsForce) {
  const double F = shown_with({}, {}).demand.force_N;
  EXPECT_NEAR(*shown_with({}, F / 2).force_reach->stroke_mm, 24 + F / 2 * stretch_mm_N("a"), 1e-9);
  // Beyond the force at which tendon slips back there is no stroke that is known.
  EXPECT_FALSE(shown_with({}, 10 * F).force_reach->stroke_mm);
}

TEST_F(SpringsOfTwoGrasps, AreTheSameInTheObjectives) {
  const Hardware hardware = sprung_hand({E, E}, {{1, k, {}}});
  const Routing routing = parse_routing("M-1-P-2-F");
  const GraspSet grasps = parse_grasps("none/a", 2, 1, motor_ends(expand(routing)));
  const MotorDemand demand = shown_with({}, {}).demand;
  const ObjectiveValues values = DesignEvaluator(Model{hardware}, grasps).evaluate(routing);
  EXPECT_NEAR(value(values, Objective::stroke), demand.stroke_mm, 1e-9);
  EXPECT_NEAR(value(values, Objective::motor_power), demand.power_W, 1e-9);
}

Hardware slack_hand(const std::vector<double>& excursions_mm,
                    const std::vector<TendonHardware>& tendons) {
  Hardware hardware = sprung_hand(excursions_mm, tendons);
  hardware.tendon.travel_mm = 60;
  return hardware;
}

// The sheath passes s of F, the tip t of that: F E s (1 + t) of F 2 E reach the finger.
TEST(SlackOfAHand, TakesStrokeAndNoWork) {
  const Hardware hardware = slack_hand({10}, {{1, {}, 6}});
  const MotorDemand demand = demand_of("M-1-F", hardware, "none/1");
  const double s = std::exp(-hardware.sheath.exponent());
  const double t = std::exp(-hardware.tube.exponent());
  EXPECT_NEAR(demand.stroke_mm, 6 + 20, 1e-9);
  EXPECT_NEAR(demand.power_W, demand.force_N * 26 / 1000, 1e-9);
  EXPECT_NEAR(demand.work_J, demand.force_N * 20 / 1000, 1e-9);
  EXPECT_NEAR(demand.friction_J, demand.force_N * (20 - 10 * s * (1 + t)) / 1000, 1e-9);
  EXPECT_EQ(demand_of("M-1-F", without_friction(hardware)).friction_J, 0);
  expect_balance(demand);
}

TEST(SlackOfAHand, IsTakenInBeforeSpringsStretch) {
  const MotorDemand demand = demand_of("M-1-F", slack_hand({10}, {{1, 4.0, 6}}));
  const double F = demand.force_N;
  EXPECT_NEAR(demand.stroke_mm, 6 + 20 + F / 4, 1e-9);
  EXPECT_NEAR(demand.work_J, (F * 20 + F * F / 8) / 1000, 1e-9);
  expect_balance(demand);
}

// Fingers 1 and 2 are closed at 6 mm and at 10 mm. While tendon 2 is slack, tendon 1 pulls.
TEST(SlackOfAHand, OfOneTendonTakesTheWorkOfTheOthers) {
  Hardware hardware = without_friction(slack_hand({10, 4}, {{2, {}, 6}}));
  const MotorDemand demand = demand_of("M-1x+M-2x", hardware);
  EXPECT_NEAR(demand.closure, 1, 1e-9);
  EXPECT_NEAR(demand.work_J, demand.force_N * 10 / 1000, 1e-9);
  EXPECT_EQ(demand.friction_J, 0);
}

TEST(SlackOfAHand, TakesNoWorkOfItsOwnMotor) {
  const Hardware hardware = slack_hand({10, 10}, {{2, {}, 6}});
  const Network network = expand(parse_routing("M-1-F+M2-2-F"));
  const MotorDemand demand =
      studies::shown_hand(network, "M-1-F+M2-2-F", Model{hardware}, {{Grasp{}, 1}})->demand;
  EXPECT_NEAR(demand.strokes_mm[1], 26, 1e-9);
  EXPECT_NEAR(demand.work_J, (demand.motors_N[0] * 20 + demand.motors_N[1] * 20) / 1000, 1e-9);
  EXPECT_NEAR(demand.power_W, (demand.motors_N[0] * 20 + demand.motors_N[1] * 26) / 1000, 1e-9);
}

// At the end T_1 / k = T_2 / k = D − D₀, both being closed at D₀ = 10 mm: the shares of the motor
// force, 1 and 1 − 6 / 60, are not those. With other excursions even F alone does not give them.
TEST(SlackOfAHand, BesideSpringsOfATreeOnTheSameCarriageLeavesTheirStretchOut) {
  const Hardware hardware = slack_hand({10, 4}, {{1, 8.0, {}}, {2, 8.0, 6}});
  const ShownHand shown = shown_of("M-1x+M-2x", hardware);
  EXPECT_TRUE(shown.leaves_out_springs());
  EXPECT_EQ(shown.slack_shared_at_mm, 60);
  EXPECT_NEAR(shown.demand.stroke_mm, 10, 1e-9);
  EXPECT_FALSE(shown_of("M-1x+M-2x", sprung_hand({10, 10}, {{1, 8.0, {}}})).slack_shared_at_mm);
  EXPECT_FALSE(shown_of("M-1-F", slack_hand({10}, {{1, {}, 6}})).slack_shared_at_mm);
}

// The tail's tendon: D − s = z. The other: D + 2 z = 2 (E1 + E2). Together 3 D − 2 s.
TEST(SeriesSprings, OfATailCountTwiceInATreeOfTwoMotorSides) {
  const Hardware hardware = without_friction(sprung_hand({12, 12}, {{1, 50.0, {}}}));
  const MotorDemand demand = demand_of("M-Y1+M-1-Y1-2-F", hardware);
  const double T = 2 * demand.force_N / 3;
  EXPECT_NEAR(demand.stretch_mm(), 2 * T / 50 / 3, 1e-9);
  EXPECT_NEAR(demand.stroke_mm, (48 + 2 * T / 50) / 3, 1e-9);
  EXPECT_NEAR(demand.series_J, T * T / 100 / 1000, 1e-9);
  expect_balance(demand);
}

// Both springs stretch by s: F = (k1 + k2) s.
TEST(SeriesSprings, OfTwoTreesOnACarriageAreSpringsInParallel) {
  const Hardware hardware = sprung_hand({10, 10}, {{1, 2.0, {}}, {2, 6.0, {}}});
  const MotorDemand demand = demand_of("M-1x+M-2x", hardware);
  const double s = 5 * 60 / 10.0 / std::exp(-hardware.sheath.exponent()) / 2;
  EXPECT_NEAR(demand.force_N, (2 + 6) * s, 1e-3);
  EXPECT_NEAR(demand.stroke_mm, 10 + s, 1e-5);
  EXPECT_TRUE(std::isnan(demand.friction_J));
}

// Take-up is shared: T_1 (1/k + 1/K) = T_2 / K, K = EA / L of each tendon.
TEST(SeriesSprings, OfOneOfTwoTreesStretchByTheShareOfTheirTree) {
  Hardware hardware = sprung_hand({10, 10}, {{1, 2.0, {}}});
  hardware.tendon.EA_N = 5000;
  const double K = 5000 / (100 + 100 * std::exp(-hardware.sheath.exponent()));
  const MotorDemand demand = demand_of("M-1x+M-2x", hardware);
  const double T = demand.force_N * (1 / K) / (1 / 2.0 + 2 / K);
  EXPECT_NEAR(demand.stretch_mm(), T / 2, 1e-7);
  EXPECT_NEAR(demand.stroke_mm, 10 + T / 2, 1e-7);
}

// The carriage would go on and close the other finger.
TEST(SeriesSprings, OfHandsThatDoNotCloseAreLeftOut) {
  const Hardware unlike = sprung_hand({10, 14}, {{1, 4.0, {}}, {2, 4.0, {}}});
  EXPECT_TRUE(shown_of("M-1x+M-2x", unlike).leaves_out_springs());
  EXPECT_NEAR(demand_of("M-1x+M-2x", unlike).stroke_mm, 10, 1e-9);
  const Hardware alike = sprung_hand({10, 10}, {{1, 4.0, {}}, {2, 4.0, {}}});
  const ShownHand jams = shown_of("M-1x+M-2x", alike, "none/1");
  EXPECT_TRUE(std::isinf(jams.demand.force_N));
  EXPECT_TRUE(jams.leaves_out_springs());
  EXPECT_NEAR(jams.demand.stroke_mm, 10, 1e-9);
}

TEST(SeriesSprings, OfSeveralMotorsOrBranchesThatStretchUnlikeAreLeftOut) {
  const Network two = expand(parse_routing("M-1-F+M2-2-F"));
  const Hardware hardware = sprung_hand({10, 10}, {{1, 4.0, {}}});
  EXPECT_TRUE(studies::shown_hand(two, "", Model{hardware}, {{Grasp{}, 1}})->leaves_out_springs());
  // The block goes back by s, which the tendon of fingers 3 and 4 would have to take up.
  const Network branches = expand(parse_routing("M-Y1+1x-Y1-2x+M-3-Y1-4x"));
  const Mechanics parts = mechanics(branches, sprung_hand({10, 10, 10, 10}, {{1, 4.0, {}}}));
  TensionState state;
  state.tension.assign(branches.segments.size(), 1.0);
  state.slip.assign(branches.contacts.size(), 0.0);
  EXPECT_FALSE(series_stretch(branches, parts, Grasp{}, state).is_known);
}

TEST(SeriesSprings, TakeTheirPartOfAStrokeThatIsTooShort) {
  Hardware hardware = sprung_hand({10}, {{1, 4.0, {}}});
  const double stretch_mm = demand_of("M-1-F", hardware).stretch_mm();
  hardware.motor.stroke_mm = stretch_mm + 5;
  const ShownHand reaching = shown_of("M-1-F", hardware);
  EXPECT_NEAR(reaching.stroke_reach->closure, 0.25, 1e-9);
  EXPECT_NEAR(reaching.stroke_reach->stroke_mm, stretch_mm + 5, 1e-9);
  hardware.motor.stroke_mm = stretch_mm / 2;
  EXPECT_FALSE(shown_of("M-1-F", hardware).stroke_reach);
}

TEST(SeriesSprings, StretchByNoMoreThanTheMotorPulls) {
  Hardware hardware = sprung_hand({10}, {{1, 4.0, {}}});
  const MotorDemand demand = demand_of("M-1-F", hardware);
  hardware.motor.force_N = demand.force_N / 2;
  hardware.motor.stroke_mm = demand.stretch_mm() / 2 + 5;
  const StrokeReach reach = *shown_of("M-1-F", hardware).stroke_reach;
  EXPECT_NEAR(reach.stretch_mm, demand.stretch_mm() / 2, 1e-9);
  EXPECT_NEAR(reach.stretch_N, demand.force_N / 2, 1e-9);
  EXPECT_NEAR(reach.closure, 0.25, 1e-9);
}

TEST(SeriesSprings, WithoutFrictionLoseNothing) {
  Hardware hardware = sprung_hand({12, 12}, {{1, 2000.0, {}}});
  hardware.tube.mu = hardware.sheath.mu = hardware.bearing.mu = 0;
  EXPECT_EQ(demand_of("M-1-P-2-F", hardware).friction_J, 0);
}

// D₀ of 8 ΔD is needed, as above.
TEST(SeriesSprings, LeaveTheClosingByAShortStrokeOpenWhereTendonSlipsBack) {
  Hardware hardware = sprung_hand({12, 12}, {{1, 2000.0, {}}});
  const MotorDemand demand = demand_of("M-1-P-2-F", hardware);
  ASSERT_TRUE(demand.stretch);
  hardware.motor.stroke_mm = 9.1 * demand.stretch_mm();
  ASSERT_LT(*hardware.motor.stroke_mm, demand.stroke_mm);
  EXPECT_TRUE(shown_of("M-1-P-2-F", hardware).stroke_reach);
  hardware.motor.stroke_mm = 8.9 * demand.stretch_mm();
  EXPECT_FALSE(shown_of("M-1-P-2-F", hardware).stroke_reach);
}

TEST(SeriesSprings, AreTheSameInTheObjectivesAndTheMotorForce) {
  for (const char* const word : {"M-1-P-2-F", "M-1-T-2-F"}) {
    for (const double stiffness : {200.0, 1.0}) {
      const Hardware hardware = sprung_hand({12, 12}, {{1, stiffness, {}}});
      const ShownHand shown = shown_of(word, hardware);
      UncertaintyOptions options{Model{hardware}, {}, parse_grasps("none", 2), {}};
      options.draws = 1;
      const MotorForce force = *search::motor_force(parse_routing(word), options);
      EXPECT_NEAR(force.stroke_mm, shown.demand.stroke_mm, 1e-9);
      EXPECT_NEAR(force.motors.front().stroke_mm, shown.demand.stroke_mm, 1e-9);
      EXPECT_EQ(force.leaves_out_springs, shown.leaves_out_springs());
      const ObjectiveValues values =
          DesignEvaluator(Model{hardware}, options.grasps).evaluate(parse_routing(word));
      EXPECT_NEAR(value(values, Objective::motor_power), shown.demand.power_W, 1e-9);
    }
  }
}

// Tendons without friction, each with one tension T, on blocks without bars. With fingers at x,
//
//   m D + B z − T / k = C x for each tendon,   m·T = F,   B^T T = 0
struct Equilibrium {
  double D = 0;
  Eigen::VectorXd T;
};

struct TendonEquations {
  Eigen::VectorXd m;
  Eigen::MatrixXd B;
  Eigen::MatrixXd C;
  Eigen::VectorXd give;  // 1 / k

  explicit TendonEquations(const Network& network, const Hardware& hardware) {
    const auto n = static_cast<Eigen::Index>(network.tendons.size());
    m = give = Eigen::VectorXd::Zero(n);
    B = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(network.blocks.size()));
    C = Eigen::MatrixXd::Zero(n, network.fingers);
    for (const TendonHardware& own : hardware.tendon.own)
      give(own.tendon - 1) = 1 / *own.stiffness_N_mm;
    for (Eigen::Index t = 0; t < n; ++t)
      add(network, network.tendons[static_cast<std::size_t>(t)], t);
  }

  void add(const Network& network, const TendonSpan& tendon, Eigen::Index t) {
    for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
      const Segment& segment = network.segments[i];
      m(t) += segment.kind == SegmentKind::motor_side;
      if (segment.kind == SegmentKind::strand) C(t, segment.finger - 1) += 1;
    }
    for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
      const std::size_t block = network.contacts[k].block;
      if (block != no_block) B(t, static_cast<Eigen::Index>(block)) += 2;
    }
    for (const TendonEnd& end : {tendon.left, tendon.right}) {
      if (end.tie == EndTie::none) continue;
      B(t, static_cast<Eigen::Index>(end.block)) += end.tie == EndTie::tail ? -1 : 1;
    }
  }

  std::optional<Equilibrium> at(const Eigen::VectorXd& x, double F) const {
    const Eigen::Index n = m.size();
    const Eigen::Index b = B.cols();
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(1 + b + n, 1 + b + n);
    all.block(0, 1 + b, 1, n) = m.transpose();
    all.block(1, 1 + b, b, n) = B.transpose();
    all.block(1 + b, 0, n, 1) = m;
    all.block(1 + b, 1, n, b) = B;
    all.block(1 + b, 1 + b, n, n).diagonal() = -give;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(1 + b + n);
    right(0) = F;
    right.tail(n) = C * x;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(all);
    if (!lu.isInvertible()) return std::nullopt;
    const Eigen::VectorXd y = lu.solve(right);
    return Equilibrium{y(0), y.tail(n)};
  }
};

Hardware random_sprung_hand(Dice& dice, const Network& network) {
  std::vector<double> excursions_mm;
  for (int f = 0; f < network.fingers; ++f) excursions_mm.push_back(dice.real(5, 20));
  std::vector<TendonHardware> springs;
  for (int t = 1; t <= static_cast<int>(network.tendons.size()); ++t) {
    if (dice.chance(0.7)) springs.push_back({t, dice.log_real(0.5, 50), {}});
  }
  Hardware hardware = without_friction(sprung_hand(excursions_mm, springs));
  std::erase_if(hardware.tendon.own, [&](const TendonHardware& own) {
    const auto unmatched = MechanicsBuilder(hardware).unmatched_tendons(network);
    return std::ranges::find(unmatched, std::to_string(own.tendon)) != unmatched.end();
  });
  for (FingerHardware& finger : hardware.fingers) {
    finger.parts.joints[0].spring_Nmm_rad = dice.real(0, 30);
    finger.parts.joints[0].rest_deg = dice.real(-30, 0);
  }
  return hardware;
}

// F rises while the fingers are held open, then closes them.
void expect_equilibrium(const Network& network, const Hardware& hardware, const MotorDemand& demand,
                        int& compared) {
  const TendonEquations equations(network, hardware);
  Eigen::VectorXd E(network.fingers);
  for (int f = 0; f < network.fingers; ++f) E(f) = hand(hardware)->finger(f + 1).excursion_mm;
  const double F = demand.force_N;
  const auto open = equations.at(0 * E, F);
  const auto closed = equations.at(E, F);
  if (!open || !closed) return;
  ++compared;
  const double scale = 1e-9 * std::max(1.0, F * closed->D);
  EXPECT_NEAR(demand.stretch_mm(), open->D, scale);
  EXPECT_NEAR(demand.stroke_mm, closed->D, scale);
  EXPECT_NEAR(demand.work_J, (F * open->D / 2 + F * (closed->D - open->D)) / 1000, scale);
  EXPECT_NEAR(demand.series_J, closed->T.cwiseAbs2().cwiseProduct(equations.give).sum() / 2 / 1000,
              scale);
  EXPECT_NEAR(demand.springs_J + demand.fingers_J, closed->T.dot(equations.C * E) / 1000, scale);
  EXPECT_NEAR(demand.friction_J, 0, scale);
}

TEST(SeriesSprings, OfRandomTreesWithoutFrictionAreInEquilibrium) {
  int compared = 0;
  int several_sides = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Dice dice(seed);
    const std::string word = testing::random_mechanism(dice, {4, 2, 0.2, 0});
    if (word.find('W') != std::string::npos) continue;
    SCOPED_TRACE(std::to_string(seed) + ": " + word);
    const Network network = expand(parse_routing(word));
    const Hardware hardware = random_sprung_hand(dice, network);
    TensionState state;
    TensionSolver().solve(network, mechanics(network, hardware), {}, Direction::pull, state);
    if (!state.in_range) continue;  // a finger would have to open
    const auto shown = studies::shown_hand(network, word, Model{hardware}, {{Grasp{}, 1}});
    if (!shown || !shown->demand.stretch) continue;
    expect_equilibrium(network, hardware, shown->demand, compared);
    several_sides +=
        std::ranges::count(network.segments, SegmentKind::motor_side, &Segment::kind) > 1;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(several_sides, 50);
}

}  // namespace
}  // namespace reeve
