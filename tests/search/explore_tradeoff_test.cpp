// The trade-off of an exploration is exact, however short the list that is kept, and the same for
// any number of threads and shards.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "search/rank/tradeoff.hpp"
#include "tests/search/naive_exploration.hpp"
#include "tests/search/naive_tradeoff.hpp"
#include "tests/search/same_exploration.hpp"

namespace reeve::testing {
namespace {

PartPrices some_prices() {
  PartPrices prices;
  prices.sheath = 7;
  prices.tip_bearing = 3.1;
  prices.fixed_pulley = 2.3;
  prices.movable_pulley = 4.7;
  prices.tube = 1.3;
  prices.fixed_end = 0.7;
  prices.tendon_mm = 0.01;
  return prices;
}

std::vector<Design> all_designs(const ExploreOptions& options) {
  std::vector<Design> designs;
  RoutingGenerator generator(options.generator);
  DesignEvaluator evaluator(options.model, options.grasps, options.score, options.prices);
  for (Routing routing; generator.next(routing);) {
    if (!is_actuated(routing)) continue;
    const ObjectiveValues values = evaluator.evaluate(routing);
    if (first_failure(options.constraints, values) == 0)
      designs.push_back({to_word(routing), values});
  }
  return designs;
}

// Expects of one kind the least of the measure within the loss, or the first where none is within.
void expect_naive_choice(const Design& chosen, std::vector<Design> kind, const Tradeoff& tradeoff,
                         const ExploreOptions& options) {
  const Objective by = tradeoff.options.by;
  std::vector<Design> within;
  for (const Design& design : kind) {
    if (is_within(design.values, tradeoff)) within.push_back(design);
  }
  const std::vector<Design>& from = within.empty() ? kind : within;
  if (!within.empty()) {
    const auto least =
        std::min_element(from.begin(), from.end(), [&](const Design& a, const Design& b) {
          return value(a.values, by) < value(b.values, by);
        });
    EXPECT_EQ(value(chosen.values, by), value(least->values, by));
  }
  std::vector<Design> with_as_little;
  for (const Design& design : from) {
    if (within.empty() || value(design.values, by) == value(chosen.values, by)) {
      with_as_little.push_back(design);
    }
  }
  EXPECT_EQ(chosen.word, naive_first(with_as_little, options.order, by).word);
}

void expect_naive_choices(const Tradeoff& tradeoff, const std::vector<Design>& designs,
                          const ExploreOptions& options) {
  std::vector<Design> with;
  std::vector<Design> without;
  for (const Design& design : designs) {
    (value(design.values, Objective::blocks) > 0 ? with : without).push_back(design);
  }
  ASSERT_EQ(tradeoff.choice.has_value(), !with.empty() && !without.empty());
  if (!tradeoff.choice) return;
  expect_naive_choice(tradeoff.choice->with, with, tradeoff, options);
  expect_naive_choice(tradeoff.choice->without, without, tradeoff, options);
}

void expect_naive_tradeoff(const ExploreOptions& options) {
  const std::vector<Design> designs = all_designs(options);
  const Tradeoff found = explore(options).tradeoff;
  const Objective by = options.tradeoff.by;
  EXPECT_EQ(steps_of(found), naive_tradeoff(designs, options.order, by));
  const Design first = rank(designs, options.order).front().design;
  EXPECT_EQ(found.first.word, first.word);
  expect_naive_choices(found, designs, options);
  const double least =
      naive_least(designs, first, ranked_by(options.order), by, options.tradeoff.within);
  EXPECT_EQ(found.affordable.has_value(), least < value(first.values, by));
  if (found.affordable) {
    EXPECT_EQ(value(found.affordable->values, by), least);
    for (const Objective objective : found.objectives) {
      EXPECT_LE(loss(objective, found.affordable->values, first.values),
                options.tradeoff.within + 1e-9);
    }
  }
}

TEST(ExploreTradeoff, AgreesWithItsDefinition) {
  for (const Objectives& objectives : several_objectives()) {
    for (const Objective by :
         {Objective::sheaths, Objective::pulleys, Objective::parts, Objective::cost}) {
      SCOPED_TRACE(std::string(row(by).name) + ", first by " + row(objectives.front()).name);
      ExploreOptions options = options_for(full_parts(), 3, objectives);
      options.top = 1;
      options.prices = some_prices();
      options.tradeoff = {by, 0.05};
      expect_naive_tradeoff(options);
    }
  }
}

TEST(ExploreTradeoff, AgreesWithItsDefinitionWithAScoreConstraintsAndBlocks) {
  ExploreOptions options = options_for(full_parts(), 3);
  options.top = 3;
  options.order = {both, true};
  options.score = parse_score("uniformity=1,jams=0.3,travel=0.01");
  expect_naive_tradeoff(options);
  options = options_for(full_parts(), 3);
  options.constraints = {parse_constraint("pulleys<=4"), parse_constraint("travel<=3")};
  expect_naive_tradeoff(options);
  options = options_for(all_parts(), 2);
  options.tradeoff.by = Objective::blocks;
  expect_naive_tradeoff(options);
}

TEST(ExploreTradeoff, ChoosesTheBestWithAndWithoutBlocks) {
  for (const Objectives& objectives : several_objectives()) {
    SCOPED_TRACE(std::string("first by ") + row(objectives.front()).name);
    ExploreOptions options = options_for(all_parts(), 3, objectives);
    options.top = 1;
    expect_naive_tradeoff(options);
    options.constraints = {parse_constraint("pulleys<=1")};
    expect_naive_tradeoff(options);
  }
}

TEST(ExploreTradeoff, ChoosesNothingWhereNoDesignHasBlocks) {
  EXPECT_FALSE(explore(options_for(full_parts(), 2)).tradeoff.choice);
}

// Shards keep what the whole needs, though the best without blocks are no steps of it.
TEST(ExploreTradeoff, ChoosesTheSameOfShards) {
  ExploreOptions options = options_for(all_parts(), 3);
  options.top = 1;
  const Tradeoff whole = explore(options).tradeoff;
  options.keeps_record = true;
  std::vector<ShardRecord> records;
  for (std::uint64_t shard = 1; shard <= 4; ++shard) {
    options.shard = {shard, 4};
    records.push_back(*explore(options).record);
  }
  options.shard = {};
  const Tradeoff merged = conclude(records, options, {}).tradeoff;
  ASSERT_TRUE(whole.choice && merged.choice);
  EXPECT_EQ(merged.choice->with.word, whole.choice->with.word);
  EXPECT_EQ(merged.choice->without.word, whole.choice->without.word);
  EXPECT_EQ(merged.choice->without.values, whole.choice->without.values);
}

// Another way to each step: an exploration that may have no more of the measure.
TEST(ExploreTradeoff, HasAtEachStepWhatAConstraintOnTheMeasureFinds) {
  ExploreOptions options = several_batches();
  const Tradeoff found = explore(options).tradeoff;
  ASSERT_GE(found.steps.size(), 4U);
  for (const TradeoffStep& step : found.steps) {
    options.constraints = {parse_constraint("sheaths<=" + std::to_string(step.at_most))};
    const Design best = explore(options).top.front().design;
    EXPECT_EQ(best.word, step.design.word);
    EXPECT_EQ(best.values, step.design.values);
  }
}

TEST(ExploreTradeoff, IsTheSameForAnyNumberOfThreads) {
  ExploreOptions options = several_batches();
  const Tradeoff one = explore(options).tradeoff;
  options.threads = 3;
  const Tradeoff three = explore(options).tradeoff;
  EXPECT_EQ(steps_of(one), steps_of(three));
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].design.values, three.steps[i].design.values);
  }
  EXPECT_EQ(one.knee, three.knee);
  ASSERT_TRUE(one.affordable && three.affordable);
  EXPECT_EQ(one.affordable->word, three.affordable->word);
}

TEST(ExploreTradeoff, OfTheWholeFollowsFromThoseOfItsShards) {
  ExploreOptions options = several_batches();
  const Tradeoff whole = explore(options).tradeoff;
  TradeoffArchive archive(options.order, Objective::sheaths);
  for (std::uint64_t shard = 1; shard <= 5; ++shard) {
    options.shard = {shard, 5};
    for (const TradeoffStep& step : explore(options).tradeoff.steps) archive.add(step.design);
  }
  EXPECT_EQ(steps_of(tradeoff(archive.candidates(), whole.first, options.order, options.tradeoff)),
            steps_of(whole));
}

TEST(ExploreTradeoff, HasNoStepWhereNothingIsLeft) {
  ExploreOptions options = options_for(full_parts(), 2);
  options.constraints = {parse_constraint("sheaths<=0")};
  EXPECT_TRUE(explore(options).tradeoff.steps.empty());
}

}  // namespace
}  // namespace reeve::testing
