#include "search/evaluate/evaluation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

// Of many that are evaluated one may be such.
TEST(DesignEvaluator, NamesTheRoutingThatHasNoTensions) {
  DesignEvaluator evaluator(Hardware{}, parse_grasps("1/none", 1));
  const std::string said =
      testing::out_of_range([&] { evaluator.evaluate(parse_routing("F-1-F")); });
  EXPECT_TRUE(said.starts_with("routing 'F-1-F': held 1: the motor tension cannot")) << said;
}

struct Printed {
  double uniformity;
  double efficiency;
};

struct Published {
  const char* word;
  Printed first_held;
  Printed second_held;
  Printed both_close;
  Printed mean;
  double travel;  // 2 fingers / motor-side segments, derived by hand
  int sheaths;
  int pulleys;
  int knots;
};

// TR1 to TR7. The travel: every motor-side segment gives D, every finger takes 2 dl, so that
// D / dl = 2 * 2 / motor-side segments for two fingers.
const std::vector<Published>& published() {
  static const std::vector<Published> table{
      {"M-1-T-2-F", {0.183, 0.082}, {0.183, 0.253}, {0.183, 0.167}, {0.183, 0.167}, 4, 1, 0, 0},
      {"M-1-T-2-M", {0.323, 0.183}, {0.323, 0.183}, {0.568, 0.253}, {0.405, 0.207}, 2, 2, 0, 0},
      {"F-1-P-2-F", {0.566, 0.253}, {0.566, 0.253}, {0.568, 0.253}, {0.567, 0.253}, 2, 2, 1, 0},
      {"M-1-P-2-F",
       {0.034, 0.040},
       {0.566, 0.295},
       {0.322, 0.279},
       {0.307, 0.205},
       4.0 / 3,
       3,
       1,
       0},
      {"M-1-P-2-M", {0.034, 0.052}, {0.034, 0.052}, {1.000, 0.323}, {0.356, 0.142}, 1, 4, 1, 0},
      {"1-T-2-P-1", {0.566, 0.253}, {0.566, 0.253}, {0.568, 0.253}, {0.567, 0.253}, 2, 2, 1, 1},
      {"1-P-2-P-1", {0.997, 0.322}, {0.997, 0.322}, {1.000, 0.323}, {0.998, 0.322}, 1, 4, 2, 1}};
  return table;
}

// Half a unit of the last printed digit.
constexpr double printed_digits = 0.0005;

void expect_printed(const GraspOutcome& outcome, const Printed& printed) {
  EXPECT_NEAR(outcome.pull.uniformity, printed.uniformity, printed_digits);
  EXPECT_NEAR(outcome.pull.efficiency, printed.efficiency, printed_digits);
}

ObjectiveValues evaluate(const std::string& word, const GraspSet& grasps = single_grasps(2)) {
  return DesignEvaluator(Hardware{}, grasps).evaluate(parse_routing(word));
}

std::vector<Routing> actuated(int fingers) {
  RoutingGenerator generator({full_parts(), fingers, FingerIdentity::identical, false});
  std::vector<Routing> routings;
  for (Routing routing; generator.next(routing);) {
    if (is_actuated(routing)) routings.push_back(routing);
  }
  return routings;
}

TEST(Evaluation, ReproducesTheReferenceTableInEveryGrasp) {
  DesignEvaluator evaluator(Hardware{}, single_grasps(2));
  for (const Published& row : published()) {
    SCOPED_TRACE(row.word);
    const DesignOutcome& outcome = evaluator.outcome(parse_routing(row.word));
    ASSERT_EQ(outcome.grasps.size(), 3U);
    expect_printed(outcome.grasps[0], row.both_close);
    expect_printed(outcome.grasps[1], row.first_held);
    expect_printed(outcome.grasps[2], row.second_held);
  }
}

TEST(Evaluation, ReproducesTheMeansOfTheReferenceTable) {
  for (const Published& row : published()) {
    SCOPED_TRACE(row.word);
    const ObjectiveValues values = evaluate(row.word);
    EXPECT_NEAR(value(values, Objective::uniformity_mean), row.mean.uniformity, printed_digits);
    EXPECT_NEAR(value(values, Objective::efficiency_mean), row.mean.efficiency, printed_digits);
  }
}

TEST(Evaluation, TheWorstGraspIsTheLeastOfTheTable) {
  for (const Published& row : published()) {
    SCOPED_TRACE(row.word);
    const ObjectiveValues values = evaluate(row.word);
    const auto least = [](double a, double b, double c) { return std::min(a, std::min(b, c)); };
    EXPECT_NEAR(
        value(values, Objective::uniformity_worst),
        least(row.first_held.uniformity, row.second_held.uniformity, row.both_close.uniformity),
        printed_digits);
    EXPECT_NEAR(
        value(values, Objective::efficiency_worst),
        least(row.first_held.efficiency, row.second_held.efficiency, row.both_close.efficiency),
        printed_digits);
  }
}

TEST(Evaluation, CountsThePartsOfThePublishedRoutings) {
  for (const Published& row : published()) {
    SCOPED_TRACE(row.word);
    const ObjectiveValues values = evaluate(row.word);
    EXPECT_EQ(value(values, Objective::sheaths), row.sheaths);
    EXPECT_EQ(value(values, Objective::pulleys), row.pulleys);
    EXPECT_EQ(value(values, Objective::knots), row.knots);
    EXPECT_EQ(value(values, Objective::jams), 0);
  }
}

TEST(Evaluation, TravelIsWhatTheCarriageMovesForEachMillimetreOfClosing) {
  for (const Published& row : published()) {
    EXPECT_NEAR(value(evaluate(row.word), Objective::travel), row.travel, 1e-10) << row.word;
  }
}

// D / mean dl with all fingers closing, from the kinematics; several tendons share D.
// A strand gives up all that the block moves; a load on a luff tackle a third of the rope.
TEST(Evaluation, TravelWithBlocksFollowsFromTheirMotion) {
  EXPECT_NEAR(value(evaluate("M-Y1+1x-Y1-2x"), Objective::travel), 1, 1e-10);
  EXPECT_NEAR(value(evaluate("M-Y1-B-Y1k+Y1-1x"), Objective::travel), 3, 1e-10);
  EXPECT_NEAR(value(evaluate("1x-P-2x"), Objective::travel), 1, 1e-10);
  EXPECT_EQ(value(evaluate("M-Y1+F-Y1-F"), Objective::travel), 0);
  EXPECT_TRUE(std::isinf(value(evaluate("M-Y1+F-Y1-F+M-1-F"), Objective::travel)));
  // A tendon that is tied at both ends lets the carriage not move either.
  EXPECT_TRUE(std::isinf(value(evaluate("M-F+M-1-F+M-2-M"), Objective::travel)));
  EXPECT_EQ(value(evaluate("M-F"), Objective::travel), 0);
  EXPECT_EQ(value(evaluate("M-Y1+1x-Y1-2x"), Objective::blocks), 1);
}

TEST(Evaluation, TravelAgreesWithTheKinematicsOfEveryRoutingOfThreeFingers) {
  DesignEvaluator evaluator(Hardware{}, single_grasps(3));
  for (const Routing& routing : actuated(3)) {
    const Network network = expand(routing);
    const TensionState state = tensions(network, mechanics(network, Hardware{}), Grasp{});
    double sum = 0;
    for (const double dl : state.closing) sum += dl;
    EXPECT_NEAR(evaluator.outcome(routing).travel, 3 / sum, 1e-12) << to_word(routing);
  }
}

TEST(Evaluation, TravelDoesNotDependOnTheGrasps) {
  EXPECT_EQ(value(evaluate("M-1-P-2-F", paper_grasps()), Objective::travel),
            value(evaluate("M-1-P-2-F"), Objective::travel));
}

// Two tendons, one for each finger: whichever finger is held blocks the carriage and takes the
// whole motor tension; with both closing, they share it.
TEST(Evaluation, ARoutingThatJamsDoesNoWorkInThatGrasp) {
  const double sheath = std::exp(-0.18 * 2 * std::numbers::pi);
  const double tip = std::exp(-0.18 * std::numbers::pi);
  DesignEvaluator evaluator(Hardware{}, single_grasps(2));
  const Routing routing = parse_routing("M-1-F+M-2-F");
  const DesignOutcome& outcome = evaluator.outcome(routing);
  EXPECT_FALSE(outcome.grasps[0].jams);
  EXPECT_NEAR(outcome.grasps[0].pull.uniformity, tip, 1e-12);
  EXPECT_NEAR(outcome.grasps[0].pull.efficiency, sheath * (1 + tip) / 2, 1e-12);
  EXPECT_GT(outcome.grasps[0].round_trip_efficiency, 0);
  for (const std::size_t held : {1U, 2U}) {
    EXPECT_TRUE(outcome.grasps[held].jams);
    EXPECT_EQ(outcome.grasps[held].pull.uniformity, 0);
    EXPECT_EQ(outcome.grasps[held].pull.efficiency, 0);
    EXPECT_NEAR(outcome.grasps[held].pull.force_transmission, sheath * (1 + tip), 1e-12);
    EXPECT_EQ(outcome.grasps[held].round_trip_efficiency, 0);
  }
  const ObjectiveValues values = evaluator.evaluate(routing);
  EXPECT_EQ(value(values, Objective::jams), 2);
  EXPECT_NEAR(value(values, Objective::uniformity_mean), tip / 3, 1e-10);
  EXPECT_EQ(value(values, Objective::uniformity_worst), 0);
  EXPECT_EQ(value(values, Objective::efficiency_worst), 0);
  EXPECT_EQ(value(evaluate("M-1-F+M-2-F", paper_grasps()), Objective::jams), 1);
}

// One sheath and one tip: e^{-2 phi_s} both ways at the sheath, and the tip takes its share of the
// work from one of the two strands, whichever way the tendon runs.
TEST(Evaluation, ReturnFrictionIsTheProductOfBothEfficiencies) {
  const double sheath = std::exp(-0.18 * 2 * std::numbers::pi);
  const double tip = std::exp(-0.18 * std::numbers::pi);
  const double pull = sheath * (1 + tip) / 2;
  const double release = 2 * sheath / (1 + 1 / tip);
  EXPECT_NEAR(value(evaluate("M-1-F", single_grasps(0)), Objective::round_trip_efficiency),
              pull * release, 1e-10);
}

TEST(Evaluation, WithoutFrictionNothingIsLostOrUneven) {
  Hardware smooth;
  smooth.tube.mu = smooth.bearing.mu = smooth.sheath.mu = 0;
  DesignEvaluator evaluator(smooth, single_grasps(2));
  for (const Published& row : published()) {
    const ObjectiveValues values = evaluator.evaluate(parse_routing(row.word));
    EXPECT_EQ(value(values, Objective::uniformity_worst), 1) << row.word;
    EXPECT_EQ(value(values, Objective::efficiency_worst), 1) << row.word;
    EXPECT_EQ(value(values, Objective::round_trip_efficiency), 1) << row.word;
  }
}

TEST(Evaluation, WeightsOfTheGraspsCount) {
  const ObjectiveValues weighted = evaluate("M-1-P-2-F", parse_grasps("none:1/1:3", 2));
  const ObjectiveValues none = evaluate("M-1-P-2-F", parse_grasps("none", 2));
  const ObjectiveValues first = evaluate("M-1-P-2-F", parse_grasps("1", 2));
  for (const Objective objective :
       {Objective::uniformity_mean, Objective::efficiency_mean, Objective::force_transmission,
        Objective::round_trip_efficiency}) {
    EXPECT_NEAR(value(weighted, objective),
                (value(none, objective) + 3 * value(first, objective)) / 4, 2e-10);
  }
}

TEST(Evaluation, AReusedEvaluatorGivesTheSameBytesInAnyOrder) {
  const std::vector<Routing> routings = actuated(3);
  std::vector<ObjectiveValues> fresh;
  for (const Routing& routing : routings) {
    fresh.push_back(DesignEvaluator(Hardware{}, all_grasps(3)).evaluate(routing));
  }
  std::vector<std::size_t> order(2 * routings.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i % routings.size();
  DesignEvaluator reused(Hardware{}, all_grasps(3));
  std::mt19937_64 engine(1);
  for (int turn = 0; turn < 3; ++turn) {
    for (const std::size_t i : order) {
      EXPECT_EQ(reused.evaluate(routings[i]), fresh[i]) << to_word(routings[i]);
    }
    std::shuffle(order.begin(), order.end(), engine);
  }
}

TEST(Evaluation, AReusedEvaluatorMayGoFromManyFingersToFew) {
  DesignEvaluator reused(Hardware{}, parse_grasps("none/1", 2));
  const std::vector<std::string> words{"1-P-2-P-1", "1-P-2-P-3-P-4b-B-1+M-5-F", "M-1-F",
                                       "M-1-F+M-2-F+3-P-3", "M-1-T-2-F"};
  for (int turn = 0; turn < 2; ++turn) {
    for (const std::string& word : words) {
      EXPECT_EQ(reused.evaluate(parse_routing(word)), evaluate(word, parse_grasps("none/1", 2)))
          << word;
    }
  }
}

TEST(DesignEvaluator, WorksOutWhatObjectivesNeed) {
  const auto needs = [](Objective objective, const Score& score) {
    return scope_for({Objective::sheaths, objective}, score);
  };
  const Score of_release{{{Objective::round_trip_efficiency, 2}}};
  EXPECT_EQ(needs(Objective::uniformity_mean, authors_score()),
            (EvaluationScope{false, false, false, false, false}));
  EXPECT_EQ(needs(Objective::round_trip_efficiency, authors_score()),
            (EvaluationScope{true, false, false, false, false}));
  EXPECT_EQ(needs(Objective::reliability, of_release),
            (EvaluationScope{false, true, false, false, false}));
  EXPECT_EQ(needs(Objective::score, authors_score()),
            (EvaluationScope{false, true, false, false, false}));
  EXPECT_EQ(needs(Objective::score, of_release),
            (EvaluationScope{true, false, false, false, false}));
}

TEST(DesignEvaluator, LeavesOutWhatIsNotAskedFor) {
  DesignEvaluator evaluator(Hardware{}, single_grasps(2));
  for (const char* word : {"M-1-T-2-F", "1-P-2b-P-1", "M-1-F+M-2-F"}) {
    const Routing routing = parse_routing(word);
    ObjectiveValues full = evaluator.evaluate(routing);
    const ObjectiveValues plain = evaluator.evaluate(routing, {false, false});
    for (const ObjectiveRow& row : objective_table()) {
      const bool left_out =
          row.objective >= Objective::round_trip_efficiency && row.objective <= Objective::score;
      EXPECT_EQ(value(plain, row.objective), left_out ? 0 : value(full, row.objective)) << row.name;
    }
  }
}

TEST(DesignEvaluator, PullingAloneGivesAllButReturnFriction) {
  DesignEvaluator evaluator(Hardware{}, single_grasps(2));
  for (const char* word : {"M-1-T-2-F", "1-P-2b-P-1", "M-1-F+M-2-F"}) {
    const Routing routing = parse_routing(word);
    ObjectiveValues full = evaluator.evaluate(routing);
    const ObjectiveValues pulling = evaluator.evaluate(routing, {false, true});
    EXPECT_EQ(value(pulling, Objective::round_trip_efficiency), 0);
    value(full, Objective::round_trip_efficiency) = 0;
    EXPECT_EQ(full, pulling) << word;
  }
}

}  // namespace
}  // namespace reeve
