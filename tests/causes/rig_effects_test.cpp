// What arrives of the motor's pull, and what sensors make of a tension, by hand. A bench M-F is a
// sheath between a and h1.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/causes/rig.hpp"

namespace reeve {
namespace {

using testing::effect;
using testing::model_with;
using testing::of_channel;
using testing::solved;

Subject of_channels(const std::string& one, const std::string& other) {
  Subject subject = of_channel(one);
  subject.other_channel = parse_segment(other);
  return subject;
}

// At a recorded motor tension of 20 N and 50 mm/s.
double at_tendon_of_20(const Model& model, Direction direction) {
  return at_tendon(model, direction, {20, 50}).motor_tension_N;
}

struct Reading {
  const char* channel;
  double tension_N;
};

// Sensors in consecutive columns, at this place of the file.
std::vector<double> readings(const Model& model, const std::vector<Reading>& tensions,
                             double order = 0) {
  std::vector<Sensor> sensors;
  for (const Reading& reading : tensions) {
    sensors.push_back({parse_segment(reading.channel), reading.tension_N, sensors.size()});
  }
  Conditions conditions;
  conditions.order = order;
  read(model, Direction::pull, conditions, sensors);
  std::vector<double> result;
  for (const Sensor& sensor : sensors) result.push_back(sensor.reading_N);
  return result;
}

using Values = std::vector<double>;

TEST(MotorTension, IsScaledAndShiftedInBothDirectionsAlike) {
  for (const Direction direction : {Direction::pull, Direction::release}) {
    EXPECT_EQ(at_tendon_of_20(model_with({effect("motor_gain", {1.25})}), direction), 25);
    EXPECT_EQ(at_tendon_of_20(model_with({effect("motor_offset", {-3})}), direction), 17);
  }
}

TEST(TransmissionLoss, IsTakenFromThePullAndAddedToTheRelease) {
  const Model constant = model_with({effect("constant_loss", {3})});
  EXPECT_EQ(at_tendon_of_20(constant, Direction::pull), 17);
  EXPECT_EQ(at_tendon_of_20(constant, Direction::release), 23);
  const Model viscous = model_with({effect("viscous_loss", {0.1})});
  EXPECT_EQ(at_tendon_of_20(viscous, Direction::pull), 15);
  EXPECT_EQ(at_tendon_of_20(viscous, Direction::release), 25);
}

TEST(TransmissionLoss, LeavesNothingWhereItTakesAll) {
  const Model model = model_with({effect("constant_loss", {20}), effect("viscous_loss", {0.1})});
  EXPECT_EQ(at_tendon_of_20(model, Direction::pull), 0);
}

// The record is corrected first; the speed is that of the record whatever the tension.
TEST(MotorEffects, ActInTheOrderOfTheLibrary) {
  const Model model = model_with({effect("viscous_loss", {0.02}), effect("constant_loss", {2}),
                                  effect("motor_offset", {1}), effect("motor_gain", {1.5})});
  EXPECT_EQ(at_tendon_of_20(model, Direction::pull), 1.5 * 20 + 1 - 2 - 1);
}

TEST(MotorEffects, AreOfTheRigAndNotOfADesign) {
  for (const char* cause : {"motor_gain", "motor_offset", "constant_loss", "viscous_loss"}) {
    EXPECT_FALSE(belongs_to_designs(effect(cause, {0.5}))) << cause;
  }
  EXPECT_TRUE(belongs_to_designs(effect("hysteresis", {0.5})));
}

// Laws of the load look at what the tendon carries and not at the record.
TEST(MotorEffects, AreSeenByLawsThatDependOnTheLoad) {
  Model model =
      model_with({effect("constant_loss", {10}), effect("load_dependent_friction", {0.3})});
  const Conditions pulled = at_tendon(model, Direction::pull, {20});
  model.conditions = pulled;
  EXPECT_NEAR(solved(model, "M-F")["h1"], std::exp(-0.36 * std::numbers::pi), 1e-9);
}

TEST(CrossTalk, AddsAPartOfTheColumnsBesideIt) {
  const Model model = model_with({effect("cross_talk", {0.1}, of_channel("T2"))});
  const std::vector<Reading> tensions{{"T1", 8}, {"T2", 5}, {"T3", 4}, {"T4", 100}};
  EXPECT_EQ(readings(model, tensions), (Values{8, 5 + 0.1 * (8 + 4), 4, 100}));
  const Model first = model_with({effect("cross_talk", {0.1}, of_channel("T1"))});
  EXPECT_EQ(readings(first, tensions), (Values{8 + 0.1 * 5, 5, 4, 100}));
}

// A column that the routing does not have stands between them; a segment without one has no
// neighbours.
TEST(CrossTalk, LooksAtNeighbouringColumnsAndNotAtTheNextSensor) {
  const Model model = model_with({effect("cross_talk", {0.1}, of_channel("T1"))});
  std::vector<Sensor> sensors{{parse_segment("T1"), 8, 0}, {parse_segment("T4"), 5, 2}};
  read(model, Direction::pull, {}, sensors);
  EXPECT_EQ(sensors[0].reading_N, 8);
  sensors[1].column = std::nullopt;
  read(model, Direction::pull, {}, sensors);
  EXPECT_EQ(sensors[0].reading_N, 8);
  sensors[1].column = 1;
  read(model, Direction::pull, {}, sensors);
  EXPECT_EQ(sensors[0].reading_N, 8.5);
}

TEST(DeadZone, TakesTheFirstNewtons) {
  const Model model = model_with({effect("dead_zone", {3}, of_channel("T1"))});
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 8}}), (Values{5, 8}));
  EXPECT_EQ(readings(model, {{"T1", 2}, {"T2", 2}}), (Values{0, 2}));
  EXPECT_FALSE(reads_linearly(model));
}

TEST(Saturation, CutsAShareOfWhatIsAboveTheLimit) {
  const auto at = [](double share, double tension) {
    return readings(model_with({effect("saturation", {share, 10}, of_channel("T1"))}),
                    {{"T1", tension}, {"T2", tension}});
  };
  EXPECT_EQ(at(1, 30), (Values{10, 30}));
  EXPECT_EQ(at(0.25, 30), (Values{25, 30}));
  EXPECT_EQ(at(1, 9), (Values{9, 9}));
  EXPECT_FALSE(reads_linearly(model_with({effect("saturation", {1, 10}, of_channel("T1"))})));
}

TEST(Drift, GrowsFromTheFirstReadingToTheLast) {
  const Model model = model_with({effect("drift", {-4}, of_channel("T1"))});
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 8}}, 0), (Values{8, 8}));
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 8}}, 0.25), (Values{7, 8}));
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 8}}, 1), (Values{4, 8}));
}

TEST(DeadChannel, ReadsItsOffsetAlone) {
  const Model model = model_with(
      {effect("dead_channel", {}, of_channel("T1")), effect("sensor_gain", {1.2}, of_channel("T1")),
       effect("sensor_offset", {0.3}, of_channel("T1")), effect("pretension", {2})});
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 8}}), (Values{0.3, 10}));
}

TEST(SwappedChannels, TakeTheirGainsWithThem) {
  const Model model = model_with({effect("swapped_channels", {}, of_channels("T1", "T3")),
                                  effect("sensor_gain", {2}, of_channel("T1"))});
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 7}, {"T3", 5}}), (Values{5, 7, 16}));
}

TEST(SwappedChannels, AreLeftWhereTheRoutingHasOneOfThem) {
  const Model model = model_with({effect("swapped_channels", {}, of_channels("T1", "T3"))});
  EXPECT_EQ(readings(model, {{"T1", 8}, {"T2", 7}}), (Values{8, 7}));
}

TEST(Readings, AreLinearUpToAnOffsetForAllOtherEffects) {
  for (const Effect& linear :
       {effect("sensor_gain", {2}, of_channel("T1")), effect("drift", {1}, of_channel("T1")),
        effect("cross_talk", {0.1}, of_channel("T1")), effect("dead_channel", {}, of_channel("T1")),
        effect("swapped_channels", {}, of_channels("T1", "T2")), effect("pretension", {1})}) {
    EXPECT_TRUE(reads_linearly(model_with({linear}))) << effect_name(linear);
  }
}

}  // namespace
}  // namespace reeve
