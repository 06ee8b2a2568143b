#include "diagnosis/plan/experiment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/input_error.hpp"
#include "tests/support/planned.hpp"

namespace reeve::testing {
namespace {

ExperimentPlan full_plan() {
  ExperimentPlan plan = plan_of(three_routings);
  plan.directions = {Direction::pull, Direction::release};
  plan.speed_mm_s = PlannedLevels{{1, 100}, {}};
  plan.cycle = PlannedLevels{{0, 3000}, {}};
  plan.temperature_C = PlannedLevels{{15, 35}, {}};
  return plan;
}

TEST(Experiment, MountsOneRoutingInARunAndEachInTurns) {
  std::map<std::size_t, std::set<std::size_t>> routings_of_run;
  std::map<std::size_t, std::set<std::size_t>> runs_of_routing;
  for (const PlannedReading& reading : schedule(full_plan(), 1)) {
    routings_of_run[reading.run].insert(reading.routing);
    runs_of_routing[reading.routing].insert(reading.run);
  }
  EXPECT_EQ(routings_of_run.size(), 12U);
  for (const auto& [run, routings] : routings_of_run) EXPECT_EQ(routings.size(), 1U);
  EXPECT_EQ(runs_of_routing.size(), 3U);
  for (const auto& [routing, runs] : runs_of_routing) EXPECT_EQ(runs.size(), 4U);
}

TEST(Experiment, KeepsEveryConditionInItsRangeAndCoversIt) {
  std::map<std::size_t, std::set<int>> decades;
  for (const PlannedReading& reading : schedule(full_plan(), 1)) {
    const Conditions& conditions = reading.conditions;
    EXPECT_GE(conditions.motor_tension_N, 5);
    EXPECT_LE(conditions.motor_tension_N, 60);
    EXPECT_GE(conditions.speed_mm_s, 1);
    EXPECT_LE(conditions.speed_mm_s, 100);
    EXPECT_GE(conditions.temperature_C, 15);
    EXPECT_LE(conditions.temperature_C, 35);
    // A part of its own for each of the 20 rows.
    decades[reading.run].insert(static_cast<int>(std::log10(conditions.speed_mm_s) * 9.999));
  }
  for (const auto& [run, parts] : decades) EXPECT_GE(parts.size(), 19U);
}

TEST(Experiment, MeasuresGraspsAndDirectionsEquallyOftenInEveryRun) {
  std::map<std::size_t, std::map<std::pair<std::uint64_t, Direction>, int>> counts;
  for (const PlannedReading& reading : schedule(full_plan(), 1)) {
    ++counts[reading.run][{reading.grasp.held, reading.direction}];
  }
  for (const auto& [run, of_run] : counts) {
    EXPECT_EQ(of_run.size(), 6U);
    for (const auto& [motion, count] : of_run) {
      EXPECT_GE(count, 3);
      EXPECT_LE(count, 4);
    }
  }
}

TEST(Experiment, MeasuresEveryGraspEvenWhereARunHasFewerRows) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.rows = 1;
  plan.runs = 9;
  std::set<std::pair<std::size_t, std::uint64_t>> seen;
  for (const PlannedReading& reading : schedule(plan, 1)) {
    seen.insert({reading.routing, reading.grasp.held});
  }
  EXPECT_EQ(seen.size(), 9U);
}

TEST(Experiment, ChangesEachConditionInAnOrderOfItsOwn) {
  ExperimentPlan plan = full_plan();
  plan.runs = 100;
  double sum = 0;
  std::map<std::uint64_t, std::pair<double, int>> tension_by_grasp;
  const std::vector<PlannedReading> readings = schedule(plan, 1);
  for (const PlannedReading& reading : readings) {
    const Conditions& conditions = reading.conditions;
    sum += (conditions.motor_tension_N - 32.5) * (conditions.temperature_C - 25);
    auto& [total, count] = tension_by_grasp[reading.grasp.held];
    total += conditions.motor_tension_N;
    ++count;
  }
  const auto n = static_cast<double>(readings.size());
  EXPECT_NEAR(sum / n, 0, 4 * 55.0 * 20 / 12 / std::sqrt(n));
  for (const auto& [held, mean] : tension_by_grasp) {
    EXPECT_NEAR(mean.first / mean.second, 32.5, 4 * 55 / std::sqrt(12.0 * mean.second));
  }
}

TEST(Experiment, NeverTurnsTheCycleBack) {
  for (const PlannedLevels& cycle :
       {PlannedLevels{{0, 3000}, {}}, PlannedLevels{{}, {0, 10, 500}}}) {
    ExperimentPlan plan = full_plan();
    plan.cycle = cycle;
    const std::vector<PlannedReading> readings = schedule(plan, 1);
    EXPECT_EQ(readings.front().conditions.cycle, 0);
    EXPECT_EQ(readings.back().conditions.cycle, cycle.list.empty() ? 3000 : 500);
    for (std::size_t i = 1; i < readings.size(); ++i) {
      EXPECT_GE(readings[i].conditions.cycle, readings[i - 1].conditions.cycle);
    }
  }
}

TEST(Experiment, TakesTheLevelsOfAListAndNoOthers) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.motor_tension_N = {{}, {5, 12.5, 40, 60}};
  std::map<double, int> counts;
  for (const PlannedReading& reading : schedule(plan, 1)) {
    ++counts[reading.conditions.motor_tension_N];
  }
  EXPECT_EQ(counts, (std::map<double, int>{{5, 60}, {12.5, 60}, {40, 60}, {60, 60}}));
}

// Those of the two ranges are drawn apart from each other.
TEST(Experiment, BendsTheSheathsInAnOrderOfItsOwn) {
  ExperimentPlan plan = full_plan();
  plan.runs = 100;
  plan.sheath_angle_rad = PlannedLevels{{2, 6}, {}};
  double sum = 0;
  double squares = 0;
  const std::vector<PlannedReading> readings = schedule(plan, 1);
  for (const PlannedReading& reading : readings) {
    sum += (*reading.sheath_angle_rad - 4) * (reading.conditions.temperature_C - 25);
    squares += (*reading.sheath_angle_rad - 4) * (*reading.sheath_angle_rad - 4);
  }
  const auto n = static_cast<double>(readings.size());
  EXPECT_NEAR(sum / n, 0, 4 * 4.0 * 20 / 12 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 16.0 / 12, 0.1);
}

double recorded(const PlannedReading& reading, const std::string& column) {
  for (const NamedValue& value : reading.conditions.record->columns) {
    if (value.name == column) return value.value;
  }
  ADD_FAILURE() << column;
  return 0;
}

TEST(Experiment, ChangesAFurtherColumnFromReadingToReadingOrFromRunToRun) {
  ExperimentPlan plan = full_plan();
  plan.columns = {{"humidity_pct", {{20, 80}, {}}},
                  {"supply_V", {{22, 26}, {}}, true},
                  {"liner", {{}, {1, 2, 3}}, true}};
  std::map<std::size_t, std::set<double>> humidity, supply, liner;
  for (const PlannedReading& reading : schedule(plan, 1)) {
    humidity[reading.run].insert(reading.columns[0]);
    supply[reading.run].insert(reading.columns[1]);
    liner[reading.run].insert(reading.columns[2]);
    EXPECT_EQ(recorded(reading, "humidity_pct"), reading.columns[0]);
    EXPECT_EQ(recorded(reading, "liner"), reading.columns[2]);
    EXPECT_EQ(reading.conditions.record->run, std::to_string(reading.run + 1));
    EXPECT_EQ(recorded(reading, "run"), static_cast<double>(reading.run + 1));
    EXPECT_EQ(recorded(reading, "order"), reading.conditions.order);
  }
  std::set<double> supplies;
  std::map<double, int> liners;
  for (std::size_t run = 0; run < 12; ++run) {
    EXPECT_EQ(humidity[run].size(), 20U);
    EXPECT_GE(*humidity[run].begin(), 20);
    EXPECT_LE(*humidity[run].rbegin(), 80);
    EXPECT_EQ(supply[run].size(), 1U);
    EXPECT_EQ(liner[run].size(), 1U);
    supplies.insert(supply[run].begin(), supply[run].end());
    ++liners[*liner[run].begin()];
  }
  EXPECT_EQ(supplies.size(), 12U);
  EXPECT_GE(*supplies.begin(), 22);
  EXPECT_LE(*supplies.rbegin(), 26);
  EXPECT_EQ(liners, (std::map<double, int>{{1, 4}, {2, 4}, {3, 4}}));
}

// Nor do further columns change what else is planned.
TEST(Experiment, ChangesFurtherColumnsInOrdersOfTheirOwn) {
  ExperimentPlan plan = full_plan();
  const std::vector<PlannedReading> without = schedule(plan, 1);
  plan.columns = {{"x", {{0, 1}, {}}}, {"y", {{0, 1}, {}}}};
  const std::vector<PlannedReading> readings = schedule(plan, 1);
  int higher = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(readings[i].conditions.motor_tension_N, without[i].conditions.motor_tension_N);
    EXPECT_EQ(readings[i].conditions.speed_mm_s, without[i].conditions.speed_mm_s);
    higher += readings[i].columns[0] > readings[i].columns[1] ? 1 : 0;
  }
  EXPECT_GT(higher, 80);
  EXPECT_LT(higher, 160);
}

TEST(Experiment, KnowsThePlaceOfEachReadingInItsFile) {
  const std::vector<PlannedReading> readings = schedule(full_plan(), 1);
  EXPECT_EQ(readings.front().conditions.order, 0);
  EXPECT_EQ(readings.back().conditions.order, 1);
  EXPECT_EQ(readings[1].conditions.order, 1 / static_cast<double>(readings.size() - 1));
}

TEST(Experiment, ShowsWhatItVaries) {
  ExperimentPlan plan = plan_of(three_routings);
  EXPECT_TRUE(survey(plan).has_motor_tension);
  EXPECT_FALSE(survey(plan).has_both_directions);
  EXPECT_FALSE(survey(plan).sheath_angle_varies);
  plan.directions = {Direction::release, Direction::pull};
  EXPECT_TRUE(survey(plan).has_both_directions);
  plan.sheath_angle_rad = PlannedLevels{{}, {3}};
  EXPECT_FALSE(survey(plan).sheath_angle_varies);
  plan.sheath_angle_rad = PlannedLevels{{}, {3, 4}};
  EXPECT_TRUE(survey(plan).sheath_angle_varies);
  plan.sheath_angle_rad = PlannedLevels{{3, 3}, {}};
  EXPECT_FALSE(survey(plan).sheath_angle_varies);
  plan.sheath_angle_rad = PlannedLevels{{3, 4}, {}};
  EXPECT_TRUE(survey(plan).sheath_angle_varies);
}

TEST(Experiment, LeavesConditionsThatItDoesNotHaveAtTheReference) {
  for (const PlannedReading& reading : schedule(plan_of(three_routings), 1)) {
    EXPECT_EQ(reading.conditions.speed_mm_s, Conditions{}.speed_mm_s);
    EXPECT_EQ(reading.conditions.cycle, Conditions{}.cycle);
    EXPECT_EQ(reading.conditions.temperature_C, Conditions{}.temperature_C);
    EXPECT_FALSE(reading.sheath_angle_rad.has_value());
  }
}

TEST(Experiment, RepeatsReadingsUnderTheSameConditions) {
  ExperimentPlan plan = full_plan();
  const std::vector<PlannedReading> once = schedule(plan, 1);
  plan.repeats = 3;
  const std::vector<PlannedReading> readings = schedule(plan, 1);
  ASSERT_EQ(readings.size(), 3 * once.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(readings[i].repeat, i % 3);
    EXPECT_EQ(readings[i].conditions.motor_tension_N, once[i / 3].conditions.motor_tension_N);
    EXPECT_EQ(readings[i].grasp, once[i / 3].grasp);
  }
}

TEST(Experiment, IsDecidedByPlanAndSeed) {
  const auto tensions = [](std::uint64_t seed) {
    std::vector<double> result;
    for (const PlannedReading& reading : schedule(full_plan(), seed)) {
      result.push_back(reading.conditions.motor_tension_N);
    }
    return result;
  };
  EXPECT_EQ(tensions(5), tensions(5));
  EXPECT_NE(tensions(5), tensions(6));
}

TEST(Experiment, ThatCannotBeDoneIsNamed) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.runs = 2;
  EXPECT_EQ(input_error([&] { validate(plan); }),
            "runs = 2: expected at least 3, one for each routing (two are better)");
  plan.runs = 1000;
  plan.rows = 1000;
  validate(plan);
  plan.repeats = 2;
  EXPECT_EQ(input_error([&] { validate(plan); }),
            "runs = 1000, of 1000 rows and 2 repeats: expected 1000000 readings at most");
  plan = plan_of(three_routings);
  plan.cycle = PlannedLevels{{}, {10, 5}};
  EXPECT_EQ(input_error([&] { validate(plan); }), "cycles: expected a list that rises");
  plan = plan_of(three_routings);
  plan.channels.push_back(parse_segment("h1"));
  EXPECT_EQ(input_error([&] { validate(plan); }), "channels: 'h1': no routing has that segment");
  plan = plan_of(three_routings);
  plan.routings.push_back(planned_routing("M-F"));
  EXPECT_EQ(input_error([&] { validate(plan); }),
            "channels: none of them is a segment of M-F: expected at least one for each routing");
}

}  // namespace
}  // namespace reeve::testing
