#include "diagnosis/search/cross_validation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/gain_bench.hpp"

namespace reeve::testing {
namespace {

const std::vector<BenchReading> agreeing{{"a", 10, 11.1}, {"a", 20, 21.9}, {"b", 15, 16.4},
                                         {"c", 12, 13.3}, {"c", 30, 32.8}, {"d", 18, 19.9}};

double misfit_of(const std::vector<BenchReading>& readings, const std::string& run, double gain) {
  double sum = 0;
  for (const BenchReading& reading : readings) {
    if (reading.run != run) continue;
    sum += std::pow((reading.reading_N - gain * reading.motor_tension_N) / bench_deviation_N, 2);
  }
  return sum;
}

double gain_by_hand(const std::vector<BenchReading>& readings,
                    const std::vector<std::string>& runs) {
  double gain = 0;
  for (const std::string& run : runs) {
    gain +=
        (misfit_of(readings, run, 1) - misfit_of(readings, run, gain_without(readings, run))) / 2;
  }
  return gain;
}

double left_out_gain(const Problem& problem, const Model& before, const Model& after) {
  return reeve::left_out_gain(left_out_misfits(problem, before), left_out_misfits(problem, after));
}

double left_out_gain_of(const std::vector<BenchReading>& readings) {
  const MeasuredData data = bench_data(readings);
  const Dataset part = all_of(data);
  return left_out_gain(bench_problem(part), bench_model(), with_gain(gain_without(readings, "")));
}

TEST(LeftOutGain, ForecastsEachRunByAFitToTheOthers) {
  const double expected = gain_by_hand(agreeing, {"a", "b", "c", "d"});
  EXPECT_GT(expected, 100);
  EXPECT_NEAR(left_out_gain_of(agreeing), expected, 1e-5 * expected);
}

// Fitted to both, the gain improves on no gain; each run alone says the opposite of the other.
TEST(LeftOutGain, IsNegativeWhereRunsContradictEachOther) {
  const std::vector<BenchReading> readings{
      {"a", 10, 12}, {"a", 20, 24}, {"b", 10, 8.5}, {"b", 20, 17}};
  EXPECT_LT(gain_by_hand(readings, {"a", "b"}), 0);
  EXPECT_NEAR(left_out_gain_of(readings), gain_by_hand(readings, {"a", "b"}), 1e-3);
}

// Run d alone reads the channel that the parameter is about.
TEST(LeftOutGain, PassesOverARunThatAloneKnowsAParameter) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,Ta_N\na,M-1-F,10,,10\nb,M-1-F,20,,20\nc,M-1-F,30,,30\n"
      "d,M-1-F,10,13,10\n");
  const Dataset part = all_of(data);
  EXPECT_EQ(left_out_gain(bench_problem(part), bench_model(), with_gain(1.3)), 0);
}

}  // namespace
}  // namespace reeve::testing
