#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

bool is_among(const std::string& word, const std::vector<RankedDesign>& designs) {
  return std::any_of(designs.begin(), designs.end(),
                     [&](const RankedDesign& entry) { return entry.design.word == word; });
}

// With one sheath instead of four as good as TR7.
TEST(ExploreTrees, ThePulleyAtTheHandIsOnTheFrontBesideTR7) {
  const Objectives with_sheaths{Objective::uniformity_mean, Objective::efficiency_mean,
                                Objective::sheaths};
  const ExploreResult result = explore(options_for(all_parts(), 2, with_sheaths));
  EXPECT_TRUE(is_among("M-Y1+1x-Y1-2x", result.front));
  EXPECT_FALSE(is_among("1-P-2-P-1", result.front));
  EXPECT_EQ(result.total, 480U);
  EXPECT_EQ(result.evaluated, 283U);
  EXPECT_EQ(result.rejected.front().count, 480U - 283U);

  EXPECT_TRUE(is_among("M-Y1+1x-Y1-2x", explore(options_for(all_parts(), 2)).front));
}

// With r = e^−φ of a block, M and finger 3 have the tensions 1 : r, and the other two fingers share
// 1 + r: in equal parts, or 1 : r if one of them is held.
TEST(ExploreTrees, LinkedBlocksMakeThreeEqualFingersWithOneSheath) {
  PartSet parts = with_blocks(all_parts(), 2);
  const Objectives with_sheaths{Objective::uniformity_mean, Objective::efficiency_mean,
                                Objective::sheaths};
  const std::string word = "Y1-Y2+1x-Y1-2x+M-Y2-3x";
  EXPECT_FALSE(is_among(word, explore(options_for(parts, 3, with_sheaths)).front));
  parts.linked = true;
  const ExploreResult result = explore(options_for(parts, 3, with_sheaths));
  EXPECT_EQ(result.top.front().design.word, word);
  const double r = std::exp(-0.001 * std::numbers::pi);
  EXPECT_NEAR(value(result.top.front().design.values, Objective::uniformity_mean),
              (2 * 2 * r / (1 + r) + 2 * r) / 4, 1e-9);
}

// On one side of each block is an end of the tendon, on the other the strand between the blocks,
// with r of the end's tension in every grasp.
TEST(ExploreTrees, BlocksInSeriesPullTwoFingersAlike) {
  PartSet parts = with_blocks(all_parts(), 2);
  const std::string word = "1x-Y1+M-Y1-Y2-M+2x-Y2";
  EXPECT_FALSE(is_among(word, explore(options_for(parts, 2)).front));
  parts.series = true;
  const ExploreResult result = explore(options_for(parts, 2));
  EXPECT_EQ(result.top.front().design.word, word);
  EXPECT_NEAR(value(result.top.front().design.values, Objective::uniformity_mean), 1, 1e-9);
}

// By symmetry the tendon stays where it is on finger 2 and on both sheaves, so that all strands are
// alike while no finger is held.
TEST(ExploreTrees, ADoublePassPullsThreeFingersWithOneBlockAndOneSheath) {
  PartSet parts = with_blocks(all_parts(), 1);
  ExploreOptions options = options_for(parts, 3);
  options.constraints = constraints_of({"sheaths<=1"});
  const std::string word = "M-Y1+1x-Y1-2b-Y1-3x";
  EXPECT_FALSE(is_among(word, explore(options).front));
  options.generator.parts.double_passes = true;
  const ExploreResult result = explore(options);
  const Design& best = result.top.front().design;
  EXPECT_EQ(best.word, word);
  DesignEvaluator evaluator(Model{}, parse_grasps("none", 3));
  EXPECT_NEAR(value(evaluator.evaluate(parse_routing(word)), Objective::uniformity_mean), 1, 1e-12);
}

// Two bars that share the pull 1 : 2 and 1 : 1 leave nothing to friction at the hand.
TEST(ExploreTrees, BarsPullThreeFingersAlikeWithOneSheath) {
  PartSet parts = with_blocks(all_parts(), 2);
  parts.bars = true;
  const ExploreResult result = explore(options_for(parts, 3));
  const Design& best = result.top.front().design;
  EXPECT_EQ(best.word, "M-W1+1x-W1/1:2-W2+2x-W2-3x");
  EXPECT_NEAR(value(best.values, Objective::uniformity_mean), 1, 1e-12);
  EXPECT_NEAR(value(best.values, Objective::efficiency_mean),
              std::exp(-0.18 * 2 * std::numbers::pi), 1e-9);
}

// Bars only, on a motor's end, and no finger on a tendon that pulls a bar: its strands would have
// the pull of all below.
bool is_plain_whiffletree(const Routing& routing) {
  if (block_count(routing).blocks > 0 || to_word(routing).rfind("M-W1+", 0) != 0) return false;
  return std::none_of(routing.tendons.begin(), routing.tendons.end(), [](const Tendon& tendon) {
    const Walk& walk = tendon.walk;
    return (is_tail(walk.front().kind) && is_of_finger(walk[1].kind)) ||
           (is_tail(walk.back().kind) && is_of_finger(walk[walk.size() - 2].kind));
  });
}

TEST(ExploreTrees, WithoutFrictionBarsPullAllStrandsBelowAlike) {
  Model smooth;
  for (ContactLaw* law : {&smooth.hardware.tube, &smooth.hardware.bearing}) law->mu = 0;
  DesignEvaluator evaluator(smooth, single_grasps(4));
  int trees = 0;
  const PartSet parts = barred(with_blocks(anchored(parts_of("tube", "T", "M,F")), 3));
  for_each_generated(generating(parts, 4, identical, true), [&](const Routing& routing) {
    if (!is_plain_whiffletree(routing)) return;
    ++trees;
    EXPECT_NEAR(value(evaluator.evaluate(routing), Objective::uniformity_worst), 1, 1e-9)
        << to_word(routing);
  });
  EXPECT_GT(trees, 100);
}

// Of the options' references, too: a tree that was generated is found by its word.
TEST(ExploreTrees, AReferenceWithABlockIsFoundAmongTheRoutings) {
  ExploreOptions options = options_for(all_parts(), 2);
  options.references = {canonical(parse_routing("1x-Y1-2x+Y1-M"), FingerIdentity::identical)};
  const ExploreResult result = explore(options);
  EXPECT_TRUE(result.references.front().generated);
  EXPECT_EQ(result.references.front().front, 1);
}

}  // namespace
}  // namespace reeve::testing
