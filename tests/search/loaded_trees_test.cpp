// Bounds from trees whose friction depends on the load, held against every design.
#include "search/evaluate/loaded_trees.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "causes/library.hpp"
#include "causes/term.hpp"
#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/deciding_evaluation.hpp"

namespace reeve {
namespace {

const std::vector<Objective> bounded{Objective::uniformity_mean, Objective::uniformity_worst,
                                     Objective::efficiency_mean, Objective::efficiency_worst,
                                     Objective::sheaths,         Objective::parts};

Model with_effect(const char* cause, double value) {
  Model model;
  add_effect(model, {find_cause(cause), {}, {value}});
  return model;
}

Model with_law(ContactKind kind, Form form, std::vector<double> values) {
  Term term;
  term.site.kind = kind;
  term.form = form;
  term.x.kind = CovariateKind::load;
  term.x.middle = 5;
  term.x.seen = {0.05, 40};
  Model model;
  add_effect(model, {&law(term), {}, std::move(values)});
  return model;
}

// Friction of tubes falls with the logarithm of the load, that of sheaths grows. Lengths differ.
Model with_two_laws() {
  Model model = with_law(ContactKind::tube, Form::log, {-0.15});
  add_effect(model, with_law(ContactKind::sheath, Form::linear, {0.01}).effects.front());
  model.hardware.motor_side_mm = 310;
  model.hardware.hand_mm = 23;
  model.conditions.motor_tension_N = 27;
  return model;
}

// Every design lies within its bounds, and every solve converges. Returns how many designs there
// are.
std::size_t compared(const Model& model, const GraspSet& grasps, int fingers) {
  EXPECT_TRUE(LoadedTrees::can_bound(model));
  DecidingEvaluator bounding(model, grasps, authors_score(), std::nullopt, bounded);
  DesignEvaluator evaluator(model, grasps);
  const EvaluationScope scope = scope_for(bounded, authors_score());
  RoutingGenerator generator({full_parts(), fingers, FingerIdentity::identical, false});
  std::size_t many = 0;
  for (Routing routing; generator.next(routing) && !::testing::Test::HasFailure();) {
    if (!is_actuated(routing)) continue;
    const auto estimate = bounding.estimate(routing);
    EXPECT_TRUE(estimate.has_value()) << to_word(routing);
    if (!estimate) continue;
    const ObjectiveValues values = evaluator.evaluate(routing, scope);
    for (const Objective objective : bounded) {
      EXPECT_LE(value(estimate->at_worst, objective), value(values, objective))
          << row(objective).name << " of " << to_word(routing);
      EXPECT_GE(value(estimate->at_best, objective), value(values, objective))
          << row(objective).name << " of " << to_word(routing);
      EXPECT_LT(value(estimate->at_best, objective) - value(estimate->at_worst, objective), 0.3);
    }
    ++many;
  }
  EXPECT_EQ(evaluator.unconverged(), 0U);
  return many;
}

TEST(LoadedTrees, BoundEveryDesignWhoseFrictionFallsWithTheLoad) {
  const Model model = with_effect("load_dependent_friction", 0.2);
  EXPECT_EQ(compared(model, single_grasps(4), 4), 3402U);
  EXPECT_GT(compared(model, parse_grasps("none:2/2:1", 3), 3), 300U);
}

TEST(LoadedTrees, BoundEveryDesignOfLawsThatFallAndRise) {
  EXPECT_EQ(compared(with_two_laws(), single_grasps(4), 4), 3402U);
}

TEST(LoadedTrees, BoundWhatGrowsWithTheLoad) {
  EXPECT_GT(compared(with_effect("load_dependent_friction", -0.3), single_grasps(3), 3), 300U);
}

TEST(LoadedTrees, BoundNothingWhereALessTensionMayPassOnMore) {
  EXPECT_FALSE(LoadedTrees::can_bound({}));
  // A force takes all that there is of a small tension, and exponents end there.
  EXPECT_FALSE(LoadedTrees::can_bound(with_effect("bending_stiffness", 0.01)));
  EXPECT_FALSE(LoadedTrees::can_bound(with_effect("load_dependent_friction", 0.7)));
  EXPECT_FALSE(LoadedTrees::can_bound(with_law(ContactKind::sheath, Form::linear, {0.5})));
  EXPECT_FALSE(LoadedTrees::can_bound(with_law(ContactKind::tube, Form::step, {0.1, 3})));
}

TEST(LoadedTrees, BoundNothingWhereFingersOrContactsDiffer) {
  Model model = with_effect("load_dependent_friction", 0.2);
  FingerHardware first;
  first.finger = 1;
  first.tip_mu = 0.1;
  model.hardware.fingers = {first};
  EXPECT_FALSE(LoadedTrees::can_bound(model));
  Term term = *term_of(*with_law(ContactKind::tube, Form::log, {0.1}).effects.front().cause);
  term.site.finger = 2;
  Model of_finger;
  add_effect(of_finger, {&law(term), {}, {-0.1}});
  EXPECT_FALSE(LoadedTrees::can_bound(of_finger));
}

TEST(LoadedTrees, LeaveTendonsThatBlocksTie) {
  DecidingEvaluator bounding(with_effect("load_dependent_friction", 0.2), single_grasps(2),
                             authors_score(), std::nullopt, bounded);
  EXPECT_FALSE(bounding.estimate(parse_routing("M-Y1+1x-Y1-2x")).has_value());
  EXPECT_TRUE(bounding.estimate(parse_routing("M-1-F+M-2-F")).has_value());
}

}  // namespace
}  // namespace reeve
