#include "diagnosis/search/rivals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

using Names = std::vector<std::string>;

const PatternCause on_both("on_both", {1, 1});

Rival rival(const char* name, double deficit, double size) {
  return {name, {on_T1.model(size), 1}, deficit};
}

TEST(Indistinguishable, IsWhatExplainsNearlyAsMuch) {
  const auto group = indistinguishable("accepted", on_T1.model(9),
                                       {rival("better", -0.5, 1), rival("near", 3.99, 2),
                                        rival("at the margin", 4, 3), rival("far", 20, 4)});
  EXPECT_EQ(group.names, (Names{"accepted", "better", "near"}));
  ASSERT_EQ(group.models.size(), 3U);
  EXPECT_EQ(group.models[0].effects[0].values[0], 9);
  EXPECT_EQ(group.models[1].effects[0].values[0], 1);
  EXPECT_EQ(group.models[2].effects[0].values[0], 2);
}

// Several wrong grasps bear one name: the first of them, which is the likeliest, stands for all.
TEST(Indistinguishable, NamesEveryNameOnce) {
  const auto group = indistinguishable("accepted", on_T1.model(9),
                                       {rival("near", 0.5, 1), rival("near", 1, 2),
                                        rival("accepted", 1.5, 3), rival("other", 2, 4)});
  EXPECT_EQ(group.names, (Names{"accepted", "near", "other"}));
  ASSERT_EQ(group.models.size(), 3U);
  EXPECT_EQ(group.models[1].effects[0].values[0], 1);
  EXPECT_EQ(group.models[2].effects[0].values[0], 4);
}

TEST(Indistinguishable, IsOneNameWhereNoRivalIsNear) {
  EXPECT_EQ(indistinguishable("accepted", on_T1.model(9), {rival("far", 4.01, 1)}).names,
            Names{"accepted"});
}

std::vector<Rival> rivals_of(const Bench& bench, const Model& model, std::size_t effect,
                             const std::vector<const PatternCause*>& causes) {
  std::vector<Candidate> candidates;
  for (const PatternCause* cause : causes) candidates.push_back(cause->candidate());
  Workers workers(1);
  return rivals(bench.problem, model, effect, candidates, workers);
}

// Σ e² less what an offset of the best size on the pattern takes away: (p·e)² / |p|² for each
// reading of the bench, as all of its rows are alike.
double misfit_with(const Bench& bench, const Pattern& pattern) {
  const Eigen::VectorXd left = residuals(bench.problem, forecast(bench.dataset, {}));
  double along = 0;
  double square = 0;
  for (std::size_t i = 0; i < bench.dataset.cells.size(); ++i) {
    const std::size_t strand = bench.dataset.cells[i].channel;
    const double p = strand < pattern.size() ? pattern[strand] : 0;
    along += p * left[static_cast<Eigen::Index>(i)];
    square += p * p;
  }
  return left.squaredNorm() - along * along / square;
}

TEST(Rivals, AreComparedByLogLikelihoodTheLikeliestFirst) {
  const Bench bench({1, 0.02});
  const Model accepted = fit(bench.problem, on_T1.model(0.9)).model;
  const auto others = rivals_of(bench, accepted, 0, {&on_T2, &on_T1, &on_both, &nearly_on_T1});
  ASSERT_EQ(others.size(), 3U);  // all but itself
  EXPECT_EQ(others[0].name, "nearly_on_T1");
  EXPECT_EQ(others[1].name, "on_both");
  EXPECT_EQ(others[2].name, "on_T2");
  const double now = misfit_with(bench, {1});
  const std::vector<Pattern> patterns{{1, 0.03}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    // Of 120 readings.
    const double deficit = 60 * std::log(misfit_with(bench, patterns[i]) / now);
    EXPECT_NEAR(others[i].deficit, deficit, 0.01 + 1e-3 * deficit) << others[i].name;
  }
  EXPECT_LT(others[0].deficit, alias_margin);
  EXPECT_GT(others[1].deficit, alias_margin);
}

TEST(Rivals, ThatExplainMoreHaveANegativeDeficit) {
  const Bench bench({1, 1});
  const Model accepted = fit(bench.problem, on_T1.model(0.9)).model;
  const auto others = rivals_of(bench, accepted, 0, {&on_T1, &on_both});
  ASSERT_EQ(others.size(), 1U);
  EXPECT_LT(others[0].deficit, -100);
}

// Has a size of its own for each of two strands.
class TwoSizes final : public MadeUpCause {
 public:
  TwoSizes() : MadeUpCause("two_sizes", Reach::reading, {-20, 20}) {}
  std::vector<Parameter> parameters(const Hardware& hardware) const override {
    Parameter first = MadeUpCause::parameters(hardware).front();
    Parameter second = first;
    second.range = {0.01, 20};
    return {first, second};
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    const auto strand = static_cast<std::size_t>(segment.number) - 1;
    return tension_N + (strand < 2 ? effect.values[strand] : 0);
  }
};

// What bends to the same can explain no less, and is no rival for that: ln(120) / 2 = 2.4 of its
// deficit are for the parameter.
TEST(Rivals, PayForFurtherParameters) {
  const Bench bench({1, 0.3});
  const Model accepted = fit(bench.problem, on_T1.model(0.9)).model;
  const TwoSizes two_sizes;
  Workers workers(1);
  const Candidate candidate{{&two_sizes, {}, {0, 0.3}}, two_sizes.parameters({}), "two_sizes"};
  const auto others = rivals(bench.problem, accepted, 0, {candidate}, workers);
  ASSERT_EQ(others.size(), 1U);
  const double none = residuals(bench.problem, forecast(bench.dataset, {})).squaredNorm();
  const double first = misfit_with(bench, {1});
  const double both = first + misfit_with(bench, {0, 1}) - none;
  EXPECT_NEAR(others[0].deficit, 60 * std::log(both / first) + std::log(120) / 2, 1e-3);
}

TEST(Rivals, StandBesideTheOtherAcceptedCauses) {
  const Bench bench({1, 0.5});
  Model model = on_T1.model(1);
  add_effect(model, on_T2.model(0.5).effects[0]);
  model = fit(bench.problem, model).model;
  const auto others = rivals_of(bench, model, 0, {&on_T1, &on_T2, &on_both});
  ASSERT_EQ(others.size(), 1U);  // not on_T2, which the model has already
  EXPECT_EQ(others[0].name, "on_both");
  EXPECT_NEAR(others[0].deficit, 0, 0.01);  // 1 on both and -0.5 on T2
  EXPECT_EQ(others[0].fit.model.effects.size(), 2U);
}

}  // namespace
}  // namespace reeve::testing
