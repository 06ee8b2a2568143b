// Explanations of training runs that held-out runs bear out, or not.
#include "diagnosis/verdict/withdrawal.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "causes/library.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

using Names = std::vector<std::string>;

const PatternCause on_nothing("on_nothing", {});

// T1 is off by 1 N in the training runs, and T2 by 1 N; both are accepted, in this order.
Explanation both(const Bench& training) {
  Explanation explanation;
  explanation.problem = training.problem;
  explanation.scatter.noise.absolute_N = bench_noise_N;
  for (const PatternCause* cause : {&on_T1, &on_T2}) {
    add_effect(explanation.model, {cause, {}, {1}});
    explanation.accepted.push_back({{cause, {}, {1}}, 0.001});
  }
  return explanation;
}

Withdrawal withdrawn(Explanation& explanation, const Pattern& held_out) {
  const Bench unseen(held_out);
  Workers workers(1);
  return withdraw_what_may_lose(explanation, unseen.dataset, {}, 1, workers);
}

TEST(Withdrawal, OfWhatForecastsTheOthersIsNone) {
  const Bench training({1, 1});
  Explanation explanation = both(training);
  const Withdrawal none = withdrawn(explanation, {1, 1});
  EXPECT_TRUE(none.names.empty());
  EXPECT_FALSE(none.held_out.has_value());
  EXPECT_EQ(explanation.accepted.size(), 2U);
}

// T2 is not off at all there, by more than T1 is: together they lose.
TEST(Withdrawal, TakesTheCauseThatWasAcceptedLast) {
  const Bench training({1, 1});
  Explanation explanation = both(training);
  const Withdrawal last = withdrawn(explanation, {1, -1});
  EXPECT_EQ(last.names, Names{"on_T2"});
  ASSERT_TRUE(last.held_out.has_value());
  EXPECT_LT(last.held_out->gain_low, 0);
  ASSERT_EQ(explanation.accepted.size(), 1U);
  ASSERT_EQ(explanation.model.effects.size(), 1U);
  EXPECT_EQ(effect_name(explanation.model.effects[0]), "on_T1");
}

// Readings that may scatter by much tell little by likelihood; that each comes out worse does.
TEST(Withdrawal, IsOfWhatSurelyMakesResidualsExplode) {
  const double size = 0.25;
  const Bench training({size, size});
  const auto names_if = [&](const Pattern& held_out) {
    Explanation explanation = both(training);
    for (Effect& effect : explanation.model.effects) effect.values = {size};
    explanation.scatter.noise.absolute_N = 1;
    return withdrawn(explanation, held_out).names;
  };
  EXPECT_EQ(names_if({size, size}), Names{});
  EXPECT_EQ(names_if({0, 0}), (Names{"on_T2", "on_T1"}));
}

// The first loses, the last gains: it is not for these runs to choose.
TEST(Withdrawal, GoesByTheOrderOfAcceptance) {
  const Bench training({1, 1});
  Explanation explanation = both(training);
  EXPECT_EQ(withdrawn(explanation, {-1, 1}).names, (Names{"on_T2", "on_T1"}));
  EXPECT_TRUE(explanation.model.effects.empty());
}

// What the first gains would pay for the second many times over.
TEST(Withdrawal, AsksForTheLastByItself) {
  const double second = 0.06;
  const Bench training({1, second});
  Explanation explanation = both(training);
  explanation.model.effects.back().values = {second};
  EXPECT_EQ(withdrawn(explanation, {1, second}).names, Names{});
  EXPECT_EQ(withdrawn(explanation, {1, 0}).names, Names{"on_T2"});
}

// A cause that no held-out run can show, beside a coefficient that is as the hardware says and
// fitted all the same: what it loses there by that is no word against the cause.
TEST(Withdrawal, IsNotForWhatFittedCoefficientsLose) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Bench training(BenchPlan{2, 3, seed}, [](std::size_t) { return Pattern{}; });
    Explanation explanation;
    explanation.problem = training.problem;
    explanation.scatter.noise.absolute_N = bench_noise_N;
    add_effect(explanation.base, {find_cause("tube_friction"), {}, {0.18}});
    explanation.base = fit(training.problem, explanation.base).model;
    explanation.model = explanation.base;
    const Effect nowhere{&on_nothing, {}, {1}};
    add_effect(explanation.model, nowhere);
    explanation.accepted.push_back({nowhere, 0.001});
    const Bench unseen(BenchPlan{5, 6, 100 + seed}, [](std::size_t) { return Pattern{}; });
    Workers workers(1);
    count += withdraw_what_may_lose(explanation, unseen.dataset, {}, 1, workers).names.size();
  }
  EXPECT_LE(count, 4U);
}

TEST(Withdrawal, NeedsHeldOutRuns) {
  const Bench training({1, 1});
  Explanation explanation = both(training);
  Workers workers(1);
  EXPECT_TRUE(withdraw_what_may_lose(explanation, {}, {}, 1, workers).names.empty());
}

// The pattern's size that the training runs say, and what the held-out ones read.
Names withdrawn_of(double size, const Pattern& held_out) {
  const Bench training({size});
  Explanation explanation;
  explanation.problem = training.problem;
  explanation.scatter.noise.absolute_N = bench_noise_N;
  add_effect(explanation.model, {&on_T1, {}, {size}});
  explanation.accepted.push_back({{&on_T1, {}, {size}}, 0.001});
  return withdrawn(explanation, held_out).names;
}

// 30 held-out readings with noise of 0.05 N expect 30 (0.02 / 0.05)^2 / 2 = 2.4 of 0.02 N, with a
// deviation of 2.2: that they gain nothing is no wonder. Of 0.05 N they expect 15.
TEST(Withdrawal, IsNotForRunsThatHardlyKnowTheCause) {
  EXPECT_EQ(withdrawn_of(0.02, {0.005}), Names{});
  EXPECT_EQ(withdrawn_of(0.02, {-0.02}), Names{"on_T1"});
  EXPECT_EQ(withdrawn_of(0.05, {0.005}), Names{"on_T1"});
}

// A coefficient that was drawn to the training runs.
TEST(Withdrawal, TakesBackWhatACoefficientWasSaidToBe) {
  const Bench training({0, 0});
  Explanation explanation;
  explanation.problem = training.problem;
  explanation.scatter.noise.absolute_N = bench_noise_N;
  Effect other{find_cause("tube_friction"), {}, {0.1}};
  add_effect(explanation.model, other);
  explanation.base = explanation.model;
  explanation.calibrations = {{other, {}, 0.001, 100, true}};
  EXPECT_EQ(withdrawn(explanation, {0, 0}).names, Names{"tube_friction"});
  EXPECT_FALSE(explanation.calibrations[0].differs);
  EXPECT_EQ(explanation.calibrations[0].p_value, 0.001);
  EXPECT_TRUE(explanation.model.effects.empty());
}

// Of the bench, with that friction in the tubes.
Pattern strands_N(double mu) {
  Hardware hardware;
  hardware.tube.mu = mu;
  const Network network = expand(parse_routing("M-1-T-2-F"));
  const TensionState state = tensions(network, mechanics(network, hardware), Grasp{});
  Pattern of_each;
  for (std::size_t strand = 1; strand <= 4; ++strand) of_each.push_back(20 * state.tension[strand]);
  return of_each;
}

// … whose loss a cause beside it pays for many times over.
TEST(Withdrawal, TakesBackACoefficientBesideACause) {
  const auto said_to_differ = [](double held_out_mu) {
    const Bench training({1});
    Explanation explanation;
    explanation.problem = training.problem;
    explanation.scatter.noise.absolute_N = bench_noise_N;
    Effect other{find_cause("tube_friction"), {}, {0.2}};
    add_effect(explanation.model, other);
    const Effect cause{&on_T1, {}, {1}};
    add_effect(explanation.model, cause);
    explanation.base.effects = {other};
    explanation.accepted.push_back({cause, 0.001});
    explanation.calibrations = {{other, {}, 0.001, 100, true}};
    Pattern held_out = strands_N(held_out_mu);
    const Pattern nominal = strands_N(0.18);
    for (std::size_t i = 0; i < 4; ++i) held_out[i] += (i == 0 ? 1 : 0) - nominal[i];
    const Names names = withdrawn(explanation, held_out).names;
    EXPECT_EQ(explanation.accepted.size(), 1U);
    EXPECT_EQ(explanation.model.effects.size(), 2U);
    EXPECT_EQ(explanation.calibrations[0].differs, names.empty());
    return names;
  };
  EXPECT_EQ(said_to_differ(0.2), Names{});
  EXPECT_EQ(said_to_differ(0.18), Names{"tube_friction"});
}

}  // namespace
}  // namespace reeve::testing
