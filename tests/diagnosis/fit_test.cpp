#include "diagnosis/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "causes/library.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

// Reads x more on T1 for positive x, but never more than 1 N; for negative x, -x.
class TwoValleys final : public MadeUpCause {
 public:
  TwoValleys() : MadeUpCause("two_valleys", Reach::reading, {-5, 5}) {}

  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    if (segment.number != 1) return tension_N;
    const double x = effect.values[0];
    return tension_N + (x > 0 ? std::min(x, 1.0) : -x);
  }
};

Model with(const Cause& cause, double value) {
  Model model;
  add_effect(model, {&cause, {}, {value}});
  return model;
}

TEST(Fit, IsTheMeanForAnOffset) {
  const Bench bench({1});
  const Fit found = fit(bench.problem, on_T1.model(0.1));
  double mean = 0;
  for (std::size_t i = 0; i < bench.dataset.cells.size(); i += 4) {
    mean += (bench.dataset.cells[i].measured_N - forecast(bench.dataset, {}).reading_N[0]) / 30;
  }
  EXPECT_NEAR(found.model.effects[0].values[0], mean, 1e-5);
  EXPECT_NEAR(found.misfit, misfit(bench.problem, found.model), 1e-9);
  EXPECT_LT(found.misfit, 160);  // of 120 readings
}

TEST(Fit, OfAModelWithoutEffectsIsItsMisfit) {
  const Bench bench({1});
  EXPECT_EQ(fit(bench.problem, Model{}).misfit, misfit(bench.problem, {}));
}

// From 4 N it is nearer to the readings, and stuck: there is nothing to be seen downhill.
TEST(Fit, TakesTheBestOfTheTwoLikeliestStarts) {
  const TwoValleys cause;
  const Bench bench({3});
  const std::vector<std::vector<double>> starts{{4}, {-0.5}};
  EXPECT_GT(fit(bench.problem, with(cause, 4)).misfit, 10000);
  for (const bool reversed : {false, true}) {
    std::vector<std::vector<double>> order = starts;
    if (reversed) std::reverse(order.begin(), order.end());
    const Fit found = fit(bench.problem, with(cause, 0), 0, order);
    EXPECT_NEAR(found.model.effects[0].values[0], -3, 0.05);
    EXPECT_LT(found.misfit, 200);
  }
}

TEST(Fit, StaysWithinTheRangeOfTheParameter) {
  const PatternCause small("small", {1}, {0, 0.2});
  const Bench bench({1});
  EXPECT_NEAR(fit(bench.problem, small.model(0.1)).model.effects[0].values[0], 0.2, 1e-9);
}

TEST(Extended, PutsAnEffectInItsPlaceAndTakesItOutAgain) {
  const Model tubes = extended({}, {find_cause("tube_friction"), {}, {0.1}}).model;
  const Extended both = extended(tubes, {find_cause("sheath_friction"), {}, {0.2}});
  EXPECT_EQ(both.effect, 1U);
  EXPECT_EQ(place(both.model, tubes.effects[0]), 0U);
  const Model left = without(both.model, 0);
  ASSERT_EQ(left.effects.size(), 1U);
  EXPECT_EQ(effect_name(left.effects[0]), "sheath_friction");
}

}  // namespace
}  // namespace reeve::testing
