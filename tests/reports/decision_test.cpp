// The words and tables of a decision, on trade-offs made by hand.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "reports/document/document.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

Design design(const std::string& word, double sheaths, double uniformity, double cost) {
  Design made{word, {}};
  const auto set = [&](Objective objective, double number) {
    made.values[static_cast<std::size_t>(objective)] = number;
  };
  set(Objective::sheaths, sheaths);
  set(Objective::uniformity_mean, uniformity);
  set(Objective::cost, cost);
  return made;
}

ListedDesign listed(const Design& design, const std::string& name, std::size_t rank) {
  ListedDesign entry;
  entry.ranked = {design, 1, rank};
  entry.name = name;
  return entry;
}

ListedTradeoff three_steps(Objective by = Objective::sheaths) {
  const std::vector<Design> designs{design("A", 1, 0.5, 10), design("B", 2, 0.792, 12.5),
                                    design("C", 4, 0.8, 30)};
  ListedTradeoff tradeoff;
  tradeoff.tradeoff =
      search::tradeoff(designs, designs[2], Order{Objective::uniformity_mean}, {by, 0.02});
  tradeoff.steps = {listed(designs[0], "", 0), listed(designs[1], "Two", 7),
                    listed(designs[2], "", 1)};
  tradeoff.affordable = tradeoff.steps[1];
  return tradeoff;
}

std::string lines_text(const std::vector<DocumentLine>& lines) {
  return text(Document{{{"", std::nullopt, lines}}});
}

TEST(AnswerLines, NameTheFirstTheAffordableAndTheKnee) {
  const ListedTradeoff tradeoff = three_steps();
  ListedDesign first = tradeoff.steps[2];
  first.routing = parse_routing("M-1-F");
  first.equivalent = {"D", "E"};
  EXPECT_EQ(lines_text(answer_lines({first}, tradeoff)),
            "Best: C: 4 sheaths, uniformity 0.800 (2 equivalent variants)\n"
            "It never jams unless all fingers are held\n"
            "Fewest sheaths within 2 % of it: Two (B): 2 sheaths, uniformity 0.792 (-1.0 %)\n"
            "Knee of the trade-off: Two (B), 2 sheaths\n");
}

TEST(AnswerLines, SayWhereTheFirstJamsAndWhatNeverJammingCosts) {
  ListedTradeoff tradeoff = three_steps();
  ListedDesign first = tradeoff.steps[2];
  first.routing = parse_routing("M-1-F+M-2-F");
  first.smallest_jams = {hold({1}), hold({2})};
  value(first.ranked.design.values, Objective::jams_all) = 2;
  EXPECT_TRUE(testing::has(lines_text(answer_lines({first}, tradeoff)),
                           "\nIt jams when finger 1 is held, or finger 2 is held (2 of 3 grasps); "
                           "every listed design jams in some grasp\n"));
  tradeoff.never_jams = tradeoff.steps[1];
  EXPECT_TRUE(testing::has(lines_text(answer_lines({first}, tradeoff)),
                           "(2 of 3 grasps); best design that never jams: Two (B): 2 sheaths, "
                           "uniformity 0.792 (-1.0 %)\n"));
}

// The two lines replace the line on the fewest sheaths, which is one of the two designs.
TEST(AnswerLines, NameTheBestWithAndWithoutFloatingPulleysAndWhatTheWearerCarries) {
  ListedTradeoff tradeoff = three_steps();
  ListedDesign without = tradeoff.steps[0];
  without.routing = parse_routing("1-P-2-P-1");
  without.smallest_jams = {hold({1, 2})};
  ListedDesign with = tradeoff.steps[1];
  with.routing = parse_routing("M-Y1+1x-Y1-2x");
  tradeoff.tradeoff.choice = {without.ranked.design, with.ranked.design};
  tradeoff.choice = {without, with};
  ListedDesign first = tradeoff.steps[2];
  first.routing = parse_routing("M-1-F");
  const std::string expected =
      "It never jams unless all fingers are held\n"
      "Without floating blocks, best: A: 1 sheath, uniformity 0.500 (-37.5 %), jams in some "
      "grasps; at the hand no moving part, 4 strands\n"
      "With floating blocks, fewest sheaths within 2 % of the best: Two (B): 2 sheaths, "
      "uniformity 0.792 (-1.0 %); at the hand 1 moving part, 2 strands";
  EXPECT_TRUE(testing::has(lines_text(answer_lines({first}, tradeoff)), expected + "\nKnee"));
  tradeoff.with_bars = listed(design("M-W1+1x-W1-2x", 2, 0.8, 10), "Bars", 0);
  EXPECT_TRUE(testing::has(lines_text(answer_lines({first}, tradeoff)),
                           expected + "; with rigid bars in place of its pulleys it is Bars "
                                      "(M-W1+1x-W1-2x): 2 sheaths, uniformity 0.800\nKnee"));
}

TEST(AnswerLines, GiveNoNumberOfWhatIsInfinite) {
  std::vector<Design> designs{design("A", 1, 0.5, 10), design("B", 2, 0.8, 10)};
  for (Design& made : designs) {
    made.values[static_cast<std::size_t>(Objective::closure)] = 1;
    made.values[static_cast<std::size_t>(Objective::motor_force)] =
        made.word == "A" ? std::numeric_limits<double>::infinity() : 40;
  }
  ListedTradeoff tradeoff;
  tradeoff.tradeoff =
      search::tradeoff(designs, designs[1], Order{Objective::motor_force}, {Objective::sheaths, 1});
  tradeoff.steps = {listed(designs[0], "", 2), listed(designs[1], "", 1)};
  tradeoff.tradeoff.affordable = designs[0];
  tradeoff.affordable = tradeoff.steps[0];
  const std::string lines = lines_text(answer_lines({tradeoff.steps[1]}, tradeoff));
  EXPECT_TRUE(testing::has(lines, "A: 1 sheath, nominal motor infinite\n"));
}

TEST(AnswerLines, SayTheCostInItsUnit) {
  ListedTradeoff tradeoff = three_steps(Objective::cost);
  tradeoff.cost_unit = "EUR";
  const std::string said = lines_text(answer_lines({tradeoff.steps[2]}, tradeoff));
  EXPECT_TRUE(testing::has(said, "Best: C: cost 30.00 EUR, uniformity"));
  EXPECT_TRUE(testing::has(said, "Least cost within 2 % of it: Two (B): cost 12.50 EUR, "));
}

ListedTradeoff thousandth(ListedTradeoff tradeoff) {
  const auto scale = [](ObjectiveValues& values) {
    values[static_cast<std::size_t>(Objective::cost)] /= 1000;
  };
  for (TradeoffStep& step : tradeoff.tradeoff.steps) {
    step.at_most /= 1000;
    scale(step.design.values);
  }
  for (ListedDesign& step : tradeoff.steps) scale(step.ranked.design.values);
  scale(tradeoff.tradeoff.first.values);
  scale(tradeoff.tradeoff.affordable->values);
  tradeoff.cost_unit = "kg";
  return tradeoff;
}

TEST(AnswerLines, SayACostOfGramsInKilograms) {
  const ListedTradeoff tradeoff = thousandth(three_steps(Objective::cost));
  const std::string said = lines_text(answer_lines({tradeoff.steps[2]}, tradeoff));
  EXPECT_TRUE(testing::has(said, "Best: C: cost 0.03 kg, "));
  EXPECT_TRUE(testing::has(said, "Two (B): cost 0.0125 kg, "));
  EXPECT_TRUE(testing::has(said, "Two (B), cost 0.0125 kg\n"));
}

TEST(TradeoffTable, HasACostOfGramsInKilograms) {
  const std::string table =
      text(Document{{tradeoff_section(thousandth(three_steps(Objective::cost)))}});
  for (const char* cost : {"\n   0.0100  ", "\n   0.0125  ", "\n   0.0300  "}) {
    EXPECT_TRUE(testing::has(table, cost));
  }
}

TEST(AnswerLines, SayThatNothingIsCheaperWithinTheLoss) {
  ListedTradeoff tradeoff = three_steps();
  tradeoff.affordable.reset();
  tradeoff.tradeoff.affordable.reset();
  EXPECT_TRUE(testing::has(lines_text(answer_lines({tradeoff.steps[2]}, tradeoff)),
                           "No design within 2 % of it has fewer sheaths\n"));
  EXPECT_TRUE(answer_lines({}, tradeoff).empty());
}

TEST(AnswerLines, HaveUnits) {
  ListedTradeoff tradeoff = three_steps();
  tradeoff.tradeoff.objectives = {Objective::motor_force, Objective::travel, Objective::cost};
  tradeoff.cost_unit = "EUR";
  ObjectiveValues& values = tradeoff.tradeoff.first.values;
  values[static_cast<std::size_t>(Objective::motor_force)] = 65.8;
  values[static_cast<std::size_t>(Objective::travel)] = 2;
  values[static_cast<std::size_t>(Objective::cost)] = 44.4;
  tradeoff.steps[2].ranked.design.values = values;
  EXPECT_TRUE(testing::has(lines_text(answer_lines({tradeoff.steps[2]}, tradeoff)),
                           "motor 65.8 N, travel 2.00, cost 44.40 EUR\n"));
  EXPECT_TRUE(testing::has(text(Document{{tradeoff_section(tradeoff)}}), "  nominal motor (N)  "));
}

TEST(AlikeLines, NameAFewAndCountTheRest) {
  ListedDesign design = three_steps().steps[2];
  design.equivalent = {"D", "E", "F", "G", "H", "I"};
  EXPECT_EQ(lines_text(equivalent_lines({design})),
            "Equivalent variants of rank 1, with other bearings: D, E, F, G and 2 more\n");
}

TEST(TradeoffTable, HasGainsOverTheStepBeforeAndMarks) {
  EXPECT_EQ(text(Document{{tradeoff_section(three_steps())}}),
            "Best design for each number of sheaths\n"
            "sheaths  name  routing  uniformity     gain     kept\n"
            "      1  -     A             0.500            62.5 %\n"
            "      2  Two   B             0.792  +58.4 %   99.0 %  knee, within 2 %\n"
            "      4  -     C             0.800   +1.0 %  100.0 %  best\n");
}

TEST(TradeoffTable, HasGainZeroWhereNothingChanges) {
  ListedTradeoff tradeoff = three_steps();
  tradeoff.tradeoff.objectives = {Objective::travel};
  for (TradeoffStep& step : tradeoff.tradeoff.steps) {
    step.design.values[static_cast<std::size_t>(Objective::travel)] = 2;
  }
  const std::string table = text(Document{{tradeoff_section(tradeoff)}});
  EXPECT_TRUE(testing::has(table, " +0.0 %"));
  EXPECT_FALSE(testing::has(table, "-0.0"));
  EXPECT_EQ(tradeoff_json(tradeoff)["steps"][1]["gains"].dump(), R"({"travel":0.0})");
  EXPECT_FALSE(testing::has(tradeoff_csv(tradeoff), "-0"));
}

TEST(TradeoffTable, IsLeftOutWithOneStep) {
  ListedTradeoff tradeoff = three_steps();
  tradeoff.tradeoff.steps.resize(1);
  tradeoff.steps.resize(1);
  EXPECT_FALSE(tradeoff_section(tradeoff).table);
}

TEST(TradeoffCsv, HasARowForEachStepWithGainsAndLosses) {
  const std::string csv = tradeoff_csv(three_steps(), "partial: half");
  EXPECT_TRUE(
      csv.starts_with("# partial: half\ntradeoff,at_most,routing,name,rank,kept,marks,"
                      "uniformity_mean,"));
  EXPECT_TRUE(testing::has(csv, ",efficiency_p5,gain_uniformity_mean,loss_uniformity_mean\n"));
  EXPECT_TRUE(testing::has(csv, "\nsheaths,1,A,,,0.625,,0.5,"));
  EXPECT_TRUE(testing::has(csv, ",10,0,0,,0.375\n"));
  EXPECT_TRUE(testing::has(csv, "\nsheaths,2,B,Two,7,0.99,\"knee, within 2 %\",0.792,"));
}

TEST(TradeoffJson, NamesTheAffordableDesignAndTheKnee) {
  const Json json = tradeoff_json(three_steps());
  EXPECT_EQ(json["by"], "sheaths");
  EXPECT_EQ(json["affordable"]["routing"], "B");
  EXPECT_EQ(json["affordable"]["rank"], 7);
  EXPECT_NEAR(json["affordable"]["losses"]["uniformity_mean"], 0.01, 1e-12);
  EXPECT_EQ(json["knee"], 2);
  EXPECT_TRUE(json["steps"][0]["rank"].is_null());
  EXPECT_NEAR(json["steps"][1]["gains"]["uniformity_mean"], 0.292, 1e-12);
}

std::string infeasible_text(const std::vector<std::string>& constraints,
                            const std::vector<ConstraintReach>& reaches) {
  ExploreOptions options;
  for (const std::string& text : constraints) options.constraints.push_back(parse_constraint(text));
  ExploreResult result;
  result.infeasible = reaches;
  return lines_text(infeasible_lines(options, result));
}

TEST(InfeasibleLines, SayTheLeastOrTheGreatest) {
  EXPECT_EQ(infeasible_text({"sheaths<=0"}, {{false, {1, std::nullopt}, {1, std::nullopt}}}),
            "No design meets sheaths<=0: the least is 1\n");
  EXPECT_EQ(infeasible_text({"uniformity>=1"}, {{false, {std::nullopt, 0.9}, {std::nullopt, 0.9}}}),
            "No design meets uniformity>=1: the greatest is 0.9\n");
  EXPECT_EQ(infeasible_text({"travel==3"}, {{false, {4, 2}, {4, 2}}}),
            "No design meets travel==3: the nearest are 2 and 4 mm/mm\n");
  EXPECT_EQ(infeasible_text({"sheaths==9"}, {{false, {std::nullopt, 4}, {std::nullopt, 4}}}),
            "No design meets sheaths==9: the nearest is 4\n");
}

// No motor force is enough for a finger that gets no pull.
TEST(InfeasibleLines, GiveNoNumberOfWhatIsInfinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Nearest no_end{infinite, std::nullopt};
  EXPECT_EQ(infeasible_text({"motor_force<=20"}, {{false, no_end, no_end}}),
            "No design meets motor_force<=20: in all of them it is infinite\n");
  EXPECT_EQ(infeasible_text({"stroke==60"}, {{false, {infinite, 58.76543}, {infinite, 58.76543}}}),
            "No design meets stroke==60: the nearest is 58.76 mm\n");
  EXPECT_EQ(infeasible_text({"motor_force<=20", "sheaths<=1"},
                            {{true, no_end, no_end}, {true, {2, std::nullopt}, {2, std::nullopt}}}),
            "Each of these constraints is met by some design, but both by none\n"
            "Of the designs that meet all but motor_force<=20, in all of them it is infinite\n"
            "Of the designs that meet all but sheaths<=1, the least is 2\n");
}

TEST(InfeasibleLines, RoundAwayFromTheBoundAndHaveAUnit) {
  const auto one = [](const char* constraint, const Nearest& nearest) {
    const std::string text = infeasible_text({constraint}, {{false, nearest, nearest}});
    return text.substr(text.find(": ") + 2);
  };
  EXPECT_EQ(one("motor_force<=20", {37.65413219, std::nullopt}), "the least is 37.66 N\n");
  EXPECT_EQ(one("uniformity>=0.994", {std::nullopt, 0.9906194961}), "the greatest is 0.9906\n");
  EXPECT_EQ(one("uniformity>=0.994", {std::nullopt, 0.9906994961}), "the greatest is 0.9906\n");
  EXPECT_EQ(one("stroke==60", {61.23456, 58.76543}), "the nearest are 58.76 and 61.24 mm\n");
  EXPECT_EQ(one("motor_force<=20", {12345.6, std::nullopt}), "the least is 12346 N\n");
}

TEST(InfeasibleLines, SayWhatGivesWayWhereOnlyAllTogetherAreTooMuch) {
  EXPECT_EQ(infeasible_text({"sheaths<=1", "uniformity>=0.99"},
                            {{true, {2, std::nullopt}, {3, std::nullopt}},
                             {true, {std::nullopt, 0.98}, {std::nullopt, 0.97}}}),
            "Each of these constraints is met by some design, but both by none\n"
            "Of the designs that meet all but sheaths<=1, the least is 3\n"
            "Of the designs that meet all but uniformity>=0.99, the greatest is 0.97\n");
}

}  // namespace
}  // namespace reeve
