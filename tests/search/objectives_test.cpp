#include "search/evaluate/objectives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "tests/support/has.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

const std::string all_names =
    "uniformity_mean, uniformity_worst, efficiency_mean, efficiency_worst, force_transmission, "
    "jams, jams_all, sheaths, pulleys, knots, travel, round_trip_efficiency, adaptability, torsional_balance, "
    "reliability, authors_efficiency, transmission, score, blocks, finger_uniformity_mean, "
    "finger_uniformity_worst, parts, cost, uniformity_p5, efficiency_p5, motor_force, fingertip_force_mean, "
    "fingertip_force_worst, stroke, closure, motor_power, or for means uniformity, efficiency, "
    "finger_uniformity, fingertip_force";

std::string objectives_message(const std::string& text) {
  return testing::input_error([&] { parse_objectives(text); });
}

std::string constraint_message(const std::string& text) {
  return testing::input_error([&] { parse_constraint(text); });
}

std::string unknown(const std::string& option, const std::string& name) {
  return option + ": unknown objective '" + name + "'; expected one of " + all_names;
}

// Two grasps, the second three times as important and jammed.
DesignOutcome hand_made() {
  DesignOutcome outcome;
  outcome.grasps = {{1, false, {0.5, 0.2, 1.0}, 0.4, {8, 6, 4, 2, 1}},
                    {3, true, {0.1, 0.6, 2.0}, 0.8, {4, 2, 0, 6, 5}}};
  outcome.parts = {5, 3, 1};
  outcome.travel = 1.5;
  return outcome;
}

ObjectiveValues computed(const DesignOutcome& outcome) {
  ObjectiveValues values{};
  compute_objectives(outcome, values);
  return values;
}

ObjectiveValues with(Objective objective, double number) {
  ObjectiveValues values{};
  value(values, objective) = number;
  return values;
}

TEST(ObjectiveTable, EveryObjectiveIsFoundByItsValueAndByItsName) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < objective_count; ++i) {
    const ObjectiveRow& entry = objective_table()[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.objective), i);
    EXPECT_STREQ(row(entry.objective).name, entry.name);
    EXPECT_EQ(parse_objective(entry.name, "objectives"), entry.objective);
    EXPECT_STRNE(entry.unit, "");
    EXPECT_STRNE(entry.meaning, "");
    names.insert(entry.name);
  }
  EXPECT_EQ(names.size(), objective_count);
}

TEST(ObjectiveTable, SaysWhichDirectionIsBetter) {
  const std::set<Objective> lower{
      Objective::jams_all, Objective::jams,   Objective::sheaths,     Objective::pulleys,
      Objective::knots,    Objective::travel, Objective::blocks,      Objective::parts,
      Objective::cost,     Objective::stroke, Objective::motor_force, Objective::motor_power};
  for (const ObjectiveRow& entry : objective_table()) {
    EXPECT_EQ(entry.better == Better::lower, lower.count(entry.objective) == 1) << entry.name;
  }
}

TEST(Objectives, MeansAreWeightedAndTheWorstGraspIsNot) {
  const ObjectiveValues values = computed(hand_made());
  EXPECT_EQ(value(values, Objective::uniformity_mean), 0.2);  // (0.5 + 3 * 0.1) / 4
  EXPECT_EQ(value(values, Objective::uniformity_worst), 0.1);
  EXPECT_EQ(value(values, Objective::efficiency_mean), 0.5);  // (0.2 + 3 * 0.6) / 4
  EXPECT_EQ(value(values, Objective::efficiency_worst), 0.2);
  EXPECT_EQ(value(values, Objective::force_transmission), 1.75);    // (1 + 3 * 2) / 4
  EXPECT_EQ(value(values, Objective::round_trip_efficiency), 0.7);  // (0.4 + 3 * 0.8) / 4
}

TEST(Objectives, JamsAreCountedInGraspsWhateverTheirWeight) {
  DesignOutcome outcome = hand_made();
  EXPECT_EQ(value(computed(outcome), Objective::jams), 1);
  outcome.grasps[0].jams = true;
  EXPECT_EQ(value(computed(outcome), Objective::jams), 2);
  outcome.grasps[0].jams = outcome.grasps[1].jams = false;
  EXPECT_EQ(value(computed(outcome), Objective::jams), 0);
}

TEST(Objectives, PartsAndTravelAreTakenAsTheyAre) {
  const ObjectiveValues values = computed(hand_made());
  EXPECT_EQ(value(values, Objective::sheaths), 5);
  EXPECT_EQ(value(values, Objective::pulleys), 3);
  EXPECT_EQ(value(values, Objective::knots), 1);
  EXPECT_EQ(value(values, Objective::travel), 1.5);
  EXPECT_EQ(value(values, Objective::parts), 9);
}

TEST(Objectives, TheCostIsInfiniteWhereNobodySaysWhatPartsCost) {
  DesignOutcome outcome = hand_made();
  EXPECT_EQ(value(computed(outcome), Objective::cost), std::numeric_limits<double>::infinity());
  outcome.cost = 12.5;
  EXPECT_EQ(value(computed(outcome), Objective::cost), 12.5);
}

TEST(Objectives, AreRoundedToTenDigitsBehindThePoint) {
  const auto travel = [](double exact) {
    DesignOutcome outcome = hand_made();
    outcome.travel = exact;
    return value(computed(outcome), Objective::travel);
  };
  EXPECT_EQ(travel(4.0 / 3.0), 1.3333333333);
  EXPECT_EQ(travel(2.0 / 3.0), 0.6666666667);
  EXPECT_NE(0.1 + 0.2, 0.3);
  EXPECT_EQ(travel(0.1 + 0.2), 0.3);
  EXPECT_EQ(travel(0.3 + 4e-11), 0.3);
  EXPECT_EQ(travel(0.3 + 6e-11), 0.3000000001);
  EXPECT_EQ(travel(0.3 - 4e-11), 0.3);
  EXPECT_EQ(travel(0.3 - 6e-11), 0.2999999999);
  EXPECT_FALSE(std::signbit(travel(-0.0)));
  EXPECT_FALSE(std::signbit(travel(-4e-11)));
}

TEST(ParseObjectives, KeepsTheOrderOfTheList) {
  EXPECT_EQ(
      parse_objectives("sheaths,jams,uniformity_worst"),
      (std::vector<Objective>{Objective::sheaths, Objective::jams, Objective::uniformity_worst}));
  EXPECT_EQ(parse_objectives("travel"), std::vector<Objective>{Objective::travel});
}

TEST(ParseObjectives, UniformityAndEfficiencyAreShortForTheirMeans) {
  EXPECT_EQ(parse_objectives("uniformity,efficiency"),
            (std::vector<Objective>{Objective::uniformity_mean, Objective::efficiency_mean}));
}

TEST(ParseObjectivesError, NamesAnUnknownObjectiveAndListsAll) {
  EXPECT_EQ(objectives_message("uniformity,speed"),
            unknown("objectives 'uniformity,speed'", "speed"));
  // A near name is suggested behind the list.
  for (const std::string name : {"Sheaths", "she aths", "sheath", "mean", "uniformity_", "-"}) {
    const std::string message = objectives_message(name);
    const std::string list = unknown("objectives '" + name + "'", name);
    EXPECT_EQ(message.substr(0, list.size()), list);
  }
  EXPECT_TRUE(testing::has(objectives_message("Sheaths"), "; did you mean sheaths?"));
}

TEST(ParseObjectivesError, AnEmptyListOrItemIsUnknown) {
  for (const std::string text : {"", ",", "sheaths,", ",sheaths", "sheaths,,jams"}) {
    EXPECT_EQ(objectives_message(text), unknown("objectives '" + text + "'", ""));
  }
}

TEST(ParseObjectivesError, NamesAnObjectiveThatIsNamedTwice) {
  EXPECT_EQ(objectives_message("jams,sheaths,jams"),
            "objectives 'jams,sheaths,jams': 'jams' is named twice");
  EXPECT_EQ(objectives_message("uniformity,uniformity_mean"),
            "objectives 'uniformity,uniformity_mean': 'uniformity_mean' is named twice");
}

TEST(Constraint, AdmitsBySideOfItsBound) {
  const auto admits = [](const std::string& text, double number) {
    const Constraint constraint = parse_constraint(text);
    return constraint.admits(with(Objective::travel, number));
  };
  const auto sides = [&](const std::string& comparison) {
    std::string text;
    for (const double number : {1.0, 2.0, 3.0}) {
      text += admits("travel" + comparison + "2", number) ? 'y' : 'n';
    }
    return text;
  };
  EXPECT_EQ(sides("<="), "yyn");
  EXPECT_EQ(sides("<"), "ynn");
  EXPECT_EQ(sides(">="), "nyy");
  EXPECT_EQ(sides(">"), "nny");
  EXPECT_EQ(sides("=="), "nyn");
}

TEST(Constraint, LooksAtItsOwnObjectiveOnly) {
  const Constraint constraint = parse_constraint("sheaths<=2");
  EXPECT_TRUE(constraint.admits(with(Objective::pulleys, 9)));
  EXPECT_FALSE(constraint.admits(with(Objective::sheaths, 3)));
}

// Values lie on the grid (4 / 3 is 1.3333333333), bounds come with all the digits of a double.
TEST(Constraint, HasItsBoundOnTheGridOfTheValues) {
  DesignOutcome outcome = hand_made();
  for (const char* comparison : {"<=", ">=", "=="}) {
    for (const char* bound : {"1.3333333333333333", "1.33333333326", "1.33333333334"}) {
      outcome.travel = 4.0 / 3.0;
      EXPECT_TRUE(
          parse_constraint(std::string("travel") + comparison + bound).admits(computed(outcome)))
          << comparison << bound;
    }
  }
  EXPECT_FALSE(parse_constraint("travel==1.3333333334").admits(computed(outcome)));
}

TEST(ParseConstraint, ReadsObjectiveComparisonAndNumber) {
  const Constraint constraint = parse_constraint("efficiency>=0.25");
  EXPECT_EQ(constraint.objective, Objective::efficiency_mean);
  EXPECT_EQ(constraint.comparison, ">=");
  EXPECT_EQ(constraint.bound, 0.25);
  EXPECT_EQ(constraint.text, "efficiency>=0.25");
  EXPECT_EQ(parse_constraint("jams==0").bound, 0);
  EXPECT_EQ(parse_constraint("travel<1e1").bound, 10);
  EXPECT_EQ(parse_constraint("travel>-1.5").bound, -1.5);
}

TEST(ParseConstraint, IgnoresSpaces) {
  const Constraint constraint = parse_constraint(" sheaths <= 2 ");
  EXPECT_EQ(constraint.objective, Objective::sheaths);
  EXPECT_EQ(constraint.bound, 2);
  EXPECT_EQ(constraint.text, "sheaths<=2");
}

TEST(ParseConstraintError, SaysWhatAConstraintIsMadeOf) {
  for (const std::string text :
       {"", " ", "sheaths", "sheaths<=", "sheaths2", "sheaths<=two", "sheaths<=2x", "sheaths<=0x2",
        "sheaths<=2<=3", "1<=sheaths<=2", "sheaths<=2,5", "sheaths<=+2", "<=", "<", "2"}) {
    EXPECT_EQ(constraint_message(text),
              "constraint '" + text +
                  "': expected an objective, one of <= >= < > ==, and a number, such as "
                  "sheaths<=2");
  }
}

TEST(ParseConstraintError, KnowsFiveComparisons) {
  for (const std::string comparison : {"=>", "=<", "=", "===", "<>", "><", "<<", "!=", "<=="}) {
    EXPECT_NE(
        constraint_message("sheaths" + comparison + "2").find("expected an objective, one of"),
        std::string::npos)
        << comparison;
  }
}

TEST(ParseConstraintError, ABoundIsAFiniteNumber) {
  for (const std::string bound : {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999"}) {
    EXPECT_NE(constraint_message("sheaths<=" + bound).find("expected an objective, one of"),
              std::string::npos)
        << bound;
  }
}

TEST(ParseConstraintError, NamesAnUnknownObjectiveAndListsAll) {
  EXPECT_EQ(constraint_message("speed<=2"), unknown("constraint 'speed<=2'", "speed"));
  EXPECT_EQ(constraint_message("<=2"), unknown("constraint '<=2'", ""));
  EXPECT_EQ(constraint_message("speed <= 2"), unknown("constraint 'speed <= 2'", "speed"));
}

TEST(ObjectivesFault, HasTheItemInParts) {
  EXPECT_EQ(testing::input_fault([] { parse_objectives("jams,luck"); }),
            "objectives 'jams,luck' | unknown objective | luck | one of " + all_names);
  EXPECT_EQ(testing::input_fault([] { parse_constraint("jams"); }),
            "- | constraint | jams | an objective, one of <= >= < > ==, and a number, such as "
            "sheaths<=2");
}

}  // namespace
}  // namespace reeve
