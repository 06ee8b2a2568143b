#include "search/evaluate/shared_states.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/uneven_model.hpp"

namespace reeve {
namespace {

using testing::anchored;
using testing::uneven_model;
using testing::with_blocks;

struct SharedCase {
  PartSet parts;
  int fingers;
  Model model;
  GraspSet grasps;
};

std::vector<SharedCase> shared_cases() {
  return {{full_parts(), 4, {}, single_grasps(4)},
          {anchored(full_parts()), 3, uneven_model(), single_grasps(3)},
          {with_blocks(all_parts(), 2), 2, uneven_model(), single_grasps(2)},
          {full_parts(), 3, {}, parse_grasps("none:2/2:0.5/3", 3)},
          {full_parts(), 3, {}, parse_grasps("2", 3)}};
}

TEST(SharedStates, GiveEveryObjectiveToTheLastBit) {
  for (const SharedCase& c : shared_cases()) {
    DesignEvaluator plain(c.model, c.grasps);
    DesignEvaluator sharing(c.model, c.grasps);
    sharing.share_trees();
    testing::for_each_generated(
        testing::generating(c.parts, c.fingers, testing::identical), [&](const Routing& routing) {
          if (!is_actuated(routing)) return;
          const ObjectiveValues expected = plain.evaluate(routing);
          ASSERT_EQ(sharing.evaluate(routing), expected) << to_word(routing);
        });
  }
}

TEST(SharedStates, HoldTensionsOfPullAndReleaseInEveryGrasp) {
  SharedStates shared{Hardware{}};
  const Routing routing = parse_routing("1-P-2-P-1+M-3b-B-4-F+M-5-F");
  ASSERT_TRUE(shared.set_routing(routing));
  const Network network = expand(routing);
  const Mechanics parts = mechanics(network, Hardware{});
  TensionState state;
  for (const WeightedGrasp& grasp : single_grasps(5)) {
    for (const Direction direction : {Direction::pull, Direction::release}) {
      ASSERT_TRUE(shared.solve(grasp.grasp, direction, state));
      const TensionState expected = tensions(network, parts, grasp.grasp, direction);
      EXPECT_EQ(state.jams, expected.jams);
      EXPECT_EQ(state.tension, expected.tension);
      EXPECT_EQ(state.closing, expected.closing);
    }
  }
}

TEST(SharedStates, DoNotApplyToASingleTree) {
  EXPECT_FALSE(SharedStates{Hardware{}}.set_routing(parse_routing("M-1-T-2-F")));
}

TEST(SharedStates, AreNotOfGraspsThatGiveTheTravelsOfCarriages) {
  const Routing routing = parse_routing("1x-M+2x-M2");
  for (const std::string text : {"none@1,0.25/1@0,1", "none/1"}) {
    const GraspSet grasps = parse_grasps(text, 2, 2);
    DesignEvaluator plain(Hardware{}, grasps);
    DesignEvaluator sharing(Hardware{}, grasps);
    sharing.share_trees();
    EXPECT_EQ(sharing.evaluate(routing), plain.evaluate(routing)) << text;
  }
}

TEST(SharedStates, NeedEqualSpools) {
  Model model;
  model.hardware.spools = {{"b", 0.5}};
  EXPECT_FALSE(routings_share_states(model));
  const DesignOutcome outcome =
      DesignEvaluator(model, single_grasps(2)).outcome(parse_routing("1x-M+2x-M"), {});
  EXPECT_DOUBLE_EQ(outcome.travel, 2 / 1.5);
}

TEST(SharedStates, NeedFingersThatAreAlike) {
  Model model;
  EXPECT_TRUE(routings_share_states(model));
  FingerHardware finger;
  finger.finger = 2;
  finger.tip_mu = 0.3;
  model.hardware.fingers.push_back(finger);
  EXPECT_FALSE(routings_share_states(model));
  const GraspSet grasps = single_grasps(2);
  DesignEvaluator plain(model, grasps);
  DesignEvaluator sharing(model, grasps);
  sharing.share_trees();
  const Routing routing = parse_routing("M-1-F+M-2-F");
  EXPECT_EQ(sharing.evaluate(routing), plain.evaluate(routing));
}

}  // namespace
}  // namespace reeve
