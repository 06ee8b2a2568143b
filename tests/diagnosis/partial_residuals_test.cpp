// Partial residuals of laws whose truth is written down: y − f(x) is the noise over the
// sensitivity.
#include "diagnosis/verdict/partial_residuals.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "causes/term.hpp"
#include "diagnosis/fit/fit.hpp"
#include "numerics/student_t.hpp"
#include "tests/diagnosis/gain_bench.hpp"

namespace reeve::testing {
namespace {

constexpr double slope = 0.004;
constexpr double middle = 50;

// A law of humidity between 20 and 80 %.
Term humidity_law(Target target, Site site) {
  Term term;
  term.target = target;
  term.site = std::move(site);
  term.form = Form::linear;
  term.x = causes::covariate_named("humidity_pct");
  term.x.middle = middle;
  term.x.seen = {20, 80};
  return term;
}

Site sensor_at_T1() {
  Site site;
  site.place = SitePlace::channel;
  site.channel = parse_segment("T1");
  return site;
}

Site sheaths() {
  Site site;
  site.kind = ContactKind::sheath;
  return site;
}

// Rows of M-1-F with a humidity each, and what T1 reads at it.
MeasuredData humid_data(const std::function<double(double motor_N, double humidity)>& reading) {
  std::string text = "run,routing,motor_tension_N,humidity_pct,T1_N\n";
  for (int i = 0; i < 24; ++i) {
    const double motor_N = 10 + 5 * (i % 4);
    const double humidity = 20 + 60.0 * i / 23;
    text +=
        fmt::format("r{},M-1-F,{},{},{}\n", i / 4, motor_N, humidity, reading(motor_N, humidity));
  }
  return read_data(text);
}

Scatter known_noise(double absolute_N) {
  Scatter scatter;
  scatter.noise.absolute_N = absolute_N;
  return scatter;
}

EffectSpread spread_of(double deviation) {
  return {Eigen::MatrixXd::Constant(1, 1, deviation * deviation), 2};
}

PartialResiduals seen(const MeasuredData& data, const Model& model, double deviation = 0.0001,
                      double hold_out = 0) {
  Workers workers(1);
  const Sample part = sample(data, hold_out, 1);
  const auto partial = partial_residuals(part, model, known_noise(0.05), model.effects.size() - 1,
                                         spread_of(deviation), workers);
  EXPECT_TRUE(partial.has_value());
  return partial.value_or(PartialResiduals{});
}

Model with_law(Model model, const Term& term, double size) {
  add_effect(model, {&causes::law(term), {}, {size}});
  return model;
}

double noise_N(std::size_t i) { return 0.05 * std::sin(1.7 * static_cast<double>(i)); }

// For a gain S is the tension: y = slope (x − x0) + noise / T.
TEST(PartialResiduals, OfAGainAreItsLawPlusNoiseOverTheTension) {
  std::size_t i = 0;
  const MeasuredData data = humid_data([&](double motor_N, double humidity) {
    return motor_N * (1 + slope * (humidity - middle)) + noise_N(i++);
  });
  // This holds where the fit is off, too: what a reading says does not depend on it.
  for (const double fitted : {slope, 0.9 * slope}) {
    const PartialResiduals partial =
        seen(data, with_law(bench_model(), humidity_law(Target::gain, sensor_at_T1()), fitted));
    EXPECT_EQ(partial.x.name, "humidity_pct");
    EXPECT_EQ(partial.y.name, "relative change of the gain");
    ASSERT_EQ(partial.points.size(), 24U);
    for (std::size_t k = 0; k < 24; ++k) {
      const double motor_N = *data.readings[k].motor_tension_N;
      const PartialPoint& point = partial.points[k];
      EXPECT_EQ(point.reading, k);
      EXPECT_NEAR(point.x, 20 + 60.0 * static_cast<double>(k) / 23, 1e-9);
      EXPECT_NEAR(point.y, slope * (point.x - middle) + noise_N(k) / motor_N, 1e-8);
      EXPECT_NEAR(point.deviation, 0.05 / motor_N, 1e-8);
    }
  }
}

TEST(PartialResiduals, HaveACurveThroughZeroWhereTheLawIsNominal) {
  const MeasuredData data = humid_data([](double motor_N, double) { return motor_N; });
  const Model model = with_law(bench_model(), humidity_law(Target::gain, sensor_at_T1()), slope);
  const PartialResiduals partial = seen(data, model);
  ASSERT_GT(partial.curve.size(), 2U);
  EXPECT_NEAR(partial.curve.front().x, 20, 1e-9);
  EXPECT_NEAR(partial.curve.back().x, 80, 1e-9);
  for (const CurvePoint& at : partial.curve) {
    EXPECT_NEAR(at.y, slope * (at.x - middle), 1e-12);
    // The interval of the slope, 2 standard errors to either side.
    EXPECT_NEAR(at.high - at.y, 2 * 0.0001 * std::abs(at.x - middle), 1e-9);
    EXPECT_NEAR(at.y - at.low, at.high - at.y, 1e-12);
  }
  EXPECT_NEAR(partial.curve[partial.curve.size() / 2].x, middle, 1e-9);
  EXPECT_NEAR(partial.curve[partial.curve.size() / 2].y, 0, 1e-12);
}

// Through one sheath T1 = T_M e^{−φ(1 + f)}, so that S = −φ T1; φ = 0.1 · 2π.
TEST(PartialResiduals, OfAnExponentAreItsLawPlusNoiseOverTheSensitivity) {
  Model model = bench_model();
  model.hardware.sheath.mu = 0.1;
  const double phi = model.hardware.sheath.mu * model.hardware.sheath.whole_angle_rad();
  const double steep = 0.01;
  const auto tension = [&](double motor_N, double humidity) {
    return motor_N * std::exp(-phi * (1 + steep * (humidity - middle)));
  };
  std::size_t i = 0;
  const MeasuredData data = humid_data(
      [&](double motor_N, double humidity) { return tension(motor_N, humidity) + noise_N(i++); });
  const PartialResiduals partial =
      seen(data, with_law(model, humidity_law(Target::exponent, sheaths()), steep));
  ASSERT_EQ(partial.points.size(), 24U);
  for (std::size_t k = 0; k < 24; ++k) {
    const PartialPoint& point = partial.points[k];
    const double slope_N = -phi * tension(*data.readings[k].motor_tension_N, point.x);
    EXPECT_NEAR(point.y, steep * (point.x - middle) + noise_N(k) / slope_N, 1e-6);
    EXPECT_NEAR(point.deviation, 0.05 / std::abs(slope_N), 1e-6);
  }
}

// A coefficient is the same for every reading: what each says of it lies on one line.
TEST(PartialResiduals, OfACoefficientAreItsDifferenceFromTheHardwareOverTheLoad) {
  Model truth = bench_model();
  truth.hardware.sheath.mu = 0.1;
  const double angle = truth.hardware.sheath.whole_angle_rad();
  const MeasuredData data =
      humid_data([&](double motor_N, double) { return motor_N * std::exp(-0.07 * angle); });
  add_effect(truth, {find_cause("sheath_friction"), {}, {0.07}});
  const PartialResiduals partial = seen(data, truth);
  EXPECT_EQ(partial.x.name, "load at the contacts");
  EXPECT_EQ(partial.y.name, "mu - 0.1");
  ASSERT_EQ(partial.points.size(), 24U);
  for (const PartialPoint& point : partial.points) {
    EXPECT_NEAR(point.x, *data.readings[point.reading].motor_tension_N, 1e-9);
    EXPECT_NEAR(point.y, -0.03, 1e-6);
  }
  for (const CurvePoint& at : partial.curve) EXPECT_NEAR(at.y, -0.03, 1e-12);
}

TEST(PartialResiduals, OfALimitAreWhatIsMissingAboveIt) {
  const MeasuredData data =
      humid_data([](double motor_N, double) { return std::min(motor_N, 18.0); });
  Model model = bench_model();
  Subject subject;
  subject.channel = parse_segment("T1");
  add_effect(model, {find_cause("saturation"), subject, {1, 18}});
  Workers workers(1);
  const Sample part = sample(data, 0, 1);
  const auto partial = partial_residuals(part, model, known_noise(0.05), 0,
                                         {Eigen::MatrixXd::Identity(2, 2) * 1e-6, 2}, workers);
  ASSERT_TRUE(partial.has_value());
  EXPECT_EQ(partial->x.name, "tension at the sensor");
  for (const PartialPoint& point : partial->points) {
    EXPECT_NEAR(point.y, std::min(0.0, 18 - point.x), 1e-6);
  }
  for (const CurvePoint& at : partial->curve) {
    EXPECT_NEAR(at.y, std::min(0.0, 18 - at.x), 1e-9);
  }
}

// A sensor that is dead takes away what it should read: y = x wherever it is.
TEST(PartialResiduals, OfATermWithoutSizeAreWhatItChanges) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < 12; ++i) text += fmt::format("r{},M-1-F,{},0,{}\n", i / 4, 10 + i, 10 + i);
  const MeasuredData data = read_data(text);
  Model model = bench_model();
  Subject subject;
  subject.channel = parse_segment("T1");
  add_effect(model, {find_cause("dead_channel"), subject, {}});
  Workers workers(1);
  const Sample part = sample(data, 0, 1);
  const auto partial =
      partial_residuals(part, model, known_noise(0.05), 0, {Eigen::MatrixXd(), 0}, workers);
  ASSERT_TRUE(partial.has_value());
  ASSERT_EQ(partial->points.size(), 12U);  // T2 is as without it
  for (const PartialPoint& point : partial->points) {
    EXPECT_NEAR(point.x, -*data.readings[point.reading].motor_tension_N, 1e-9);
    EXPECT_NEAR(point.y, point.x, 1e-6);
  }
}

TEST(PartialResiduals, TellSealedRunsFromTrainingRuns) {
  const MeasuredData data = humid_data([](double motor_N, double) { return motor_N; });
  const Model model = with_law(bench_model(), humidity_law(Target::gain, sensor_at_T1()), slope);
  const PartialResiduals partial = seen(data, model, 0.0001, 0.34);
  const Sample part = sample(data, 0.34, 1);
  std::size_t held_out = 0;
  for (const PartialPoint& point : partial.points) {
    const auto is_own = [&](const DatasetRow& row) { return row.reading == point.reading; };
    const auto& rows = part.held_out.rows;
    EXPECT_EQ(point.held_out, std::any_of(rows.begin(), rows.end(), is_own));
    held_out += point.held_out ? 1 : 0;
  }
  EXPECT_EQ(held_out, part.held_out.rows.size());
  EXPECT_GT(held_out, 0U);
  EXPECT_TRUE(partial.points.back().held_out);
}

// At a hundredth of the load a reading knows a gain a hundred times worse.
TEST(PartialResiduals, LeaveOutAndCountWhatSaysHardlyAnything) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < 12; ++i) {
    text += fmt::format("r{},M-1-F,{},{}\n", i / 4, i == 5 ? 0.2 : 20, i == 5 ? 0.2 : 21);
  }
  const PartialResiduals partial = seen(read_data(text), with_gain(1.05), 0.001);
  EXPECT_EQ(partial.left_out, 1U);
  EXPECT_EQ(partial.points.size(), 11U);
  for (const PartialPoint& point : partial.points) EXPECT_NEAR(point.y, 0.05, 1e-6);
}

// y = a x: the standard error of a is sd / |x|, and an effect's spread is its interval's.
TEST(EffectSpreads, AreThoseOfTheIntervals) {
  std::vector<BenchReading> readings;
  for (int i = 0; i < 12; ++i) {
    readings.push_back({fmt::format("r{}", i % 2), 10.0 + i, 1.02 * (10.0 + i)});
  }
  const MeasuredData data = bench_data(readings);
  const Dataset all = all_of(data);
  const Problem known = bench_problem(all);
  const Model model = with_gain(1.02);
  const auto intervals = parameter_intervals(known, model);
  const auto spreads = effect_spreads(known, model, intervals);
  ASSERT_EQ(spreads.size(), 1U);
  const double deviation = std::sqrt(spreads[0].covariance(0, 0));
  EXPECT_NEAR(deviation, intervals[0][0].deviation, 1e-12);
  EXPECT_NEAR(spreads[0].t * deviation, intervals[0][0].high - 1.02, 1e-9);
}

}  // namespace
}  // namespace reeve::testing
