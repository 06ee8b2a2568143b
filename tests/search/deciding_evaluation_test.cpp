#include "search/evaluate/deciding_evaluation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/uneven_model.hpp"

namespace reeve {
namespace {

using testing::uneven_model;
using Objectives = std::vector<Objective>;

// All that follows from what the strands do, and from the parts.
const Objectives of_strands{Objective::uniformity_mean,
                            Objective::uniformity_worst,
                            Objective::efficiency_mean,
                            Objective::efficiency_worst,
                            Objective::force_transmission,
                            Objective::finger_uniformity_mean,
                            Objective::finger_uniformity_worst,
                            Objective::jams,
                            Objective::travel,
                            Objective::sheaths,
                            Objective::pulleys,
                            Objective::knots,
                            Objective::blocks,
                            Objective::parts,
                            Objective::cost};

PartPrices some_prices() {
  PartPrices prices;
  prices.sheath = 3.1;
  prices.tube = 0.7;
  prices.tip_bearing = 1.3;
  prices.fixed_end = 0.17;
  prices.anchor = 0.4;
  prices.block = 2.2;
  prices.tendon_mm = 0.013;
  return prices;
}

struct Case {
  PartSet parts;
  int fingers;
  Model model;
  GraspSet grasps;
};

std::vector<Case> combined_cases() {
  return {{full_parts(), 4, {}, single_grasps(4)},
          {paper_parts(), 5, uneven_model(), single_grasps(5)},
          {testing::with_blocks(all_parts(), 1), 3, uneven_model(), single_grasps(3)},
          {testing::barred(testing::with_blocks(paper_parts(), 2)), 3, uneven_model(),
           single_grasps(3)},
          {testing::with_blocks(all_parts(), 3), 2, {}, single_grasps(2)},
          {full_parts(), 3, {}, parse_grasps("none:2/2:0.5/3", 3)}};
}

void expect_same_values(const Case& c, DecidingEvaluator& fast, const Objectives& wanted) {
  DesignEvaluator plain(c.model, c.grasps, authors_score(), some_prices());
  RoutingGenerator generator({c.parts, c.fingers, FingerIdentity::identical, false});
  for (Routing routing; generator.next(routing);) {
    if (!is_actuated(routing)) continue;
    const ObjectiveValues expected = plain.evaluate(routing);
    const ObjectiveValues seen = fast.evaluate(routing);
    for (const Objective objective : wanted) {
      // Not nearly: the same number.
      ASSERT_EQ(value(seen, objective), value(expected, objective))
          << to_word(routing) << ": " << row(objective).name;
    }
  }
}

TEST(DecidingEvaluation, CombinesTreesToTheSameNumbers) {
  for (const Case& c : combined_cases()) {
    DecidingEvaluator fast(c.model, c.grasps, authors_score(), some_prices(), of_strands);
    expect_same_values(c, fast, of_strands);
  }
}

const Objectives estimated{Objective::uniformity_mean,
                           Objective::uniformity_worst,
                           Objective::efficiency_mean,
                           Objective::efficiency_worst,
                           Objective::sheaths,
                           Objective::pulleys,
                           Objective::knots,
                           Objective::blocks,
                           Objective::parts};

TEST(DecidingEvaluation, EstimatesWithinALittleOfTheNumbers) {
  std::size_t jamming = 0;
  for (const Case& c : combined_cases()) {
    DesignEvaluator plain(c.model, c.grasps);
    DecidingEvaluator fast(c.model, c.grasps, authors_score(), {}, estimated);
    RoutingGenerator generator({c.parts, c.fingers, FingerIdentity::identical, false});
    for (Routing routing; generator.next(routing);) {
      if (!is_actuated(routing)) continue;
      const ObjectiveValues values = plain.evaluate(routing);
      const auto estimate = fast.estimate(routing);
      ASSERT_TRUE(estimate.has_value()) << to_word(routing);
      jamming += value(values, Objective::jams) > 0 ? 1 : 0;
      for (const Objective objective : estimated) {
        const double best = value(estimate->at_best, objective);
        const double worst = value(estimate->at_worst, objective);
        ASSERT_LE(worst, value(values, objective)) << to_word(routing) << row(objective).name;
        ASSERT_GE(best, value(values, objective)) << to_word(routing) << row(objective).name;
        ASSERT_LT(best - worst, 3e-9);
      }
    }
  }
  EXPECT_GT(jamming, 100U);
}

TEST(DecidingEvaluation, EstimatesNothingThatMoreThanSumsDecides) {
  Routing routing = parse_routing("M-1-F+M-2-F+M-3-F");
  const auto estimates = [&](Objectives wanted, const GraspSet& grasps) {
    return DecidingEvaluator({}, grasps, authors_score(), {}, std::move(wanted))
        .estimate(routing)
        .has_value();
  };
  EXPECT_TRUE(estimates(estimated, single_grasps(3)));
  EXPECT_FALSE(estimates({Objective::uniformity_mean, Objective::travel}, single_grasps(3)));
  EXPECT_FALSE(estimates({Objective::score}, single_grasps(3)));
  EXPECT_FALSE(estimates(estimated, parse_grasps("all", 3)));
}

struct WholeCase {
  const char* what;
  Model model;
  GraspSet grasps;
  Objectives wanted;
};

Model with_one_smooth_finger() {
  Model model;
  FingerHardware finger;
  finger.finger = 2;
  finger.tip_mu = 0.02;
  model.hardware.fingers.push_back(finger);
  return model;
}

Model with_one_smooth_contact() {
  Model model;
  model.hardware.contacts.push_back({"T1", "T2", 0.01, std::nullopt});
  return model;
}

// Where fingers differ, or a grasp holds two of them, or objectives need more than the strands.
TEST(DecidingEvaluation, SolvesWholeRoutingsWhereTreesDoNotShareStates) {
  const Objectives strands{Objective::uniformity_mean, Objective::efficiency_worst};
  const std::vector<WholeCase> cases{
      {"finger", with_one_smooth_finger(), single_grasps(3), strands},
      {"contact", with_one_smooth_contact(), single_grasps(3), strands},
      {"grasps", {}, all_grasps(3), strands},
      {"indicators", {}, single_grasps(3), {Objective::reliability, Objective::uniformity_mean}},
      {"release", {}, single_grasps(3), {Objective::round_trip_efficiency}},
      {"score", {}, single_grasps(3), {Objective::score}}};
  for (const WholeCase& c : cases) {
    SCOPED_TRACE(c.what);
    DecidingEvaluator fast(c.model, c.grasps, authors_score(), some_prices(), c.wanted);
    expect_same_values({full_parts(), 3, c.model, c.grasps}, fast, c.wanted);
  }
}

TEST(DecidingEvaluation, TakesRoutingsThatAreNotNumberedInOrder) {
  DecidingEvaluator fast({}, single_grasps(3), authors_score(), std::nullopt, of_strands);
  DesignEvaluator plain(Model{}, single_grasps(3));
  for (const char* word : {"M-2-P-1-F+M-3-F", "M-1-W1-2-F+W1-3-M", "M-Y1+3x-Y1-1x+M-2-M"}) {
    const Routing routing = parse_routing(word);
    const ObjectiveValues expected = plain.evaluate(routing);
    const ObjectiveValues seen = fast.evaluate(routing);
    EXPECT_EQ(value(seen, Objective::uniformity_mean), value(expected, Objective::uniformity_mean));
    EXPECT_EQ(value(seen, Objective::travel), value(expected, Objective::travel));
  }
}

TreeKey only_key(const std::string& word) {
  std::vector<TreeSpan> spans;
  EXPECT_TRUE(split_into_trees(parse_routing(word), spans)) << word;
  EXPECT_EQ(spans.size(), 1U) << word;
  return spans.front().key;
}

// Of the same tokens, with other blocks passed.
TEST(TreeSpans, KeysTellWhichBlockATendonPasses) {
  EXPECT_NE(only_key("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x"),
            only_key("M-Y1+Y2-Y1-Y3+1x-Y3-2x+3x-Y2-4x"));
}

TEST(TreeSpans, KeysKnowNothingOfTheNumbersOfFingersAndBlocks) {
  std::vector<TreeSpan> spans;
  ASSERT_TRUE(split_into_trees(parse_routing("M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x"), spans));
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].key, spans[1].key);
  EXPECT_EQ(spans[1].fingers_before, 2);
}

}  // namespace
}  // namespace reeve
