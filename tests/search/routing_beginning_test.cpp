// Bounds on what begins alike, held against every routing that does.
#include "search/evaluate/routing_beginning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/limits/limited_tendons.hpp"

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
  RoutingGenerator generator(options, {{}, options});
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

// Tendons without blocks, as a search lists those of at most 16384, or as it walks through more.
struct Listing {
  Listing(const GeneratorOptions& options, std::uint64_t longest)
      : classes({}, options),
        tendons(classes, options.parts, options.fingers, options.one_tendon, longest) {}

  PartClasses classes;
  LimitedTendons tendons;
};

// Routings behind the unwanted ones have the places that they would have otherwise.
void expect_passed_over(int fingers, std::uint64_t longest) {
  const GeneratorOptions options{full_parts(), fingers};
  Listing all(options, longest);
  Listing some(options, longest);
  const auto is_wanted = [](const ShardRange& places) { return places.begin % 3 != 0; };
  std::vector<ShardRange> unwanted;
  ASSERT_TRUE(
      some.tendons.leave_out_unwanted({}, [&](const RoutingBeginning&, const ShardRange& places) {
        if (!is_wanted(places)) unwanted.push_back(places);
        return is_wanted(places);
      }));
  all.tendons.seek(fingers, PartClasses::none, 0);
  some.tendons.seek(fingers, PartClasses::none, 0);
  Routing routing;
  Routing other;
  std::uint64_t place = 0;
  std::uint64_t of_other = 0;
  std::set<std::uint64_t> left_out;
  while (some.tendons.next(other, of_other)) {
    while (all.tendons.next(routing, place) && place < of_other) left_out.insert(place);
    ASSERT_EQ(place, of_other);
    ASSERT_EQ(to_word(routing), to_word(other));
  }
  while (all.tendons.next(routing, place)) left_out.insert(place);
  const auto is_unwanted = [&](std::uint64_t at) {
    return std::any_of(unwanted.begin(), unwanted.end(), [&](const ShardRange& places) {
      return at >= places.begin && at < places.end;
    });
  };
  all.tendons.seek(fingers, PartClasses::none, 0);
  while (all.tendons.next(routing, place)) {
    ASSERT_EQ(left_out.contains(place), is_unwanted(place)) << place;
  }
  EXPECT_GT(left_out.size(), 1000U);
  for (std::uint64_t at = 0; at <= all.tendons.total(fingers); at += 997) {
    ASSERT_EQ(some.tendons.counts_before(fingers, at), all.tendons.counts_before(fingers, at));
  }
}

TEST(RoutingBeginning, ThatIsUnwantedIsPassedOver) {
  expect_passed_over(5, ListedShapes::default_longest);
  expect_passed_over(5, 0);
  expect_passed_over(4, 40);
}

// From within what begins alike, too.
TEST(RoutingBeginning, ThatIsUnwantedIsPassedOverBehindAnyPlace) {
  const GeneratorOptions options{full_parts(), 4};
  Listing some(options, 0);
  ASSERT_TRUE(some.tendons.leave_out_unwanted(
      {}, [](const RoutingBeginning&, const ShardRange& places) { return places.begin % 2 == 0; }));
  Listing all(options, 0);
  Routing routing;
  Routing other;
  std::uint64_t place = 0;
  std::uint64_t of_other = 0;
  for (std::uint64_t from = 0; from < all.tendons.total(4); from += 13) {
    some.tendons.seek(4, PartClasses::none, from);
    for (int i = 0; i < 5 && some.tendons.next(other, of_other); ++i) {
      all.tendons.seek(4, PartClasses::none, of_other);
      ASSERT_TRUE(all.tendons.next(routing, place));
      ASSERT_EQ(place, of_other);
      ASSERT_EQ(to_word(routing), to_word(other));
    }
  }
}

}  // namespace
}  // namespace reeve
