// What is steady in the strokes of a rig.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

TEST(SteadyReadings, AreTakenFromEveryStrokeAndNeverWhereAContactSticks) {
  for (const double correlation : {0.0, 0.9}) {
    RigPlan plan;
    plan.correlation = correlation;
    const auto [samples, found] = readings_on(plan);
    EXPECT_EQ(found.motion, MotionSource::position);
    EXPECT_EQ(found.readings.size(), 40U);
    expect_sound(samples, found);
    EXPECT_GT(count(found, SampleUse::taken), 2500U);
    EXPECT_GT(count(found, SampleUse::settling), 200U);
    EXPECT_GT(count(found, SampleUse::standstill), 600U);
    EXPECT_LT(count(found, SampleUse::spike), 5U);  // nor a rest of sticking
  }
}

TEST(SteadyReadings, HaveMeansWithinTheirStandardErrors) {
  RigPlan plan;
  plan.strokes = 8;
  plan.correlation = 0.7;
  const auto [samples, found] = readings_on(plan);
  const std::vector<double> deviations = deviations_from_truth(samples, found);
  ASSERT_EQ(deviations.size(), 320U);
  EXPECT_NEAR(share_within(deviations, 1.96), 0.95, 0.035);
  EXPECT_NEAR(share_within(deviations, 0.674), 0.5, 0.09);
}

TEST(SteadyReadings, OfAnEvenLoadAreOneForEachStroke) {
  RigPlan plan;
  plan.greatest_load_N = plan.least_load_N = 20;
  const auto [samples, found] = readings_on(plan);
  EXPECT_EQ(found.readings.size(), 8U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, OfASweepStandForLoadsOfTheirOwn) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  SteadyOptions options;
  options.per_sweep = 3;
  const SteadyReadings found = steady_readings(series_of(samples), options);
  ASSERT_EQ(found.readings.size(), 24U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GT(found.readings[i].motor_tension_N->mean_N,
              1.1 * found.readings[i - 1].motor_tension_N->mean_N);
  }
}

// A long take-up: half of each stroke only brings the contacts to slide.
TEST(SteadyReadings, LeaveOutALongTakeUp) {
  RigPlan plan;
  plan.stiffness_N_mm = 2.5;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GE(found.readings.size(), 16U);
  EXPECT_GT(count(found, SampleUse::settling), 800U);
  expect_sound(samples, found);
}

// So slowly that each block looks as if it went on as the next.
TEST(SteadyReadings, LeaveOutASlowTakeUp) {
  RigPlan plan;
  plan.rate_hz = 50;
  plan.strokes = 1;
  plan.speed_mm_s = 0.2;
  plan.even_s = 60;
  plan.stiffness_N_mm = 2.5;
  plan.noise = plan.noise_N = 0.002;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GE(found.readings.size(), 5U);
  expect_sound(samples, found);
}

// Little friction, which two fifths of each stroke take up: a bend in two lines that are nearly
// one.
TEST(SteadyReadings, LeaveOutASlightTakeUpHoweverSlowTheCarriageIs) {
  const std::vector<RigRun> smooth{
      {"1", "TR1", "", {{0.73, 0.93}, {0.72, 0.92}, {0.71, 0.91}, {0.7, 0.9}}}};
  for (const double slower : {1.0, 10.0}) {
    RigPlan plan;
    plan.strokes = 2;
    plan.even_s = 4 * slower;
    plan.speed_mm_s = 10 / slower;
    plan.stiffness_N_mm = 0.4;
    plan.greatest_load_N = plan.least_load_N = 20;
    plan.noise = plan.noise_N = 0.001;
    const auto [samples, found] = readings_on(plan, smooth);
    EXPECT_EQ(found.readings.size(), 4U);
    expect_sound(samples, found);
  }
}

TEST(SteadyReadings, DoNotComeFromStrokesTooShortForTheContactsToSlide) {
  RigPlan plan;
  plan.even_s = 1.5;
  plan.stiffness_N_mm = 0.5;
  plan.greatest_load_N = plan.least_load_N = 30;
  const auto [samples, found] = readings_on(plan);
  EXPECT_GT(count(found, SampleUse::not_following), 800U);
  EXPECT_TRUE(found.readings.empty());
}

TEST(SteadyReadings, OfASlowLoggerAreTheSame) {
  RigPlan plan;
  plan.rate_hz = 10;
  plan.even_s = 20;
  plan.speed_mm_s = 2;
  const auto [samples, found] = readings_on(plan);
  EXPECT_EQ(found.readings.size(), 40U);
  expect_sound(samples, found);
}

TEST(SteadyReadings, DoNotComeFromARigThatStands) {
  RigPlan plan;
  plan.strokes = 1;
  plan.dwell_s = 30;
  std::vector<RigSample> samples = rig_log(plan, one_run);
  samples.resize(3000);
  const SteadyReadings found = steady_readings(series_of(samples), {});
  EXPECT_TRUE(found.readings.empty());
  EXPECT_EQ(count(found, SampleUse::standstill), 3000U);
}

}  // namespace
}  // namespace reeve::testing
