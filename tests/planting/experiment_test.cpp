#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "tests/support/planting_experiment.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

Experiment experiment_of(std::uint64_t seed, const ExperimentNeeds& needs = {}) {
  Dice dice(seed);
  return random_experiment(needs, dice);
}

std::map<std::string, int> rows_by_run(const Experiment& experiment) {
  std::map<std::string, int> rows;
  for (const ExperimentRow& row : experiment.rows) ++rows[row.run];
  return rows;
}

TEST(Experiment, HasRunsAndRowsInRange) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto runs = rows_by_run(experiment_of(seed));
    EXPECT_GE(runs.size(), 8U);
    EXPECT_LE(runs.size(), 16U);
    for (const auto& [run, rows] : runs) {
      EXPECT_GE(rows, 12);
      EXPECT_LE(rows, 25);
    }
  }
}

TEST(Experiment, MeasuresEveryRoutingInTwoRuns) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::map<std::string, std::set<std::string>> runs;
    for (const ExperimentRow& row : experiment_of(seed).rows) {
      runs[row.condition.word].insert(row.run);
    }
    EXPECT_GE(runs.size(), 3U);
    EXPECT_LE(runs.size(), 6U);
    for (const auto& [word, of_word] : runs) EXPECT_GE(of_word.size(), 2U) << seed << word;
  }
}

TEST(Experiment, StaysWithinItsConditions) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    double cycle = 0;
    for (const auto& [run, condition, measured, gain] : experiment_of(seed).rows) {
      EXPECT_LE(condition.motor_tension_N, 60);
      EXPECT_GT(condition.motor_tension_N,
                condition.direction == ReferenceDirection::pull ? 4.99 : 0.2);
      EXPECT_GE(condition.speed_mm_s.value_or(1), 1);
      EXPECT_LE(condition.speed_mm_s.value_or(1), 100);
      EXPECT_GE(condition.temperature_C.value_or(20), 10);
      EXPECT_LE(condition.temperature_C.value_or(20), 40);
      EXPECT_GE(condition.cycle.value_or(0), cycle);
      cycle = condition.cycle.value_or(0);
      EXPECT_LE(cycle, 3000);
      EXPECT_LT(condition.held.size(), fingers_of(condition.word).size());
      EXPECT_LE(condition.held.size(), 2U);
      EXPECT_FALSE(measured.empty());
    }
  }
}

TEST(Experiment, VariesWhatIsNeeded) {
  ExperimentNeeds needs;
  needs.speed = needs.cycle = needs.temperature = needs.bearings = true;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::set<double> speeds, cycles, temperatures;
    for (const ExperimentRow& row : experiment_of(seed, needs).rows) {
      speeds.insert(row.condition.speed_mm_s.value());
      cycles.insert(row.condition.cycle.value());
      temperatures.insert(row.condition.temperature_C.value());
      EXPECT_TRUE(has_bearing(row.condition.word));
    }
    EXPECT_GT(speeds.size(), 20U);
    EXPECT_GT(cycles.size(), 20U);
    EXPECT_GT(temperatures.size(), 20U);
  }
}

TEST(Experiment, SometimesReleasesAndSometimesLeavesCellsEmpty) {
  int releases = 0, gaps = 0, motor_sides = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Experiment experiment = experiment_of(seed);
    const auto any = [&](const auto& what) {
      return std::any_of(experiment.rows.begin(), experiment.rows.end(), what);
    };
    releases += any([](const ExperimentRow& row) {
      return row.condition.direction == ReferenceDirection::release;
    });
    gaps += any([](const ExperimentRow& row) {
      const auto strands = std::count_if(row.measured.begin(), row.measured.end(), is_strand);
      return static_cast<std::size_t>(strands) < 2 * fingers_of(row.condition.word).size();
    });
    motor_sides +=
        std::any_of(experiment.channels.begin(), experiment.channels.end(), is_motor_side);
  }
  for (const int count : {releases, gaps, motor_sides}) {
    EXPECT_GT(count, 5);
    EXPECT_LT(count, 40);
  }
}

}  // namespace
}  // namespace reeve::testing
