#include "search/evaluate/shown_objectives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace reeve {
namespace {

using Objectives = std::vector<Objective>;

Objectives shown_on_demand(const Order& order, const Score& score = authors_score()) {
  Objectives shown = shown_objectives(order, score);
  std::erase_if(shown, [](Objective objective) { return !row(objective).on_demand; });
  return shown;
}

TEST(ShownObjectives, AreThoseThatAreNotOnDemandWhateverIsChosen) {
  for (const Order& order :
       {Order(), Order({Objective::travel}), Order({Objective::score}, true)}) {
    const Objectives shown = shown_objectives(order, authors_score());
    for (const ObjectiveRow& row : objective_table()) {
      if (row.on_demand) continue;
      EXPECT_EQ(std::count(shown.begin(), shown.end(), row.objective), 1) << row.name;
    }
    EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  }
}

TEST(ShownObjectives, OnDemandAreThoseThatAreChosen) {
  EXPECT_TRUE(shown_on_demand(Order()).empty());
  EXPECT_EQ(shown_on_demand(Order({Objective::travel, Objective::reliability})),
            Objectives{Objective::reliability});
}

TEST(ShownObjectives, OfAScoreThatOrdersAreTheScoreAndItsTerms) {
  const Objectives expected{Objective::adaptability, Objective::reliability, Objective::score};
  const Score score = parse_score("reliability,travel=2,adaptability");
  EXPECT_EQ(shown_on_demand(Order({Objective::travel}, true), score), expected);
  EXPECT_EQ(shown_on_demand(Order({Objective::score}), score), expected);
  EXPECT_TRUE(shown_on_demand(Order({Objective::travel}), score).empty());
}

TEST(ShownObjectives, AreAlsoThoseThatAConstraintNames) {
  const std::vector<Constraint> constraints{parse_constraint("motor_force<=80"),
                                            parse_constraint("sheaths<=2")};
  Objectives expected = shown_objectives(Order(), authors_score());
  expected.push_back(Objective::motor_force);
  EXPECT_EQ(shown_objectives(Order(), authors_score(), constraints), expected);
  EXPECT_TRUE(is_shown(Objective::motor_force, Order(), authors_score(), constraints));
  EXPECT_FALSE(is_shown(Objective::stroke, Order(), authors_score(), constraints));
}

}  // namespace
}  // namespace reeve
