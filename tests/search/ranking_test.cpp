#include "search/rank/ranking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace reeve {
namespace {

struct Numbers {
  double uniformity = 0.5;
  double efficiency = 0.5;
  double sheaths = 0;
  double pulleys = 0;
  double knots = 0;
  double travel = 0;
};

Design design(const std::string& word, const Numbers& numbers) {
  Design result{word, {}};
  const auto set = [&](Objective objective, double number) {
    value(result.values, objective) = number;
  };
  set(Objective::uniformity_mean, numbers.uniformity);
  set(Objective::efficiency_mean, numbers.efficiency);
  set(Objective::sheaths, numbers.sheaths);
  set(Objective::pulleys, numbers.pulleys);
  set(Objective::knots, numbers.knots);
  set(Objective::travel, numbers.travel);
  return result;
}

// "a1 b1 c2": words with their fronts, best first.
std::string order(const std::vector<Design>& designs, const std::vector<Objective>& objectives) {
  std::string text;
  for (const RankedDesign& ranked : rank(designs, objectives)) {
    text += (text.empty() ? "" : " ") + ranked.design.word + std::to_string(ranked.front);
  }
  return text;
}

const std::vector<Objective> both_means{Objective::uniformity_mean, Objective::efficiency_mean};

// Few values, so that every rule is needed.
std::vector<Design> random_designs(std::mt19937_64& engine, std::size_t count) {
  const auto pick = [&](int levels) {
    return static_cast<double>(engine() % static_cast<std::uint64_t>(levels));
  };
  std::vector<Design> designs;
  for (std::size_t i = 0; i < count; ++i) {
    designs.push_back(design("w" + std::to_string(i),
                             {pick(4) / 4, pick(4) / 4, pick(3), pick(2), pick(2), pick(3)}));
  }
  return designs;
}

TEST(Ranking, Rule1TheFrontComesFirst) {
  // By product, parts and word the order would be the other way round.
  const std::vector<Design> designs{design("a", {0.9, 0.9, 0, 0, 0, 3}),
                                    design("b", {0.1, 0.1, 4, 2, 1, 1}),
                                    design("c", {0.5, 0.5, 2, 0, 0, 2})};
  EXPECT_EQ(order(designs, {Objective::travel}), "b1 c2 a3");
}

TEST(Ranking, Rule2TheGreaterProductOfUniformityAndEfficiencyComesFirst) {
  const std::vector<Design> designs{design("a", {0.9, 0.1, 0, 0, 0}),
                                    design("b", {0.1, 0.8, 0, 0, 0}),
                                    design("c", {0.5, 0.5, 4, 2, 1})};
  EXPECT_EQ(order(designs, both_means), "c1 a1 b1");
}

TEST(Ranking, Rule2UsesMeanUniformityAndEfficiencyWhateverTheObjectives) {
  const std::vector<Design> designs{design("a", {0.2, 0.2}), design("b", {0.4, 0.4})};
  EXPECT_EQ(order(designs, {Objective::knots}), "b1 a1");
}

TEST(Ranking, Rule3FewerPartsComeFirstOfWhicheverKind) {
  const std::vector<Design> designs{
      design("a", {0.5, 0.5, 2, 2, 0}), design("b", {0.5, 0.5, 1, 1, 1}),
      design("c", {0.5, 0.5, 0, 0, 2}), design("d", {0.5, 0.5, 1, 0, 0}),
      design("e", {0.5, 0.5, 5, 0, 0}), design("f", {0.5, 0.5, 0, 6, 0})};
  EXPECT_EQ(order(designs, both_means), "d1 c1 b1 a1 e1 f1");
}

TEST(Ranking, Rule3CountsABlockAsAPart) {
  Design with_block = design("a", {0.5, 0.5, 1, 0, 0});
  value(with_block.values, Objective::blocks) = 2;
  EXPECT_EQ(order({with_block, design("b", {0.5, 0.5, 2, 0, 0})}, both_means), "b1 a1");
}

TEST(Ranking, Rule4TheWordDecidesByteByByte) {
  const std::vector<Design> designs{design("M-2-F", {}), design("M-10-F", {}),
                                    design("1-P-1", {}), design("M-1-M", {}),
                                    design("M-1-F", {}), design("M-1-F+M-2-F", {})};
  EXPECT_EQ(order(designs, both_means), "1-P-11 M-1-F1 M-1-F+M-2-F1 M-1-M1 M-10-F1 M-2-F1");
}

TEST(Ranking, ProductBreaksTiesBeforePartsAndPartsBeforeTheWord) {
  const std::vector<Design> designs{design("a", {0.5, 0.5, 3}), design("b", {0.5, 0.5, 2}),
                                    design("c", {0.6, 0.5, 9})};
  EXPECT_EQ(order(designs, {Objective::travel}), "c1 b1 a1");
}

TEST(Ranking, RanksCountFromOneWithoutGapsAndFrontsNeverFall) {
  std::mt19937_64 engine(3);
  const std::vector<RankedDesign> ranked = rank(random_designs(engine, 300), both_means);
  ASSERT_EQ(ranked.size(), 300U);
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    EXPECT_EQ(ranked[i].rank, i + 1);
    EXPECT_LE(ranked[i == 0 ? 0 : i - 1].front, ranked[i].front);
  }
  EXPECT_EQ(ranked[0].front, 1);
}

TEST(Ranking, WithinAFrontEveryTwoDesignsHaveAnOrder) {
  std::mt19937_64 engine(4);
  const std::vector<Design> designs = random_designs(engine, 120);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (std::size_t k = 0; k < designs.size(); ++k) {
      const int either = (precedes_within_front(designs[i], designs[k], {}) ? 1 : 0) +
                         (precedes_within_front(designs[k], designs[i], {}) ? 1 : 0);
      EXPECT_EQ(either, i == k ? 0 : 1);
    }
  }
}

TEST(Ranking, DoesNotDependOnTheOrderOfTheInput) {
  std::mt19937_64 engine(5);
  for (const std::vector<Objective>& objectives :
       {both_means, std::vector<Objective>{Objective::travel},
        std::vector<Objective>{Objective::sheaths, Objective::pulleys, Objective::travel}}) {
    std::vector<Design> designs = random_designs(engine, 150);
    const std::string expected = order(designs, objectives);
    for (int turn = 0; turn < 5; ++turn) {
      std::shuffle(designs.begin(), designs.end(), engine);
      EXPECT_EQ(order(designs, objectives), expected);
    }
  }
}

TEST(Ranking, KeepsWordAndValuesTogether) {
  std::mt19937_64 engine(6);
  const std::vector<Design> designs = random_designs(engine, 60);
  for (const RankedDesign& ranked : rank(designs, both_means)) {
    const auto original = std::find_if(designs.begin(), designs.end(), [&](const Design& design) {
      return design.word == ranked.design.word;
    });
    ASSERT_NE(original, designs.end());
    EXPECT_EQ(original->values, ranked.design.values);
  }
}

TEST(Ranking, OfNothingIsEmpty) { EXPECT_TRUE(rank({}, both_means).empty()); }

const BestDesigns& best(const std::vector<BestDesigns>& all, Objective objective) {
  return *std::find_if(all.begin(), all.end(),
                       [&](const BestDesigns& best) { return best.objective == objective; });
}

TEST(BestByObjective, NamesTheFirstOfTheRankAndCountsAllThatAreAsGood) {
  const std::vector<Design> designs{design("a", {0.1, 0.5, 2}), design("b", {0.9, 0.5, 1}),
                                    design("c", {0.8, 0.5, 1}), design("d", {0.7, 0.5, 1}),
                                    design("e", {0.6, 0.5, 1})};
  const auto all = best_by_objective(rank(designs, {Objective::knots}), 2);
  const BestDesigns& sheaths = best(all, Objective::sheaths);
  EXPECT_EQ(sheaths.value, 1);
  EXPECT_EQ(sheaths.words, (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(sheaths.count, 4U);
  const BestDesigns& uniformity = best(all, Objective::uniformity_mean);
  EXPECT_EQ(uniformity.value, 0.9);
  EXPECT_EQ(uniformity.words, std::vector<std::string>{"b"});
  EXPECT_EQ(uniformity.count, 1U);
  EXPECT_EQ(best(all, Objective::efficiency_mean).count, 5U);
}

TEST(BestByObjective, HasARowForEveryObjectiveThatThereIsInTheOrderOfTheTable) {
  Design with_hand = design("a", {});
  value(with_hand.values, Objective::stroke) = 50;
  for (const Design& only : {design("a", {}), with_hand}) {
    std::vector<Objective> expected;
    for (const ObjectiveRow& row : objective_table()) {
      if (is_there(row, only.values)) expected.push_back(row.objective);
    }
    const auto all = best_by_objective(rank({only}, both_means), 1);
    ASSERT_EQ(all.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(all[i].objective, expected[i]);
      EXPECT_EQ(all[i].words, std::vector<std::string>{"a"});
    }
  }
}

TEST(BestByObjective, OfNothingIsNothing) { EXPECT_TRUE(best_by_objective({}, 3).empty()); }

}  // namespace
}  // namespace reeve
