// What the page of a ranking says and draws, of reports made by hand.
#include <gtest/gtest.h>

#include "core/notation.hpp"
#include "pages/ranking_parts.hpp"
#include "tests/support/read_chart.hpp"

namespace reeve::testing {
namespace {

const Labels both{"TR7", "TR1"};

RankReport tr7_and_tr1() {
  RankRequest request;
  request.routings = {parse_routing("M-1-T-2-F"), parse_routing("1-P-2-P-1")};
  request.grasps = single_grasps(2);
  request.details = true;
  return *ranking_study(request, Catalogue{});
}

TEST(RankingAnswer, ComparesTheFirstWithTheSecond) {
  RankReport report = tr7_and_tr1();
  report.model.hardware.contacts.push_back({"T1", "T2", 0.1, {}});
  const Json answer = ranking_answer(report, both);
  EXPECT_EQ(answer["compared"],
            "Compared: 2 routings with 2 fingers in the grasps none/1/2 (held fingers), by "
            "uniformity mean, efficiency mean, at the friction coefficients 0.18 of tubes, 0.18 of "
            "sheaths and 0.001 of bearings; some fingers or contacts have their own.");
  EXPECT_EQ(answer["winner"],
            "TR7 comes first, with mean uniformity 0.998 and mean efficiency 0.322. Next is TR1, "
            "with mean uniformity 0.183 and mean efficiency 0.167.");
  EXPECT_EQ(
      answer["front"],
      "TR7 is alone on the Pareto front: no other is better in any of the objectives chosen.");
}

TEST(RankingAnswer, NamesOthersOnlyByObjectivesThatDoNotPutTheFirstFirst) {
  const Json others = ranking_answer(tr7_and_tr1(), both)["others"];
  EXPECT_FALSE(others.empty());
  for (const Json& other : others) EXPECT_EQ(other["routings"], "TR1") << other;
}

TEST(RankingAnswer, NamesWhoNeedsLeastMotorForceOfAHand) {
  RankReport report = tr7_and_tr1();
  report.details->best = {{Objective::motor_force, 80, {"M-1-T-2-F"}, 1},
                          {Objective::motor_power, 7, {"M-1-T-2-F"}, 1}};
  const Json others = ranking_answer(report, both)["others"];
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0]["objective"], "motor force");
}

// The first stands in the sentence before.
TEST(RankingAnswer, SaysWhatTheTradeoffDecidesAfterTheFirst) {
  const Json decision = ranking_answer(tr7_and_tr1(), both)["decision"];
  EXPECT_EQ(decision, Json({"It never jams unless all fingers are held.",
                            "No design within 2 % of it has fewer sheaths."}));
}

TEST(RankingAnswer, SaysWhetherAnotherCanTakeTheLead) {
  RankReport report = tr7_and_tr1();
  for (const auto& [lead, said] :
       {std::pair{0.25,
                  "Nowhere that was searched in the ranges of the coefficients does another "
                  "take the lead: it is least over TR1, 0.2500 in mean uniformity × mean "
                  "efficiency."},
        {-0.125,
         "Within the ranges of the coefficients the order can turn: the lead over TR1 "
         "falls to -0.1250 in mean uniformity × mean efficiency."}}) {
    Margin margin;
    margin.challenger = "M-1-T-2-F";
    margin.least_lead = lead;
    report.margins = {margin};
    EXPECT_EQ(ranking_answer(report, both)["margin"], said);
  }
}

TEST(RankingAnswer, HintsAtDrawsAndMarginsUnlessOneOfThemIsThere) {
  RankReport report = tr7_and_tr1();
  EXPECT_EQ(ranking_answer(report, both)["hint"], true);
  report.margins.emplace();
  EXPECT_EQ(ranking_answer(report, both)["hint"], false);
}

// As many designs, at points of their own.
RankReport designs_at(const std::vector<double>& uniformity) {
  RankReport report;
  for (const double value : uniformity) {
    ListedDesign& design = report.designs.emplace_back();
    design.ranked.design.values[0] = value;
    design.ranked.front = 2;
  }
  return report;
}

Labels numbered(std::size_t count) {
  Labels labels;
  for (std::size_t i = 0; i < count; ++i) labels.push_back("D" + std::to_string(i + 1));
  return labels;
}

std::size_t labelled(const ReadPanel& panel) {
  return static_cast<std::size_t>(
      std::count_if(panel.texts.begin(), panel.texts.end(),
                    [](const std::string& text) { return text.size() > 1 && text[0] == 'D'; }));
}

TEST(RankingPlot, LabelsAllOfTwelveAndOfMoreOnlyTheFront) {
  std::vector<double> values;
  for (int i = 0; i < 12; ++i) values.push_back(0.05 * i);
  EXPECT_EQ(labelled(read_chart(pareto_figure(designs_at(values), numbered(12)).svg).front()), 12U);
  values.push_back(0.9);
  RankReport more = designs_at(values);
  more.designs[12].ranked.front = 1;
  EXPECT_EQ(labelled(read_chart(pareto_figure(more, numbered(13)).svg).front()), 1U);
}

// Five on one point, of which the first alone is on the front.
TEST(RankingPlot, DrawsASharedPointOfTheFrontOnceAndNamesThreeOnIt) {
  RankReport report = designs_at({0.5, 0.5, 0.5, 0.5, 0.5, 0.25});
  report.designs[0].ranked.front = 1;
  const ReadPanel panel = read_chart(pareto_figure(report, numbered(6)).svg).front();
  const std::vector<ReadMark> front = panel.marks("points", "on the Pareto front");
  ASSERT_EQ(front.size(), 1U);
  EXPECT_EQ(front[0].title.substr(0, front[0].title.find('\n')), "D1, D2, D3 and 2 more");
  EXPECT_EQ(panel.marks("points", "dominated").size(), 1U);
}

TEST(RankFigure, ReachesFromTheLowToTheHighRank) {
  RankReport report = designs_at({0.5, 0.25, 0.1, 0});
  for (ListedDesign& design : report.designs) {
    design.distribution = RankDistribution{.median = 2, .low = 1, .high = 4};
  }
  const ReadPanel panel = read_chart(rank_figure(report, numbered(4)).svg).front();
  EXPECT_NEAR(panel.x_of(panel.marks("points").at(0)), 2, 1e-3);
  EXPECT_EQ(panel.marks("spans").at(0).title,
            "D1\nmedian rank 2\n5 % to 95 %: 1 to 4\nfirst in 0.0 % of the draws");
  EXPECT_NEAR(panel.x_of(panel.marks("spans").at(0)), 2.5, 1e-3);  // its middle
}

}  // namespace
}  // namespace reeve::testing
