#include "diagnosis/fit/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "causes/library.hpp"
#include "diagnosis/comparison.hpp"
#include "diagnosis/fit/problem.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

const double beyond_tube = std::exp(-0.18 * std::numbers::pi);
const double beyond_sheath = std::exp(-0.36 * std::numbers::pi);

TEST(Forecast, OfThePlainModelIsWhatCompareSays) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,motor_tension_N,sheath_angle_rad,T1_N,T2_N,Ta_N\n"
      "1,TR3,1,pull,10,,1,2,5\n1,TR5,,release,7,5,1,2,\n2,M-1-T-2-F,2,pull,3,,1,,3\n");
  const Forecast forecast = reeve::forecast(all_of(data), {});
  const Comparison comparison = compare(data, {});
  ASSERT_EQ(static_cast<std::size_t>(forecast.reading_N.size()), comparison.values.size());
  for (std::size_t i = 0; i < comparison.values.size(); ++i) {
    EXPECT_NEAR(forecast.reading_N[static_cast<Eigen::Index>(i)], comparison.values[i].predicted,
                1e-12);
  }
}

TEST(Forecast, WithoutMotorTensionAddsUpToTheMeasuredTensions) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,4,2\n");
  const Forecast forecast = reeve::forecast(all_of(data), {});
  EXPECT_NEAR(forecast.reading_N.sum(), 6, 1e-12);
  EXPECT_NEAR(forecast.reading_N[1] / forecast.reading_N[0], beyond_tube, 1e-12);
}

// 4 and 2 N with an offset of 1 N on the first are 3 and 2 N of tension.
TEST(Forecast, WithoutMotorTensionScalesTheTensionsAndNotTheOffsets) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,4,2\n");
  Model model;
  Subject first;
  first.channel = parse_segment("T1");
  add_effect(model, {find_cause("sensor_offset"), first, {1}});
  const Forecast forecast = reeve::forecast(all_of(data), model);
  EXPECT_NEAR(forecast.reading_N.sum(), 6, 1e-12);
  EXPECT_NEAR(forecast.reading_N[1] / (forecast.reading_N[0] - 1), beyond_tube, 1e-12);
  EXPECT_NEAR(forecast.by_scale[1] / forecast.by_scale[0], beyond_tube, 1e-12);
}

// The scale of such a row comes from the readings, at which the exponent then is taken.
TEST(Forecast, OfALoadDependentLawTakesTheLoadFromTheReadingsThemselves) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,40,30\n");
  Model model;
  add_effect(model, {find_cause("load_dependent_friction"), {}, {0.2}});
  const Forecast forecast = reeve::forecast(all_of(data), model);
  const double high = forecast.reading_N[0];
  const double exponent = 0.18 * std::numbers::pi * std::pow(high / 10, -0.2);
  EXPECT_NEAR(forecast.reading_N.sum(), 70, 1e-6);
  EXPECT_NEAR(forecast.reading_N[1] / high, std::exp(-exponent), 1e-7);
}

Model model_with(const char* cause, std::vector<double> values, const char* channel = nullptr) {
  Subject subject;
  if (channel != nullptr) subject.channel = parse_segment(channel);
  Model model;
  add_effect(model, {find_cause(cause), subject, std::move(values)});
  return model;
}

// 20 N less 5 N arrive pulling, 20 N and 5 N releasing; at 15 and 25 N a law of the load is taken.
TEST(Forecast, PullsTheTendonsWithWhatArrivesOfTheMotorsTension) {
  const MeasuredData data = read_data(
      "run,routing,direction,motor_tension_N,Ta_N,Th1_N\n1,M-F,pull,20,1,1\n1,M-F,release,"
      "20,1,1\n");
  Model model = model_with("constant_loss", {5});
  add_effect(model, {find_cause("load_dependent_friction"), {}, {0.2}});
  const Forecast forecast = reeve::forecast(all_of(data), model);
  EXPECT_NEAR(forecast.reading_N[0], 15, 1e-12);
  EXPECT_NEAR(forecast.reading_N[1], 15 * std::exp(-0.36 * std::numbers::pi * std::pow(1.5, -0.2)),
              1e-7);
  EXPECT_NEAR(forecast.reading_N[2], 25, 1e-12);
}

// It is its tendons' own tension that such a row finds.
TEST(Forecast, WithoutMotorTensionAsksNothingOfTheMotor) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,4,2\n2,M-1-T-2-F,3,2\n");
  for (const char* cause : {"constant_loss", "viscous_loss", "motor_gain", "motor_offset"}) {
    const Forecast with = reeve::forecast(all_of(data), model_with(cause, {0.5}));
    EXPECT_EQ(with.reading_N, reeve::forecast(all_of(data), {}).reading_N) << cause;
    EXPECT_EQ(with.by_scale, reeve::forecast(all_of(data), {}).by_scale) << cause;
  }
}

// T1 carries 10 N beyond the sheath whether or not its own cell is there.
TEST(Forecast, OfCrossTalkHearsNeighboursWhoseCellIsEmpty) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N,T2_N\n1,M-1-T-2-F,10,1,1\n1,M-1-T-2-F,10,,1\n");
  const Forecast forecast = reeve::forecast(all_of(data), model_with("cross_talk", {0.1}, "T2"));
  const double expected = 10 * beyond_sheath * (beyond_tube + 0.1);
  EXPECT_NEAR(forecast.reading_N[1], expected, 1e-12);
  EXPECT_NEAR(forecast.reading_N[2], expected, 1e-12);
}

// Whatever part of the file is looked at.
TEST(Forecast, OfADriftLooksAtThePlaceInTheFile) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N\n1,M-1-F,10,1\n1,M-1-F,10,1\n2,M-1-F,10,1\n"
      "2,M-1-F,10,1\n2,M-1-F,10,1\n");
  const Model model = model_with("drift", {4}, "T1");
  const Forecast all = reeve::forecast(all_of(data), model);
  for (Eigen::Index i = 0; i < 5; ++i) {
    EXPECT_NEAR(all.reading_N[i], 10 * beyond_sheath + static_cast<double>(i), 1e-12);
  }
  const Forecast some = reeve::forecast(dataset(data, {1, 3}), model);
  EXPECT_NEAR(some.reading_N[0], all.reading_N[1], 1e-12);
  EXPECT_NEAR(some.reading_N[1], all.reading_N[3], 1e-12);
}

// 5 N is all that the first reads: the second has the rest, and says alone how large the tension
// is.
TEST(Forecast, WithoutMotorTensionFindsTheScaleOfReadingsThatAreCut) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,5,4\n");
  const Model model = model_with("saturation", {1, 5}, "T1");
  const Forecast forecast = reeve::forecast(all_of(data), model);
  EXPECT_NEAR(forecast.reading_N[0], 5, 1e-12);
  EXPECT_NEAR(forecast.reading_N[1], 4, 1e-9);
  EXPECT_NEAR(forecast.by_scale[0], 0, 1e-9);
  EXPECT_NEAR(forecast.by_scale[1], beyond_sheath * beyond_tube, 1e-6);
}

TEST(Forecast, WithoutMotorTensionOfADeadZoneLeavesOutWhatItTook) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,5,4\n");
  const Forecast forecast = reeve::forecast(all_of(data), model_with("dead_zone", {1}, "T1"));
  EXPECT_NEAR(forecast.reading_N.sum(), 9, 1e-9);
  EXPECT_NEAR(forecast.reading_N[1] / (forecast.reading_N[0] + 1), beyond_tube, 1e-9);
}

// More was measured than the sensors can read together.
TEST(Forecast, WithoutMotorTensionReadsTheMostThereIsWhereMoreWasMeasured) {
  const MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,5.3,5.2\n");
  Model model = model_with("saturation", {1, 5}, "T1");
  add_effect(model, model_with("saturation", {1, 5}, "T2").effects.front());
  const Forecast forecast = reeve::forecast(all_of(data), model);
  EXPECT_NEAR(forecast.reading_N[0], 5, 1e-9);
  EXPECT_NEAR(forecast.reading_N[1], 5, 1e-9);
  EXPECT_TRUE(forecast.by_scale.allFinite());
}

TEST(Residuals, IgnoreTheScaleOfARowWithoutMotorTension) {
  const MeasuredData small = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,4,2\n");
  const Dataset dataset = all_of(small);
  const Problem problem = reeve::problem(dataset, Eigen::Vector2d{0.1, 0.1});
  const Eigen::VectorXd left = residuals(problem, forecast(dataset, {}));
  EXPECT_NEAR(left.dot(Eigen::Vector2d{1, beyond_tube}), 0, 1e-9);
}

// Half of the normal noise about 0 is cut off: its mean is sd / sqrt(2 pi).
TEST(Residuals, KnowThatASensorCannotReadBelowZero) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N,T2_N\n1,M-1-F,10,0,3\n1,M-1-F,10,2,3\n");
  const Dataset dataset = all_of(data);
  const Problem problem = reeve::problem(dataset, Eigen::Vector4d{0.5, 0.01, 0.5, 0.01});
  const double far = 10 * beyond_sheath * beyond_tube;
  const Forecast forecast{Eigen::Vector4d{0, far, 3, far}, Eigen::Vector4d::Zero(), {}};
  const Eigen::VectorXd expected = expected_readings(problem, forecast);
  EXPECT_NEAR(expected[0], 0.5 / std::sqrt(2 * std::numbers::pi), 1e-12);
  EXPECT_EQ(expected[1], forecast.reading_N[1]);
  // One that reads 0 throughout is dead, and has no noise.
  const MeasuredData dead = read_data("run,routing,motor_tension_N,T1_N,T2_N\n1,M-1-F,10,0,3\n");
  const Dataset of_dead = all_of(dead);
  const Forecast zero{Eigen::Vector2d{0, far}, Eigen::Vector2d::Zero(), {}};
  EXPECT_EQ(expected_readings(reeve::problem(of_dead, Eigen::Vector2d{0.5, 0.01}), zero)[0], 0);
}

}  // namespace
}  // namespace reeve::testing
