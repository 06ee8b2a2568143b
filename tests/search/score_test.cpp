#include "search/evaluate/score.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/explore.hpp"
#include "search/rank/archive.hpp"
#include "search/rank/ranking.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

constexpr auto score_at = static_cast<std::size_t>(Objective::score);

TEST(Score, IsTheWeightedMeanWithLowerIsBetterTurnedRound) {
  ObjectiveValues values{};
  value(values, Objective::uniformity_mean) = 0.5;
  value(values, Objective::sheaths) = 4;
  add_score(parse_score("uniformity=3, sheaths=0.5"), values);
  EXPECT_NEAR(values[score_at], (3 * 0.5 - 0.5 * 4) / 3.5, 1e-10);
  add_score(parse_score("uniformity"), values);
  EXPECT_NEAR(values[score_at], 0.5, 1e-10);
}

TEST(Score, OfTheAuthorsIsTheMeanOfTheirFiveIndicators) {
  DesignEvaluator evaluator(Hardware{}, parse_grasps("paper", 2));
  const ObjectiveValues values = evaluator.evaluate(parse_routing("M-1-T-2-M"));
  double sum = 0;
  for (const Objective objective :
       {Objective::adaptability, Objective::torsional_balance, Objective::reliability,
        Objective::authors_efficiency, Objective::transmission}) {
    sum += value(values, objective);
  }
  EXPECT_NEAR(value(values, Objective::score), sum / 5, 1e-9);
}

TEST(Score, IsReadAsItIsWritten) {
  for (const char* text : {"adaptability=2,reliability=0.25", "travel=1"}) {
    EXPECT_EQ(to_text(parse_score(text)), text);
  }
  EXPECT_EQ(to_text(parse_score("authors")), to_text(authors_score()));
}

TEST(Score, SaysWhatIsWrongWithIt) {
  const auto error = [](const std::string& text) {
    return input_error([&] { parse_score(text); });
  };
  EXPECT_EQ(error("travel,travel=2"), "score 'travel,travel=2': 'travel' is named twice");
  EXPECT_EQ(error("score"),
            "score 'score': a score is no part of itself; expected other objectives");
  for (const char* weight : {"0", "-1", "nan", "inf", "1e9", "", "2x"}) {
    const std::string text = std::string("travel=") + weight;
    EXPECT_EQ(error(text), "score '" + text + "': '" + text +
                               "': expected a weight above 0 and at most 1000000, such as "
                               "adaptability=2");
  }
  EXPECT_NE(error("nothing").find("unknown objective 'nothing'"), std::string::npos);
  EXPECT_NE(error("").find("unknown objective ''"), std::string::npos);
}

// Values on a coarse grid, so that there are ties and fronts.
std::vector<Design> random_designs(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(0, 9);
  std::vector<Design> designs;
  for (std::size_t i = 0; i < count; ++i) {
    Design design{"w" + std::to_string(i), {}};
    for (const Objective objective :
         {Objective::uniformity_mean, Objective::efficiency_mean, Objective::score}) {
      value(design.values, objective) = level(random);
    }
    designs.push_back(design);
  }
  return designs;
}

TEST(Score, OrdersWithinTheFrontsWhereObjectivesAreChosenToo) {
  const auto ranked = rank(random_designs(200, 1), Order({Objective::uniformity_mean}, true));
  for (std::size_t i = 1; i < ranked.size(); ++i) {
    const RankedDesign& a = ranked[i - 1];
    const RankedDesign& b = ranked[i];
    EXPECT_LE(a.front, b.front);
    if (a.front == b.front) {
      EXPECT_GE(a.design.values[score_at], b.design.values[score_at]);
    }
  }
}

TEST(Score, AloneOrdersAllDesigns) {
  const auto ranked = rank(random_designs(200, 2), Order({Objective::score}, true));
  for (std::size_t i = 1; i < ranked.size(); ++i) {
    EXPECT_GE(ranked[i - 1].design.values[score_at], ranked[i].design.values[score_at]);
  }
}

TEST(Score, OrdersWhatAnArchiveKeepsLikeAFullRanking) {
  for (std::uint32_t seed = 3; seed < 13; ++seed) {
    const std::vector<Design> designs = random_designs(3000, seed);
    for (const Order& order :
         {Order({Objective::score}, true),
          Order({Objective::uniformity_mean, Objective::efficiency_mean}, true)}) {
      Archive archive(order, 20);
      for (const Design& design : designs) {
        if (archive.may_rank(design.values)) archive.add(design);
      }
      const auto kept = archive.content().ranked;
      const auto all = rank(designs, order);
      for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(kept[i].design.word, all[i].design.word) << seed << " " << i;
      }
    }
  }
}

ExploreOptions two_fingers() {
  ExploreOptions options;
  options.grasps = parse_grasps("paper", 2);
  options.model.hardware.tube.mu = 0.0525;
  options.model.hardware.sheath.mu = 0.0454;
  options.generator.parts = paper_parts();
  options.generator.one_tendon = true;
  return options;
}

// With the friction that the authors' readings show, their score puts another routing first than
// uniformity and efficiency do.
TEST(Score, OfTheAuthorsPutsTr3FirstAmongTheSevenAndTheObjectivesTr7) {
  ExploreOptions options = two_fingers();
  EXPECT_EQ(explore(options).top.front().design.word, "1-P-2-P-1");
  options.order = {{Objective::score}, true};
  const auto top = explore(options).top;
  ASSERT_EQ(top.size(), 7U);
  std::vector<std::string> words;
  for (const RankedDesign& design : top) words.push_back(design.design.word);
  EXPECT_EQ(words, (std::vector<std::string>{"F-1-P-2-F", "1-T-2-P-1", "M-1-T-2-F", "1-P-2-P-1",
                                             "M-1-T-2-M", "M-1-P-2-M", "M-1-P-2-F"}));
}

// Return friction takes a solve that is otherwise put off.
TEST(Score, OfReturnFrictionIsComputedForEveryDesign) {
  ExploreOptions options = two_fingers();
  options.score = parse_score("round_trip_efficiency");
  options.order = {{Objective::score}, true};
  for (const RankedDesign& design : explore(options).top) {
    EXPECT_GT(value(design.design.values, Objective::score), 0);
    EXPECT_EQ(value(design.design.values, Objective::score),
              value(design.design.values, Objective::round_trip_efficiency));
  }
}

TEST(Score, IsThereForAConstraintToo) {
  ExploreOptions options = two_fingers();
  options.constraints = {parse_constraint("score>0")};
  for (const char* score : {"authors", "round_trip_efficiency"}) {
    options.score = parse_score(score);
    EXPECT_EQ(explore(options).top.size(), 7U) << score;
  }
}

// M-1-T-2-F has one sheath, 1-P-2-P-1 is as uniform as can be; neither ever jams.
TEST(Score, OrdersTheDrawsOfAnUncertainRanking) {
  UncertaintyOptions options;
  options.grasps = parse_grasps("paper", 2);
  options.draws = 5;
  const std::vector<Routing> routings{parse_routing("M-1-T-2-F"), parse_routing("1-P-2-P-1")};
  const auto first_by = [&](const std::string& score) {
    options.score = parse_score(score);
    const auto ranks = drawn_designs(routings, options)->ranks;
    EXPECT_EQ(ranks[0].first + ranks[1].first, 1) << score;
    return ranks[0].first;
  };
  // One front of both, so that what orders within it decides.
  options.order = Order({Objective::jams}, true);
  EXPECT_EQ(first_by("sheaths"), 1);
  EXPECT_EQ(first_by("uniformity"), 0);
}

}  // namespace
}  // namespace reeve::testing
