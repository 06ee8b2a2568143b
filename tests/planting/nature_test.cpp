#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "tests/support/planting_nature.hpp"

namespace reeve::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double sheath_phi = 0.18 * 2 * pi;
constexpr double tube_phi = 0.18 * pi;
constexpr double bearing_phi = 0.001 * pi;

Condition pull(const std::string& word, double motor_N, const std::set<int>& held = {}) {
  Condition condition;
  condition.word = word;
  condition.held = held;
  condition.motor_tension_N = motor_N;
  return condition;
}

Condition release(const std::string& word, double motor_N) {
  Condition condition = pull(word, motor_N);
  condition.direction = ReferenceDirection::release;
  return condition;
}

double far_end(const Nature& nature, const Condition& condition) {
  return planted_tensions(nature, condition).at("h1");
}

TEST(PlantedNature, IsTheReferenceModelWithoutEffects) {
  for (const char* word : {"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F", "M-1-P-2-M",
                           "1-T-2-P-1", "1-P-2-P-1", "M-1-T-2-F+M-3-F"}) {
    for (const std::set<int>& held : {std::set<int>{}, {1}, {2}}) {
      for (const auto direction : {ReferenceDirection::pull, ReferenceDirection::release}) {
        Condition condition = pull(word, 20, held);
        condition.direction = direction;
        condition.speed_mm_s = 50;
        condition.cycle = 1000;
        condition.temperature_C = 35;
        const auto tension = planted_tensions({}, condition);
        const auto nominal = reference_tensions(word, held, direction, nominal_hardware()).tension;
        ASSERT_EQ(tension.size(), nominal.size());
        for (const auto& [segment, value] : nominal) {
          EXPECT_NEAR(tension.at(segment), 20 * value, 1e-9 * value) << word << " " << segment;
        }
      }
    }
  }
}

TEST(PlantedNature, HasCoefficientsOfItsOwn) {
  Nature nature;
  nature.tube_mu = 0.09;
  nature.sheath_mu = 0.1;
  const auto tension = planted_tensions(nature, pull("M-1-F", 10));
  EXPECT_NEAR(tension.at("T1"), 10 * std::exp(-0.2 * pi), 1e-9);
  EXPECT_NEAR(tension.at("T2"), 10 * std::exp(-0.29 * pi), 1e-9);
}

TEST(PlantedNature, FrictionFallsWithLoadSpeedWearAndTemperature) {
  Condition condition = pull("M-F", 40);
  condition.speed_mm_s = 80;
  condition.cycle = 700;
  condition.temperature_C = 33;
  Nature nature;
  nature.load_exponent = 0.2;
  double phi = sheath_phi * std::pow(4.0, -0.2);
  EXPECT_NEAR(far_end(nature, condition), 40 * std::exp(-phi), 1e-8);
  nature.speed_slope = 0.06;
  phi *= 1 + 0.06 * std::log(8.0);
  EXPECT_NEAR(far_end(nature, condition), 40 * std::exp(-phi), 1e-8);
  nature.wear_change = -0.3;
  nature.wear_cycles = 350;
  phi *= 1 - 0.3 * (1 - std::exp(-2.0));
  EXPECT_NEAR(far_end(nature, condition), 40 * std::exp(-phi), 1e-8);
  nature.temperature_slope_per_K = 0.008;
  phi *= 1 - 0.008 * 13;
  EXPECT_NEAR(far_end(nature, condition), 40 * std::exp(-phi), 1e-8);
}

TEST(PlantedNature, FactorsDoNotFallBelowZero) {
  Condition condition = pull("M-F", 40);
  condition.temperature_C = 40;
  Nature nature;
  nature.temperature_slope_per_K = 0.1;
  EXPECT_NEAR(far_end(nature, condition), 40, 1e-9);
}

TEST(PlantedNature, UnrecordedConditionsDoNotAct) {
  Nature nature;
  nature.speed_slope = nature.temperature_slope_per_K = 0.1;
  nature.wear_change = -0.5;
  EXPECT_NEAR(far_end(nature, pull("M-F", 40)), 40 * std::exp(-sheath_phi), 1e-9);
}

TEST(PlantedNature, BendingTakesAForceOfTheSideThatSlidesAway) {
  Nature nature;
  nature.bending_force_N = 0.5;
  EXPECT_NEAR(far_end(nature, pull("M-F", 20)), 20 * std::exp(-sheath_phi) - 0.5, 1e-8);
  EXPECT_NEAR(far_end(nature, release("M-F", 20)), 20.5 * std::exp(sheath_phi), 1e-7);
  EXPECT_NEAR(far_end(nature, pull("M-F", 1)), 0, 1e-6);
}

TEST(PlantedNature, LoadDependenceIsThatOfTheGreaterTensionInRelease) {
  Nature nature;
  nature.load_exponent = 0.2;
  const double high = far_end(nature, release("M-F", 20));
  EXPECT_NEAR(high * std::exp(-sheath_phi * std::pow(high / 10, -0.2)), 20, 1e-7);
}

TEST(PlantedNature, LoadDependenceFollowsTheTendonOfTR1) {
  Nature nature;
  nature.load_exponent = 0.1;
  nature.bending_force_N = 0.2;
  const auto tension = planted_tensions(nature, pull("M-1-T-2-F", 50));
  const auto next = [](double high, double phi) {
    return high * std::exp(-phi * std::pow(high / 10, -0.1)) - 0.2;
  };
  double expected = next(50, sheath_phi);
  EXPECT_NEAR(tension.at("T1"), expected, 1e-7);
  for (const char* strand : {"T2", "T3", "T4"}) {
    expected = next(expected, tube_phi);
    EXPECT_NEAR(tension.at(strand), expected, 1e-7) << strand;
  }
}

// Finger 2 gives up tendon, which slides over both pulleys towards the sides of the held finger 1;
// there the strands stand still and elongate towards the carriage.
TEST(PlantedNature, DragAndBendingActInTR7WithAHeldFinger) {
  Nature nature;
  nature.drag_force_N = 0.4;
  nature.bending_force_N = 0.3;
  nature.bearing_mu = 0.05;
  const auto tension = planted_tensions(nature, pull("1-P-2-P-1", 40, {1}));
  const double through = std::exp(-0.05 * pi);
  const double high = (40 / 2.0 + 0.4) / (1 + through);
  const double low = high * through - 0.4;
  const double sheath = std::exp(-sheath_phi);
  for (const char* segment : {"a", "d"}) EXPECT_NEAR(tension.at(segment), high, 1e-7);
  for (const char* segment : {"b", "c"}) EXPECT_NEAR(tension.at(segment), low, 1e-7);
  for (const char* segment : {"T3", "T4"}) {
    EXPECT_NEAR(tension.at(segment), low * sheath - 0.3, 1e-7);
  }
  for (const char* segment : {"T1", "T2"}) {
    EXPECT_NEAR(tension.at(segment), high * sheath - 0.3, 1e-7);
  }
}

// From tension 0.2 N behind the last contact the one before it is found, against a force of 0.6 N.
TEST(PlantedNature, ReleaseFindsTheGreaterTensionFromTheLess) {
  Nature nature;
  nature.bending_force_N = 0.6;
  const auto tension = planted_tensions(nature, release("M-1-F", 0.2));
  const double first = (0.2 + 0.6) * std::exp(sheath_phi);
  EXPECT_NEAR(tension.at("T1"), first, 1e-7);
  EXPECT_NEAR(tension.at("T2"), (first + 0.6) * std::exp(tube_phi), 1e-7);
}

TEST(PlantedNature, SlackIsToldOf) {
  Nature nature;
  nature.bending_force_N = 0.6;
  EXPECT_TRUE(goes_slack(nature, pull("M-1-P-2-M", 10, {1})));
  EXPECT_FALSE(goes_slack(nature, pull("M-1-T-2-F", 30)));
  EXPECT_FALSE(goes_slack({}, pull("M-1-P-2-M", 10, {1})));
}

TEST(PlantedNature, BearingsKnowNeitherLoadNorSpeedNorTemperature) {
  Nature nature;
  nature.load_exponent = nature.speed_slope = nature.temperature_slope_per_K = 0.1;
  nature.sheath_mu = 0;
  Condition condition = pull("M-1b-F", 40);
  condition.speed_mm_s = 90;
  condition.temperature_C = 39;
  EXPECT_NEAR(planted_tensions(nature, condition).at("T2"), 40 * std::exp(-bearing_phi), 1e-8);
}

TEST(PlantedNature, TurnsTheSheathsOfOneFinger) {
  Nature nature;
  nature.sheath_change_rad[2] = 0.8;
  const auto tension = planted_tensions(nature, pull("M-1-B-2-M", 40));
  EXPECT_NEAR(tension.at("T1") / tension.at("a"), std::exp(-sheath_phi), 1e-9);
  EXPECT_NEAR(tension.at("T4") / tension.at("b"), std::exp(-0.18 * (2 * pi + 0.8)), 1e-9);
}

TEST(PlantedNature, MeasuresTheActualGraspWhereAnotherIsRecorded) {
  Nature nature;
  nature.wrong_grasps.push_back({"M-1-P-2-M", {1}, {}});
  EXPECT_EQ(planted_tensions(nature, pull("M-1-P-2-M", 40, {1})),
            planted_tensions({}, pull("M-1-P-2-M", 40)));
  EXPECT_EQ(planted_tensions(nature, pull("M-1-P-2-M", 40, {2})),
            planted_tensions({}, pull("M-1-P-2-M", 40, {2})));
  EXPECT_EQ(planted_tensions(nature, pull("M-1-P-2-F", 40, {1})),
            planted_tensions({}, pull("M-1-P-2-F", 40, {1})));
}

}  // namespace
}  // namespace reeve::testing
