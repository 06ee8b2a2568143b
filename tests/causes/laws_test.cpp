// Every law against what one gets by hand on a bench (M-F: a sheath between a and h1) and on
// published routings. phi_s = 0.36 pi, phi_t = 0.18 pi, phi_b = 0.001 pi.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/causes/rig.hpp"

namespace reeve {
namespace {

using testing::bearing;
using testing::bench;
using testing::effect;
using testing::model_with;
using testing::of_channel;
using testing::pi;
using testing::sheath;
using testing::Solved;
using testing::solved;
using testing::tube;

constexpr double tolerance = 1e-9;

Subject of_finger(int finger) {
  Subject subject;
  subject.finger = finger;
  return subject;
}

TEST(FrictionLaw, OfEachKindOfContactReplacesItsCoefficient) {
  const Model model = model_with({effect("tube_friction", {0.09}), effect("sheath_friction", {0.1}),
                                  effect("bearing_friction", {0.004})});
  const Solved s = solved(model, "M-1-T-2-F");
  EXPECT_NEAR(s["T1"], std::exp(-0.2 * pi), tolerance);
  EXPECT_NEAR(s["T4"], std::exp(-0.2 * pi - 3 * 0.09 * pi), tolerance);
  const Solved b = solved(model, "M-1b-B-2b-F");
  EXPECT_NEAR(b["T4"], std::exp(-0.2 * pi - 3 * 0.004 * pi), tolerance);
}

TEST(LoadDependentFriction, IsAPowerOfTheHigherTension) {
  for (const double motor : {1.0, 10.0, 40.0}) {
    Model model = model_with({effect("load_dependent_friction", {0.3})});
    model.conditions.motor_tension_N = motor;
    EXPECT_NEAR(bench(model), std::exp(-sheath * std::pow(motor / 10, -0.3)), tolerance);
  }
}

// Each contact behind the one before it: T1, T2, T3, T4 in turn.
TEST(LoadDependentFriction, FollowsTheTensionAlongTheTendon) {
  Model model = model_with({effect("load_dependent_friction", {0.2})});
  model.conditions.motor_tension_N = 30;
  const Solved s = solved(model, "M-1-T-2-F");
  const auto passed = [](double high, double phi) {
    return high * std::exp(-phi * std::pow(high / 10, -0.2));
  };
  const double T1 = passed(30, sheath);
  const double T2 = passed(T1, tube);
  const double T3 = passed(T2, tube);
  EXPECT_NEAR(30 * s["T1"], T1, 30 * tolerance);
  EXPECT_NEAR(30 * s["T4"], passed(T3, tube), 30 * tolerance);
  EXPECT_TRUE(s.converged);
}

// TR7 with both fingers closing: four sheaths alike, each from a quarter of the motor tension, so
// T (T_a) = T_a e^{-phi (T_a/10)^-gamma}, T_a = T_M / 4; the tips do not slide.
TEST(LoadDependentFriction, OfTr7IsThatOfOneOfItsFourSheaths) {
  Model model = model_with({effect("load_dependent_friction", {0.2})});
  model.conditions.motor_tension_N = 20;
  const Solved s = solved(model, "1-P-2-P-1");
  const double expected = 0.25 * std::exp(-sheath * std::pow(5.0 / 10, -0.2));
  for (const char* strand : {"T1", "T2", "T3", "T4"}) EXPECT_NEAR(s[strand], expected, tolerance);
}

TEST(LoadDependentFriction, SparesBearings) {
  const Solved s = solved(model_with({effect("load_dependent_friction", {0.5})}), "M-1b-B-2b-F");
  EXPECT_NEAR(s["T4"] / s["T1"], std::exp(-3 * bearing), tolerance);
}

// Releasing, the tension rises from the motor to the hand: T_h1 = T_M e^{phi (T_h1/10)^-gamma}.
TEST(LoadDependentFriction, LooksAtTheHandSideWhenReleasing) {
  Model model = model_with({effect("load_dependent_friction", {0.3})});
  const double h1 = 10 * solved(model, "M-1-F", {}, Direction::release)["T1"];
  EXPECT_NEAR(h1, 10 * std::exp(sheath * std::pow(h1 / 10, -0.3)), 1e-7);
}

TEST(SpeedDependentFriction, GrowsWithTheLogarithmOfTheSpeed) {
  Model model = model_with({effect("speed_dependent_friction", {0.1})});
  for (const double speed : {1.0, 10.0, 100.0}) {
    model.conditions.speed_mm_s = speed;
    EXPECT_NEAR(bench(model), std::exp(-sheath * (1 + 0.1 * std::log(speed / 10))), tolerance);
  }
  model.conditions.speed_mm_s = 1e-6;  // taken as 0.01 mm/s
  EXPECT_NEAR(bench(model), std::exp(-sheath * (1 + 0.1 * std::log(1e-3))), tolerance);
}

TEST(Wear, RunsInWithTheCycles) {
  Model model = model_with({effect("wear", {-0.4, 500})});
  EXPECT_NEAR(bench(model), std::exp(-sheath), tolerance);
  model.conditions.cycle = 500;
  EXPECT_NEAR(bench(model), std::exp(-sheath * (1 - 0.4 * (1 - std::exp(-1.0)))), tolerance);
  model.conditions.cycle = 1e6;
  EXPECT_NEAR(bench(model), std::exp(-sheath * 0.6), tolerance);
}

TEST(Temperature, LowersFrictionInProportion) {
  Model model = model_with({effect("temperature", {0.01})});
  model.conditions.temperature_C = 35;
  EXPECT_NEAR(bench(model), std::exp(-sheath * 0.85), tolerance);
  model.conditions.temperature_C = 200;  // not below 0
  EXPECT_NEAR(bench(model), 1, tolerance);
}

TEST(WrapFreeLoss, IsAddedToTheExponentOfEachSheathAndOfNothingElse) {
  const Solved s = solved(model_with({effect("wrap_free_loss", {0.4})}), "M-1-T-2-F");
  EXPECT_NEAR(s["T1"], std::exp(-sheath - 0.4), tolerance);
  EXPECT_NEAR(s["T4"] / s["T1"], std::exp(-3 * tube), tolerance);
  EXPECT_NEAR(
      bench(model_with({effect("wrap_free_loss", {-0.5}), effect("sheath_friction", {0.01})})), 1,
      tolerance);  // not below 0
}

TEST(Hysteresis, ScalesTheExponentsOfTubesAndSheathsWhenReleasing) {
  const Model model = model_with({effect("hysteresis", {0.5})});
  const Solved released = solved(model, "M-1-B-2-F", {}, Direction::release);
  EXPECT_NEAR(released["T1"], std::exp(1.5 * sheath), 1e-6);
  EXPECT_NEAR(released["T2"] / released["T1"], std::exp(1.5 * tube), tolerance);
  EXPECT_NEAR(released["T3"] / released["T2"], std::exp(bearing), tolerance);
  const Solved pulled = solved(model, "M-1-B-2-F");
  EXPECT_EQ(pulled.state.tension, solved(model_with({}), "M-1-B-2-F").state.tension);
}

TEST(LawsOfConditions, SpareBearings) {
  for (const Effect& law : {effect("speed_dependent_friction", {0.2}), effect("wear", {-0.4, 500}),
                            effect("temperature", {0.02}), effect("wrap_free_loss", {0.3})}) {
    Model model = model_with({law});
    model.conditions = {10, 100, 1000, 45};
    const Solved s = solved(model, "M-1b-B-2b-F");
    EXPECT_NEAR(s["T4"] / s["T1"], std::exp(-3 * bearing), 1e-12) << effect_name(law);
    EXPECT_GT(std::abs(s["T1"] / std::exp(-sheath) - 1), 0.1) << effect_name(law);
  }
}

TEST(BendingStiffness, TakesAConstantForceAtEachTubeAndSheath) {
  const Model model = model_with({effect("bending_stiffness", {0.3})});
  EXPECT_NEAR(10 * bench(model), 10 * std::exp(-sheath) - 0.3, 10 * tolerance);
  const Solved s = solved(model, "M-1b-T-2b-F");
  const double T1 = 10 * std::exp(-sheath) - 0.3;
  const double T2 = T1 * std::exp(-bearing);
  const double T3 = T2 * std::exp(-tube) - 0.3;
  EXPECT_NEAR(10 * s["T3"], T3, 10 * tolerance);
  EXPECT_NEAR(10 * s["T4"], T3 * std::exp(-bearing), 10 * tolerance);
}

TEST(BendingStiffness, LeavesNothingWhereItTakesAll) {
  const Model model = model_with({effect("bending_stiffness", {5})});
  EXPECT_NEAR(bench(model), std::exp(-max_exponent), tolerance);
}

TEST(BearingDrag, TakesAConstantForceAtEachBearing) {
  const Solved s = solved(model_with({effect("bearing_drag", {0.2})}), "M-1b-T-2b-F");
  const double T1 = 10 * std::exp(-sheath);
  const double T2 = T1 * std::exp(-bearing) - 0.2;
  const double T3 = T2 * std::exp(-tube);
  EXPECT_NEAR(10 * s["T2"], T2, 10 * tolerance);
  EXPECT_NEAR(10 * s["T4"], T3 * std::exp(-bearing) - 0.2, 10 * tolerance);
}

TEST(Laws, ActInTheOrderOfTheLibraryWhicheverCameFirst) {
  Model model =
      model_with({effect("bending_stiffness", {0.3}), effect("temperature", {0.01}),
                  effect("load_dependent_friction", {0.2}), effect("sheath_friction", {0.2})});
  model.conditions = {40, 10, 0, 30};
  const double phi = 0.4 * pi * std::pow(4.0, -0.2) * 0.9;
  EXPECT_NEAR(40 * bench(model), 40 * std::exp(-phi) - 0.3, 40 * tolerance);
}

TEST(SheathAngle, TurnsTheSheathsOfOneFinger) {
  const Model model = model_with({effect("sheath_angle", {-0.5}, of_finger(2))});
  const Solved s = solved(model, "M-1-F+M-2-F");
  const double one = std::exp(-sheath);
  const double other = std::exp(-0.18 * (2 * pi - 0.5));
  EXPECT_NEAR(s["T1"] / s["a"], one, tolerance);
  EXPECT_NEAR(s["T3"] / s["b"], other, tolerance);
  const Model none = model_with(
      {effect("sheath_angle", {-6}, of_finger(2)), effect("sheath_angle", {-6}, of_finger(2))});
  const Solved straight = solved(none, "M-1-F+M-2-F");
  EXPECT_NEAR(straight["T3"] / straight["b"], 1, tolerance);
}

TEST(Readings, AreTensionsThroughGainOffsetAndPretension) {
  const Model model =
      model_with({effect("sensor_gain", {1.1}, of_channel("T3")),
                  effect("sensor_offset", {-0.5}, of_channel("T3")), effect("pretension", {2})});
  EXPECT_NEAR(reading(model, parse_segment("T3"), 8), 1.1 * (8 + 2) - 0.5, 1e-12);
  EXPECT_EQ(reading(model, parse_segment("T1"), 8), 10);
  EXPECT_EQ(reading(model, parse_segment("a"), 8), 8);
}

TEST(WrongGrasp, ConcernsOneRecordedGraspOfOneRouting) {
  Subject subject;
  subject.routing = "M-1-T-2-F";
  subject.recorded = hold({1});
  subject.actual = Grasp{};
  const Model model = model_with({effect("wrong_grasp", {}, subject)});
  EXPECT_EQ(actual_grasp(model, "M-1-T-2-F", hold({1})), Grasp{});
  EXPECT_EQ(actual_grasp(model, "M-1-T-2-F", hold({2})), hold({2}));
  EXPECT_EQ(actual_grasp(model, "M-1-T-2-M", hold({1})), hold({1}));
  Subject other = subject;
  other.recorded = hold({2});
  const Model both =
      model_with({effect("wrong_grasp", {}, subject), effect("wrong_grasp", {}, other)});
  for (const int held : {1, 2}) EXPECT_EQ(actual_grasp(both, "M-1-T-2-F", hold({held})), Grasp{});
}

}  // namespace
}  // namespace reeve
