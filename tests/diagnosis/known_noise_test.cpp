#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/verdict/held_out.hpp"
#include "numerics/random.hpp"
#include "readings/reading_options.hpp"
#include "tests/diagnosis/gain_bench.hpp"

namespace reeve::testing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ReadingOptions told(const std::vector<std::string>& noise) {
  ReadingOptions options;
  for (const std::string& text : noise) options.noise.push_back(parse_column_noise(text));
  return options;
}

TEST(KnownNoise, IsReadFromWordsOrRefused) {
  const ColumnNoise both = parse_column_noise("F=1 = 2 % + 0.3 N");
  EXPECT_EQ(both.column, "F=1");
  EXPECT_DOUBLE_EQ(both.noise.relative, 0.02);
  EXPECT_DOUBLE_EQ(both.noise.absolute_N, 0.3);
  EXPECT_DOUBLE_EQ(both.noise.deviation(20), 0.5);
  EXPECT_EQ(parse_column_noise("motor=0.3N+2%").noise.relative, 0.02);
  for (const char* text : {"", "T1", "=2%", "T1=2%+3%", "T1=nan%", "T1=%", "T1=1N+"}) {
    EXPECT_EQ(input_error([&] { parse_column_noise(text); }),
              "'" + std::string(text) +
                  "': expected a column of tensions or 'motor', '=', and the standard deviation of "
                  "a reading, such as T1=2%, motor=0.5N or T1=2%+0.3N");
  }
}

TEST(KnownNoise, IsRefusedWithWhatIsWrongWithTheNumber) {
  const auto error = [](const std::string& text) {
    return input_error([&] { parse_column_noise(text); });
  };
  EXPECT_EQ(error("motor=0"),
            "'motor=0': noise without a unit '0': expected a share with %, or a force with N, such "
            "as 0.5N");
  EXPECT_EQ(error("T1=-2%"), "'T1=-2%': a standard deviation below 0 '-2%': expected 0 or more");
  EXPECT_EQ(error("T1=1N+101%"),
            "'T1=1N+101%': a standard deviation '101%': expected at most 100%, beyond which a "
            "reading says nothing");
  EXPECT_EQ(error("T1=2e9N"), "'T1=2e9N': a standard deviation '2e9N': expected at most 1e+09N");
  EXPECT_EQ(parse_column_noise("motor=0N").noise.absolute_N, 0);
}

TEST(KnownNoise, IsThatOfTheColumnsThatAreNamed) {
  const std::string text =
      "run,routing,motor_tension_N,motor_tension_sd_N,readings,T1_N,Ta_N,Kraft\n"
      "A,TR5,20,3,9,5,10,8\nA,TR5,20,,,5,10,8\n";
  ReadingOptions options = told({"motor=0.5N", "T1=2%", "Kraft=0N"});
  options.map = {parse_column_meaning("Kraft=T2_N")};
  const MeasuredData data = read_data(text, options);
  EXPECT_EQ(motor_deviation(data, data.readings[0]), 1);  // 3 / √9, more than what was told
  EXPECT_EQ(motor_deviation(data, data.readings[1]), 0.5);
  EXPECT_EQ(known_noise(data, 0)->relative, 0.02);
  EXPECT_EQ(known_noise(data, 1), std::nullopt);
  EXPECT_EQ(known_noise(data, 2)->deviation(8), 0);
  EXPECT_EQ(note_text(data.notes, NoteKind::known_noise),
            "what readings scatter by is taken as told: motor_tension_N 0.5 N, T1_N 2 %, Kraft "
            "exact (one standard deviation)");
  EXPECT_EQ(data_error(text, told({"T9=2%"})),
            "d.csv:1: the header has no column of tensions 'T9': expected the column whose noise "
            "is given");
  EXPECT_EQ(data_error(text, told({"T1=2%", "T1_N=3%"})),
            "d.csv:1: column 6 'T1_N': expected one noise, and 2 are given");
  EXPECT_EQ(data_error("run,routing,motor_tension_sd_N,T1_N\nA,TR5,1,2\n"),
            "d.csv:1: column 3 'motor_tension_sd_N': expected the column motor_tension_N beside "
            "it");
}

std::vector<BenchReading> readings(double motor_noise_N, double noise_N, std::size_t count) {
  std::vector<BenchReading> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double pull_N = 5 + 0.25 * static_cast<double>(i % 20);
    result.push_back({fmt::format("{}", i / 10), pull_N + motor_noise_N * normal(8, 1, i),
                      1.1 * pull_N + noise_N * normal(8, 2, i)});
  }
  return result;
}

// W. E. Deming's line through 0 of two readings that both scatter, by 0.1 N and by s_M.
double deming(const std::vector<BenchReading>& readings, double motor_noise_N) {
  double xx = 0, xy = 0, yy = 0;
  for (const BenchReading& reading : readings) {
    xx += reading.motor_tension_N * reading.motor_tension_N;
    xy += reading.motor_tension_N * reading.reading_N;
    yy += reading.reading_N * reading.reading_N;
  }
  const double ratio = std::pow(bench_deviation_N / motor_noise_N, 2);
  const double half = (yy - ratio * xx) / 2;
  return (half + std::sqrt(half * half + ratio * xy * xy)) / xy;
}

// A regression on what was read would find 2 % less.
TEST(KnownNoise, OfTheMotorTensionMakesTheFitOneOfErrorsInVariables) {
  constexpr double motor_noise_N = 1;
  const auto measured = readings(motor_noise_N, bench_deviation_N, 400);
  MeasuredData data = bench_data(measured);
  data.known_motor_noise = KnownNoise{.absolute_N = motor_noise_N};
  const Dataset dataset = all_of(data);
  const Fit found = fit(bench_problem(dataset), with_gain(1));
  const double gain = deming(measured, motor_noise_N);
  EXPECT_NEAR(found.model.effects[0].values[0], gain, 1e-5);
  EXPECT_GT(gain, gain_without(measured, "none") + 0.015);
  EXPECT_NEAR(gain, 1.1, 0.02);
}

// Screening would else see what is left of it in the residuals, and call that a law.
TEST(KnownNoise, OfTheMotorTensionLeavesNothingOfAFittedParameter) {
  MeasuredData data = bench_data(readings(1, bench_deviation_N, 400));
  data.known_motor_noise = KnownNoise{.absolute_N = 1};
  const Dataset dataset = all_of(data);
  const Problem bench = bench_problem(dataset);
  const Model model = fit(bench, with_gain(1)).model;
  const Forecast at = forecast(dataset, model);
  Model beside = model;
  beside.effects[0].values[0] += 1e-3;
  const VectorXd change = difference(bench, at, forecast(dataset, beside));
  const Projection projection(bench, model, at);
  EXPECT_LT(projection.taken_out(change).norm(), 1e-6 * change.norm());
}

TEST(KnownNoise, OfTheMotorTensionIsSharedByTheRow) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N,T2_N,T3_N\nA,TR5,20,5,6,7\nA,TR5,30,9,8,7\n",
                told({"motor=2N"}));
  const Dataset dataset = all_of(data);
  const VectorXd deviation = VectorXd::LinSpaced(6, 0.1, 0.6);
  const Problem rig = problem(dataset, deviation);
  const Forecast at = forecast(dataset, {});
  const VectorXd left = rig.measured_N - at.reading_N;
  MatrixXd covariance = MatrixXd::Zero(6, 6);
  for (const Index first : {0, 3}) {
    const double motor_N = first == 0 ? 20 : 30;
    const VectorXd by_N = at.reading_N.segment(first, 3) / motor_N;
    covariance.block(first, first, 3, 3) = 4 * by_N * by_N.transpose();
  }
  covariance.diagonal() += deviation.cwiseAbs2();
  EXPECT_NEAR(own_residuals(rig, at).squaredNorm(), left.dot(covariance.ldlt().solve(left)), 1e-9);
  // Replicates scatter alike: each is a χ² of six.
  const Projection projection(rig, {}, at);
  const NullModel null(rig, projection, at, 3, 2000);
  double sum = 0;
  Workers workers(1);
  std::vector<double> squares(2000);
  null.for_each(workers, [&](std::size_t first, const Eigen::MatrixXd& drawn) {
    for (const auto& one : drawn.colwise()) squares[first++] = one.squaredNorm();
  });
  for (const double square : squares) sum += square / 2000;
  EXPECT_NEAR(sum, 6, 4 * std::sqrt(12.0 / 2000));
}

// The residual that the verdict tells is the reading less the forecast.
TEST(KnownNoise, OfTheMotorTensionIsNotTakenOutOfResidualsInNewton) {
  MeasuredData data = bench_data({{"a", 20, 26}, {"b", 20, 18}});
  data.known_motor_noise = KnownNoise{.absolute_N = 2};
  const Dataset dataset = all_of(data);
  const Problem bench = bench_problem(dataset);
  const Forecast at = forecast(dataset, bench_model());
  EXPECT_NEAR(held_out_gain(bench, at, at, 1).rms_before_N, std::sqrt((36.0 + 4) / 2), 1e-9);
  const RunGain run = run_gains(bench, at, at)[0];
  EXPECT_NEAR(run.rms_before_N, 6, 1e-9);
  EXPECT_NEAR(run.rms_noise_N, std::hypot(bench_deviation_N, 2), 1e-9);
}

// Chance in the reading may not decide what it weighs.
TEST(KnownNoise, OfTheMotorTensionIsTakenWhereTheOtherReadingsSeeIt) {
  const MeasuredData data = read_data("run,routing,motor_tension_N,T1_N\nA,M-1-F,22,20\n",
                                      told({"motor=10%", "T1=0.01N"}));
  const Dataset dataset = all_of(data);
  Problem rig = problem(dataset, VectorXd::Constant(1, 0.01));
  EXPECT_DOUBLE_EQ(rig.motor_deviation_N[0], 2.2);
  settle_motor_deviations(rig, forecast(dataset, bench_model()));
  EXPECT_NEAR(rig.motor_deviation_N[0], 2.0, 1e-4);
}

TEST(KnownNoise, OfAChannelIsNotEstimated) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N\n";
  for (std::size_t i = 0; i < 200; ++i) {
    text += fmt::format("A,M-1-F,20,{},{}\n", 8 + normal(5, 1, i), 8 + 0.1 * normal(5, 2, i));
  }
  const auto both = read_data(text);
  const auto one = read_data(text, told({"T1=1N"}));
  EXPECT_GT(noise_without_model(all_of(both))->deviation(8), 0.2);
  const Dataset dataset = all_of(one);
  const Noise noise = *noise_without_model(dataset);
  EXPECT_NEAR(noise.deviation(8), 0.1, 0.02);
  const VectorXd sd = deviations(dataset, noise, forecast(dataset, {}).reading_N);
  EXPECT_EQ(sd[0], 1);
  EXPECT_NEAR(sd[1], 0.1, 0.02);
}

// The readings of a row tell what its motor tension was.
TEST(KnownNoise, OfTheMotorTensionIsNotThatOfTheChannels) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N\n";
  for (std::size_t i = 0; i < 200; ++i) {
    const double pull = 20 * (1 + 0.1 * normal(6, 0, i));
    text += fmt::format("A,M-1-F,20,{},{}\n", 0.5 * pull * (1 + 0.01 * normal(6, 1, i)),
                        0.4 * pull * (1 + 0.01 * normal(6, 2, i)));
  }
  EXPECT_GT(noise_without_model(all_of(read_data(text)))->deviation(10), 0.5);
  const MeasuredData data = read_data(text, told({"motor=10%"}));
  EXPECT_NEAR(noise_without_model(all_of(data))->deviation(10), 0.1, 0.02);
}

}  // namespace
}  // namespace reeve::testing
