#include "reports/simulation_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "causes/named_effect.hpp"
#include "core/notation.hpp"
#include "readings/measured_data.hpp"
#include "tests/support/has.hpp"
#include "tests/support/planned.hpp"

namespace reeve::testing {
namespace {

SimulationReport report_of(ExperimentPlan plan, const std::vector<NamedEffect>& causes,
                           const AddedNoise& noise = {}) {
  SimulationReport report;
  report.plan = std::move(plan);
  for (const NamedEffect& cause : causes) {
    add_effect(report.model, effect_of(cause, survey(report.plan), report.model.hardware));
  }
  report.noise = noise;
  report.seed = 7;
  report.command = "reeve simulate --routings TR1\n";
  report.simulation = simulate(report.plan, report.model, noise, report.seed);
  return report;
}

MeasuredData read_back(const SimulationReport& report) {
  return parse_measured_data(simulation_csv(report), "s.csv", [&](const std::string& text) {
    return parse_routing(text == "TR1" ? "M-1-T-2-F" : text);
  });
}

ExperimentPlan full_plan() {
  ExperimentPlan plan = plan_of({"M-1-T-2-F", "M-1-P-2-M", "M-1-F"});
  plan.routings[0].label = "TR1";
  plan.routings[1].grasps.push_back(hold({1, 2}));
  plan.directions = {Direction::pull, Direction::release};
  plan.speed_mm_s = PlannedLevels{{0.01, 100}, {}};
  plan.cycle = PlannedLevels{{0, 1e9}, {}};
  plan.temperature_C = PlannedLevels{{-20, 35}, {}};
  plan.sheath_angle_rad = PlannedLevels{{0, 7}, {}};
  plan.channels.push_back(parse_segment("a"));
  plan.channels.push_back(parse_segment("d"));
  return plan;
}

TEST(SimulationCsv, HasAColumnForEachFurtherOneAndSaysTheHiddenLaw) {
  ExperimentPlan plan = full_plan();
  plan.columns = {{"humidity, pct", {{20, 80}, {}}}, {"supply_V", {{}, {22, 26}}, true}};
  const SimulationReport report =
      report_of(plan, {{"law[gain of T3, supply_V, linear]", {{"a", "0.02"}}}});
  EXPECT_TRUE(has(simulation_csv(report),
                  "# hidden cause: law[gain of T3, supply_V, linear] (a = 0.02, middle = 24, range "
                  "= 22:26)\n"));
  const MeasuredData data = read_back(report);
  ASSERT_EQ(data.covariates, (std::vector<std::string>{"humidity, pct", "supply_V"}));
  for (std::size_t i = 0; i < data.readings.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_EQ(data.readings[i].covariates[c], report.simulation.readings[i].columns[c]);
    }
  }
}

TEST(SimulationCsv, GivesThePlannedConditionsBackBitByBit) {
  const SimulationReport report = report_of(full_plan(), {{"pretension", {{"tension_N", "1"}}}});
  const MeasuredData data = read_back(report);
  const std::vector<PlannedReading>& planned = report.simulation.readings;
  ASSERT_EQ(data.readings.size(), planned.size());
  EXPECT_EQ(data.runs.size(), report.plan.runs);
  EXPECT_EQ(data.channels.size(), 6U);
  EXPECT_TRUE(data.covariates.empty());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const Reading& reading = data.readings[i];
    const Conditions& conditions = planned[i].conditions;
    EXPECT_EQ(data.runs[reading.run], std::to_string(planned[i].run + 1));
    EXPECT_EQ(data.routings[reading.routing].word, report.plan.routings[planned[i].routing].word);
    EXPECT_EQ(reading.grasp, planned[i].grasp);
    EXPECT_EQ(reading.direction, planned[i].direction);
    EXPECT_EQ(reading.motor_tension_N, conditions.motor_tension_N);
    EXPECT_EQ(reading.speed_mm_s, conditions.speed_mm_s);
    EXPECT_EQ(reading.cycle, conditions.cycle);
    EXPECT_EQ(reading.temperature_C, conditions.temperature_C);
    EXPECT_EQ(reading.sheath_angle_rad, planned[i].sheath_angle_rad);
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      const std::optional<double>& simulated = report.simulation.tension_N[i][c];
      ASSERT_EQ(reading.tension_N[c].has_value(), simulated.has_value());
      if (simulated) {
        EXPECT_NEAR(*reading.tension_N[c], *simulated, 5e-6 * *simulated);
      }
    }
  }
}

TEST(SimulationCsv, HasNoColumnOfWhatIsNotGiven) {
  const std::string csv = simulation_csv(report_of(plan_of({"M-1-P-2-M"}), {}));
  EXPECT_TRUE(has(csv, "\nrun,routing,held,direction,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n"));
}

TEST(SimulationCsv, TellsRepetitionsApart) {
  ExperimentPlan plan = plan_of({"M-1-P-2-M"});
  plan.repeats = 2;
  const MeasuredData data = read_back(report_of(plan, {}, {0, 0}));
  EXPECT_EQ(data.covariates, std::vector<std::string>{"repeat"});
  EXPECT_EQ(data.readings[1].covariates[0], 2);
  for (const DataNote& note : data.notes) EXPECT_NE(note.kind, NoteKind::duplicate) << note.text;
}

TEST(SimulationCsv, BeginsWithWhatIsHiddenAndHowItWasMade) {
  const SimulationReport report = report_of(
      full_plan(),
      {{"wear", {{"change", "-0.4"}, {"cycles", "300"}}}, {"seized_contact[M-1-P-2-M,T1-T2]", {}}});
  const std::string csv = simulation_csv(report);
  EXPECT_TRUE(csv.starts_with("# simulated by reeve "));
  EXPECT_TRUE(read_back(report).simulated);
  const std::string head = csv.substr(0, csv.find("\nrun,"));
  for (const char* line :
       {"# hidden cause: wear (change = -0.4, cycles = 300)\n",
        "# hidden cause: seized_contact[M-1-P-2-M,T1-T2]\n", "# TR1 is M-1-T-2-F\n",
        "# noise: standard deviation 0.02 of the tension, and 0.05 N\n",
        "# seed: 7\n# command: reeve simulate --routings TR1"}) {
    EXPECT_TRUE(has(head, line)) << line << head;
  }
}

TEST(SimulationCsv, SaysIfNothingIsHiddenAndIfValuesWereClipped) {
  const std::string quiet = simulation_csv(report_of(plan_of({"M-1-P-2-M"}), {}, {0, 0}));
  EXPECT_TRUE(has(quiet, "\n# hidden cause: none, "));
  EXPECT_FALSE(has(quiet, "\n# clipped: "));
  const SimulationReport loud = report_of(plan_of({"M-1-P-2-M"}), {}, {0, 5});
  EXPECT_TRUE(has(simulation_csv(loud),
                  "\n# clipped: " + std::to_string(loud.simulation.clipped) + " of 960 values"));
}

TEST(SimulationSummary, IsOneLine) {
  const SimulationReport report =
      report_of(plan_of({"M-1-P-2-M"}), {{"sensor_gain[T3]", {{"gain", "1.1"}}}});
  EXPECT_EQ(simulation_summary(report, "s.csv"),
            "s.csv: 240 simulated readings in 12 runs of 1 routing, with sensor_gain[T3] (gain = "
            "1.1)\n");
}

}  // namespace
}  // namespace reeve::testing
