// Bounds on what begins alike, held against every routing that does.
#include "search/evaluate/routing_beginning.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/limits/limited_generator.hpp"

namespace reeve {
namespace {

const std::vector<Objective> bounded_objectives{
    Objective::uniformity_mean, Objective::uniformity_worst, Objective::efficiency_mean,
    Objective::efficiency_worst, Objective::sheaths};

struct Bound {
  ShardRange places;
  Estimate estimate;
};

Model with_mu(double mu) {
  Model model;
  model.hardware.tube.mu = model.hardware.sheath.mu = mu;
  return model;
}

// Returns how many routings were held against how many bounds each.
std::size_t compared(const GeneratorOptions& options, const Model& model, const GraspSet& grasps) {
  DecidingEvaluator bounding(model, grasps, authors_score(), std::nullopt, bounded_objectives);
  DesignEvaluator evaluator(model, grasps);
  const EvaluationScope scope = scope_for(bounded_objectives, authors_score());
  std::vector<Bound> bounds;
  LimitedGenerator generator(options, {});
  EXPECT_TRUE(generator.leave_out_unwanted(
      model.hardware, [&](const RoutingBeginning& beginning, const ShardRange& places) {
        const auto estimate = bounding.estimate(beginning);
        if (estimate) bounds.push_back({places, *estimate});
        return true;
      }));
  std::map<std::uint64_t, ObjectiveValues> values;
  generator.seek(0);
  Routing routing;
  std::uint64_t place = 0;
  while (generator.next(routing, place)) {
    values[place] = evaluator.evaluate(routing, scope);
  }
  std::size_t many = 0;
  for (const Bound& bound : bounds) {
    const auto end = values.lower_bound(bound.places.end);
    for (auto each = values.lower_bound(bound.places.begin); each != end; ++each, ++many) {
      for (std::size_t i = 0; i + 1 < bounded_objectives.size(); ++i) {
        EXPECT_LE(value(each->second, bounded_objectives[i]),
                  value(bound.estimate.at_best, bounded_objectives[i]))
            << row(bounded_objectives[i]).name << " at " << each->first;
      }
      EXPECT_GE(value(each->second, Objective::sheaths),
                value(bound.estimate.at_best, Objective::sheaths));
      if (::testing::Test::HasFailure()) return many;
    }
  }
  return many;
}

TEST(RoutingBeginning, BoundsEveryRoutingThatBeginsSo) {
  for (const double mu : {0.0, 0.05, 0.18, 0.6}) {
    EXPECT_GT(compared({full_parts(), 4}, with_mu(mu), single_grasps(4)), 1000U) << mu;
  }
  PartSet anchored = full_parts();
  anchored.anchored = true;
  EXPECT_GT(compared({anchored, 4}, {}, single_grasps(4)), 1000U);
  EXPECT_GT(compared({full_parts(), 5}, {}, single_grasps(5)), 1000U);
  EXPECT_GT(compared({full_parts(), 5}, {}, {{Grasp{0b1}, 1}, {Grasp{0b10000}, 2}}), 1000U);
}

// Routings behind the unwanted ones have the places that they would have otherwise.
TEST(RoutingBeginning, ThatIsUnwantedIsPassedOver) {
  const GeneratorOptions options{full_parts(), 5};
  LimitedGenerator all(options, {});
  LimitedGenerator some(options, {});
  const auto is_wanted = [](const ShardRange& places) { return places.begin % 3 != 0; };
  std::vector<ShardRange> unwanted;
  ASSERT_TRUE(some.leave_out_unwanted({}, [&](const RoutingBeginning&, const ShardRange& places) {
    if (!is_wanted(places)) unwanted.push_back(places);
    return is_wanted(places);
  }));
  all.seek(0);
  some.seek(0);
  Routing routing;
  Routing other;
  std::uint64_t place = 0;
  std::uint64_t of_other = 0;
  std::size_t left_out = 0;
  while (some.next(other, of_other)) {
    while (all.next(routing, place) && place < of_other) ++left_out;
    ASSERT_EQ(place, of_other);
    ASSERT_EQ(to_word(routing), to_word(other));
  }
  while (all.next(routing, place)) ++left_out;
  std::size_t expected = 0;
  all.seek(0);
  while (all.next(routing, place)) {
    for (const ShardRange& places : unwanted) {
      if (place >= places.begin && place < places.end) ++expected;
    }
  }
  EXPECT_EQ(left_out, expected);
  EXPECT_GT(left_out, 1000U);
}

}  // namespace
}  // namespace reeve
