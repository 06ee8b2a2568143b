// What an interval has to do, however it is computed: cover the truth as often as it says, and be
// as wide as noise, misfit and scatter from run to run ask for.
#include "diagnosis/fit/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

using Intervals = std::vector<std::vector<ParameterInterval>>;

Intervals intervals(const Problem& problem, const Model& model) {
  return parameter_intervals(problem, fit(problem, model).model);
}

// Of the offset on T1.
ParameterInterval interval(const Problem& problem) {
  return intervals(problem, on_T1.model(0.5)).at(0).at(0);
}

double half_width(const ParameterInterval& interval) { return (interval.high - interval.low) / 2; }

// T1 is off by 1 N, and in each run by something of its own.
OffsetsByRun scattered(std::uint64_t seed, double scatter_N) {
  return [=](std::size_t run) { return Pattern{1 + scatter_N * normal(seed, 0x5ca7, run)}; };
}

// How many of the intervals cover 1 N, and how wide they are on average.
struct Coverage {
  int covered = 0;
  double half_width = 0;
};

Coverage coverage(std::uint64_t sets, std::size_t runs, std::size_t rows, double scatter_N) {
  Coverage result;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const Bench bench({runs, rows, seed}, scattered(seed, scatter_N));
    const ParameterInterval found = interval(bench.problem);
    result.covered += found.low <= 1 && 1 <= found.high ? 1 : 0;
    result.half_width += half_width(found) / static_cast<double>(sets);
  }
  return result;
}

constexpr std::uint64_t covered_sets = 300;
// 95 % of 300, less three standard deviations.
constexpr int expected_at_least = 274;

TEST(ParameterIntervals, CoverTheTruthWhereReadingsAreIndependent) {
  const Coverage found = coverage(covered_sets, 6, 5, 0);
  EXPECT_GE(found.covered, expected_at_least);
  EXPECT_LT(found.half_width, 2 * 1.96 * bench_noise_N / std::sqrt(30));
}

TEST(ParameterIntervals, CoverTheTruthWhereRunsDiffer) {
  const Coverage found = coverage(covered_sets, 8, 3, 0.3);
  EXPECT_GE(found.covered, expected_at_least);
  // Student's t of seven degrees of freedom, 2.36, times the standard error of eight runs.
  EXPECT_NEAR(found.half_width, 2.36 * 0.3 / std::sqrt(8), 0.15 * 2.36 * 0.3 / std::sqrt(8));
}

// Of runs alike each gives one number, and the interval of their mean is Student's.
TEST(ParameterIntervals, OfFourRunsAlikeAreThoseOfTheFourMeans) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Bench bench({4, 3, seed, 0.001}, scattered(seed, 1));
    double mean = 0;
    double squares = 0;
    for (std::size_t run = 0; run < 4; ++run) mean += normal(seed, 0x5ca7, run) / 4;
    for (std::size_t run = 0; run < 4; ++run) {
      squares += std::pow(normal(seed, 0x5ca7, run) - mean, 2);
    }
    const double expected = 3.182 * std::sqrt(squares / 3 / 4);
    const ParameterInterval found = interval(bench.problem);
    EXPECT_NEAR(half_width(found), expected, 0.1 * expected) << seed;
    EXPECT_NEAR((found.low + found.high) / 2, 1 + mean, 0.01) << seed;
  }
}

TEST(ParameterIntervals, WidenWithTheScatterFromRunToRun) {
  double last = 0;
  for (const double scatter : {0.0, 0.2, 0.5, 1.0}) {
    const Bench bench({8, 3, 1}, scattered(1, scatter));
    const double width = half_width(interval(bench.problem));
    EXPECT_GT(width, 1.5 * last) << scatter;
    last = width;
  }
}

// Also where chance left less than the noise: half of the data sets.
TEST(ParameterIntervals, AreNeverNarrowerThanTheNoiseMakesThem) {
  const double known = 1.96 * bench_noise_N / std::sqrt(30);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const std::size_t runs : {1U, 6U}) {
      const Bench bench({1}, {runs, 30 / runs, seed});
      EXPECT_GE(half_width(interval(bench.problem)), known) << seed << ", " << runs << " runs";
    }
  }
}

// In one run, so that no other run shows it: a deviation that is four times too small, and an
// offset on T2 that nothing explains.
TEST(ParameterIntervals, WidenWithTheMisfit) {
  Bench bench({1}, {1, 30});
  const double right = half_width(interval(bench.problem));
  EXPECT_NEAR(right, 1.98 * bench_noise_N / std::sqrt(30), 0.25 * right);
  bench.problem.deviation_N /= 4;
  EXPECT_NEAR(half_width(interval(bench.problem)), right, 0.25 * right);
  const Bench unexplained({1, 0.5}, {1, 30});
  // 30 of 120 residuals are 10 standard deviations: 25 times the misfit.
  EXPECT_NEAR(half_width(interval(unexplained.problem)) / right, std::sqrt(26), 1);
}

TEST(ParameterIntervals, OfCausesThatLookAlikeAreWide) {
  const Bench bench({1});
  Model both = on_T1.model(0.5);
  add_effect(both, nearly_on_T1.model(0.5).effects[0]);
  const Intervals found = intervals(bench.problem, both);
  ASSERT_EQ(found.size(), 2U);
  for (const auto& of_effect : found) {
    ASSERT_EQ(of_effect.size(), 1U);
    EXPECT_GT(half_width(of_effect[0]), 20 * half_width(interval(bench.problem)));
  }
}

TEST(ParameterIntervals, LieWithinTheRangeOfTheParameter) {
  const PatternCause narrow("narrow", {1}, {0.995, 1.005});
  const Bench bench({1});
  const ParameterInterval found = intervals(bench.problem, narrow.model(1)).at(0).at(0);
  EXPECT_EQ(found.low, 0.995);
  EXPECT_EQ(found.high, 1.005);
}

TEST(ParameterIntervals, OfAModelWithoutEffectsAreNone) {
  const Bench bench(Pattern{});
  EXPECT_TRUE(parameter_intervals(bench.problem, {}).empty());
}

// Half the width of a mean over so many readings, of which scatter between runs says more than
// noise.
double by_scatter(double square, double degrees_t, double readings) {
  return degrees_t * std::sqrt(square * bench_noise_N * bench_noise_N / readings);
}

// T2 is read in two of eight runs: its own scatter between them is not known, and it is taken to
// scatter as T1 and T2 do together.
TEST(ParameterIntervals, OfWhatTwoRunsTellTakeTheScatterOfAllParameters) {
  const Bench whole({8, 3, 5, 0.001}, [](std::size_t run) {
    return Pattern{1 + normal(5, 0x5ca7, run), 2 + normal(6, 0x5ca7, run)};
  });
  Bench bench(Pattern{});
  bench.data = whole.data;
  for (Reading& reading : bench.data.readings) {
    if (reading.run > 1) reading.tension_N[1].reset();
  }
  bench.dataset = all_of(bench.data);
  bench.problem = problem(
      bench.dataset, Eigen::VectorXd::Constant(
                         static_cast<Eigen::Index>(bench.dataset.cells.size()), bench_noise_N));
  double square = 0;
  for (const auto& [seed, runs] : {std::pair{5U, 8U}, std::pair{6U, 2U}}) {
    double mean = 0;
    for (std::size_t run = 0; run < runs; ++run) mean += normal(seed, 0x5ca7, run) / runs;
    for (std::size_t run = 0; run < runs; ++run) {
      square += 3 * std::pow((normal(seed, 0x5ca7, run) - mean) / bench_noise_N, 2) / (10 - 2);
    }
  }
  Model two = on_T1.model(0.5);
  add_effect(two, on_T2.model(0.5).effects[0]);
  const Intervals found = intervals(bench.problem, two);
  const double expected = by_scatter(square, 2.306, 6);
  EXPECT_NEAR(half_width(found.at(1).at(0)), expected, 0.01 * expected);
}

// How runs differ is not to be seen in three.
TEST(ParameterIntervals, OfThreeRunsAreThoseOfIndependentReadings) {
  const Bench bench({3, 8}, [](std::size_t run) {
    return Pattern{1 + 0.3 * normal(1, 0x5ca7, run), 1 + 0.3 * normal(2, 0x5ca7, run)};
  });
  Model both = on_T1.model(0.5);
  add_effect(both, on_T2.model(0.5).effects[0]);
  const Model fitted = fit(bench.problem, both).model;
  const Forecast at = forecast(bench.dataset, fitted);
  const double spread = residuals(bench.problem, at).squaredNorm() / (4 * 24 - 2);
  const double expected = by_scatter(spread, 1.986, 24);
  EXPECT_NEAR(half_width(parameter_intervals(bench.problem, fitted).at(0).at(0)), expected,
              0.01 * expected);
}

TEST(ParameterIntervals, OfWhatNoReadingDependsOnAreTheRangeOfTheParameter) {
  const PatternCause nowhere("nowhere", {});
  const Bench bench({1});
  const ParameterInterval found = parameter_intervals(bench.problem, nowhere.model(0)).at(0).at(0);
  EXPECT_EQ(found.low, -20);
  EXPECT_EQ(found.high, 20);
}

// T1 scatters from run to run, T2 does not.
TEST(ParameterIntervals, OfFourRunsAreThoseOfTheParametersOwnScatter) {
  const Bench bench({4, 8}, [](std::size_t run) { return Pattern{1 + normal(1, 0x5ca7, run), 1}; });
  Model both = on_T1.model(0.5);
  add_effect(both, on_T2.model(0.5).effects[0]);
  Bench cleaned({4, 8}, [](std::size_t) { return Pattern{0, 1}; });
  const double own = half_width(intervals(cleaned.problem, on_T2.model(0.5)).at(0).at(0));
  const double beside = half_width(intervals(bench.problem, both).at(1).at(0));
  EXPECT_LT(beside, 10 * own);
  EXPECT_GT(half_width(intervals(bench.problem, both).at(0).at(0)), 10 * beside);
}

}  // namespace
}  // namespace reeve::testing
