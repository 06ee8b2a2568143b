// Designs under a model: its effects on hardware, friction and contacts count, the rig's do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "causes/library.hpp"
#include "causes/term.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/margin.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve {
namespace {

Effect effect(const std::string& cause, std::vector<double> values, Subject subject = {}) {
  return {find_cause(cause), std::move(subject), std::move(values)};
}

Subject seized(const std::string& routing, const std::string& contact) {
  Subject subject;
  subject.routing = routing;
  subject.contact = contact;
  return subject;
}

ObjectiveValues evaluate(const Model& model, const std::string& word,
                         const GraspSet& grasps = single_grasps(2)) {
  return DesignEvaluator(model, grasps).evaluate(parse_routing(word));
}

TEST(DesignUnderAModel, WithAnEffectOnHardwareIsTheDesignOnThatHardware) {
  Model model;
  add_effect(model, effect("tube_friction", {0.09}));
  Hardware hardware;
  hardware.tube.mu = 0.09;
  EXPECT_EQ(evaluate(model, "M-1-T-2-F"), evaluate(Model{hardware}, "M-1-T-2-F"));
}

TEST(DesignUnderAModel, WithoutTheRigsEffectsIsThePlainDesign) {
  Model model;
  Subject channel;
  channel.channel = parse_segment("T3");
  add_effect(model, effect("sensor_gain", {2}, channel));
  add_effect(model, effect("pretension", {5}));
  Subject grasp;
  grasp.routing = "M-1-T-2-F";
  grasp.recorded = Grasp{};
  grasp.actual = hold({1});
  add_effect(model, effect("wrong_grasp", {}, grasp));
  EXPECT_TRUE(std::none_of(model.effects.begin(), model.effects.end(), belongs_to_designs));
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1"}) {
    EXPECT_EQ(evaluate(model, word), evaluate(Model{}, word));
  }
}

// M-1-F: efficiency e^{-phi_s} (1 + e^{-phi_t}) / 2, with the exponents at the motor tension.
TEST(DesignUnderAModel, IsEvaluatedAtTheReferenceConditions) {
  Model model;
  add_effect(model, effect("load_dependent_friction", {0.2}));
  add_effect(model, effect("temperature", {0.01}));
  model.conditions.motor_tension_N = 40;
  model.conditions.temperature_C = 30;
  const double T1 = 40 * std::exp(-0.36 * std::numbers::pi * std::pow(4, -0.2) * 0.9);
  const double T2 = T1 * std::exp(-0.18 * std::numbers::pi * std::pow(T1 / 10, -0.2) * 0.9);
  const ObjectiveValues values = evaluate(model, "M-1-F", parse_grasps("none", 1));
  EXPECT_NEAR(value(values, Objective::efficiency_mean), (T1 + T2) / 80, 1e-9);
  EXPECT_NEAR(value(values, Objective::uniformity_mean), T2 / T1, 1e-9);
}

TEST(DesignUnderAModel, HasASeizedContactInTheRoutingThatItNamesOnly) {
  Model model;
  add_effect(model, effect("seized_contact", {}, seized("M-1-T-2-F", "T1-T2")));
  DesignEvaluator evaluator(model, parse_grasps("none", 2));
  const Routing tr1 = parse_routing("M-1-T-2-F");
  const Routing tr2 = parse_routing("M-1-T-2-M");
  for (int turn = 0; turn < 2; ++turn) {
    const ObjectiveValues values = evaluator.evaluate(tr1);
    EXPECT_NEAR(value(values, Objective::efficiency_mean), std::exp(-0.36 * std::numbers::pi),
                1e-9);
    EXPECT_EQ(value(values, Objective::uniformity_mean), 0);
    EXPECT_EQ(evaluator.evaluate(tr2), evaluate(Model{}, "M-1-T-2-M", parse_grasps("none", 2)));
  }
}

Effect law_at(const char* site, double a) {
  Term term;
  term.site = site_named(site).value();
  return {&law(term), {}, {a}};
}

TEST(DesignUnderAModel, HasALawOfARoutingInThatRoutingOnly) {
  Model model;
  add_effect(model, law_at("tube 2 of M-1-T-2-F", 0.5));
  DesignEvaluator evaluator(model, parse_grasps("none", 2));
  const double tube = 0.18 * std::numbers::pi;
  for (int turn = 0; turn < 2; ++turn) {
    const ObjectiveValues values = evaluator.evaluate(parse_routing("M-1-T-2-F"));
    EXPECT_NEAR(value(values, Objective::uniformity_mean), std::exp(-3.5 * tube), 1e-9);
    const ObjectiveValues others = evaluator.evaluate(parse_routing("M-1-T-2-M"));
    EXPECT_EQ(others, evaluate(Model{}, "M-1-T-2-M", parse_grasps("none", 2)));
  }
}

// Of one law on the held finger's tube, and one of the rig's.
TEST(DesignUnderAModel, HasLawsOfDesignsAndNoneOfRunsGroupsChannelsAndMotor) {
  Model model;
  add_effect(model, law_at("tube of held fingers", 1));
  Model of_rig = model;
  for (const char* site : {"sheath in run 3", "tube in group B"}) {
    add_effect(of_rig, law_at(site, 1));
  }
  EXPECT_EQ(std::count_if(of_rig.effects.begin(), of_rig.effects.end(), belongs_to_designs), 1);
  const ObjectiveValues values = evaluate(model, "M-1-T-2-F", parse_grasps("1", 2));
  EXPECT_NEAR(value(values, Objective::uniformity_mean), std::exp(-4 * 0.18 * std::numbers::pi),
              1e-9);
  EXPECT_EQ(evaluate(of_rig, "M-1-T-2-F", parse_grasps("1", 2)), values);
}

TEST(DesignUnderAModel, MayBeMovedWithItsEvaluator) {
  Model model;
  add_effect(model, effect("bending_stiffness", {0.2}));
  DesignEvaluator first(model, single_grasps(2));
  const ObjectiveValues expected = first.evaluate(parse_routing("M-1-T-2-F"));
  DesignEvaluator second = std::move(first);
  EXPECT_EQ(second.evaluate(parse_routing("M-1-T-2-F")), expected);
}

// Friction that grows with the load, and bearings that take a force which is all that arrives.
Model unsettled() {
  Model model;
  add_effect(model, effect("load_dependent_friction", {-0.3}));
  add_effect(model, effect("bearing_drag", {2}));
  return model;
}

TEST(DesignUnderAModel, CountsSolvesThatDoNotConverge) {
  Model model;
  add_effect(model, effect("load_dependent_friction", {0.2}));
  DesignEvaluator settled(model, single_grasps(2));
  settled.evaluate(parse_routing("1-P-2-P-1"));
  EXPECT_EQ(settled.unconverged(), 0U);
  const std::string word = "M-1b-T-2b-M";
  std::size_t expected = 0;
  for (const WeightedGrasp& grasp : single_grasps(2)) {
    for (const Direction direction : {Direction::pull, Direction::release}) {
      const Model other = unsettled();
      ModelSolver solver(other, other.hardware, word, expand(parse_routing(word)));
      solver.solve(grasp.grasp, direction, other.conditions);
      expected += solver.converged() ? 0 : 1;
    }
  }
  ASSERT_GT(expected, 0U);
  DesignEvaluator evaluator(unsettled(), single_grasps(2));
  evaluator.evaluate(parse_routing(word));
  EXPECT_EQ(evaluator.unconverged(), expected);
  evaluator.evaluate(parse_routing(word));
  EXPECT_EQ(evaluator.unconverged(), 2 * expected);
}

TEST(ExploreThreads, DoNotChangeHowManySolvesDidNotConverge) {
  ExploreOptions options;
  const int fingers = testing::has_sanitizer() ? 2 : 3;
  options.generator = {full_parts(), fingers, FingerIdentity::identical, false};
  options.grasps = single_grasps(fingers);
  options.model = unsettled();
  options.threads = 1;
  const std::uint64_t one = explore(options).unconverged;
  EXPECT_GT(one, 0U);
  options.threads = 3;
  EXPECT_EQ(explore(options).unconverged, one);
}

TEST(ExploreUnderAModel, AddsUpWhatDidNotConvergeOverTheRoutings) {
  ExploreOptions options;
  options.generator = {full_parts(), 2, FingerIdentity::identical, false};
  options.grasps = single_grasps(2);
  options.model = unsettled();
  const ExploreResult whole = explore(options);
  std::uint64_t one_by_one = 0;
  for (options.shard = {1, whole.total}; options.shard.index <= whole.total;
       ++options.shard.index) {
    one_by_one += explore(options).unconverged;
  }
  EXPECT_GT(whole.unconverged, 0U);
  EXPECT_EQ(whole.unconverged, one_by_one);
}

// The draw varies the hardware; a coefficient that an effect sets stays.
TEST(UncertaintyOfAModel, KeepsTheEffects) {
  UncertaintyOptions options;
  add_effect(options.nominal, effect("tube_friction", {0.09}));
  add_effect(options.nominal, effect("load_dependent_friction", {0.1}));
  const Model drawn = draw_model(options, 3);
  EXPECT_EQ(drawn.effects.size(), 2U);
  EXPECT_NE(drawn.hardware.sheath.mu, options.nominal.hardware.sheath.mu);
  EXPECT_EQ(effective_hardware(drawn).tube.mu, 0.09);
  EXPECT_EQ(effective_hardware(drawn).sheath.mu, drawn.hardware.sheath.mu);
}

TEST(UncertaintyOfAModel, IsCheckedWithTheEffectsOnTheHardware) {
  UncertaintyOptions options;
  Subject finger;
  finger.finger = 1;
  options.nominal.hardware.sheath.angle_rad = 40;
  EXPECT_NO_THROW(validate(options, 1));
  add_effect(options.nominal, effect("sheath_angle", {12}, finger));
  EXPECT_THROW(validate(options, 1), InputError);
}

TEST(MarginOfAModel, TellsTheCoefficientsWithTheEffectsOnThem) {
  MarginOptions options;
  add_effect(options.nominal, effect("tube_friction", {0.09}));
  options.grasps = single_grasps(2);
  options.evaluations = 50;
  const std::vector<Routing> ranked{parse_routing("1-P-2-P-1"), parse_routing("M-1-T-2-F")};
  EXPECT_EQ(margins(ranked, options)->at(0).at.tube.mu, 0.09);
}

}  // namespace
}  // namespace reeve
