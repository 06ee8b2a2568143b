// Explorations small enough for a naive program to do the same.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/explore.hpp"

namespace reeve::testing {

using Objectives = std::vector<Objective>;

inline const Objectives both{Objective::uniformity_mean, Objective::efficiency_mean};

inline const std::vector<Objectives>& several_objectives() {
  static const std::vector<Objectives> all{
      both,
      {Objective::uniformity_worst},
      {Objective::sheaths},
      {Objective::uniformity_worst, Objective::sheaths},
      {Objective::efficiency_mean, Objective::round_trip_efficiency, Objective::travel},
      {Objective::uniformity_mean, Objective::efficiency_mean, Objective::jams, Objective::pulleys,
       Objective::force_transmission}};
  return all;
}

inline ExploreOptions options_for(const PartSet& parts, int fingers,
                                  const Objectives& objectives = both) {
  ExploreOptions options;
  options.generator = {parts, fingers, FingerIdentity::identical, false};
  options.grasps = single_grasps(fingers);
  options.order = objectives;
  options.threads = 1;
  return options;
}

// More than one batch: 3402 routings of 4 fingers would be evaluated at once.
inline ExploreOptions several_batches() {
  ExploreOptions options = options_for(full_parts(), 5);
  options.top = 20;
  return options;
}

// Everything that exploring does, without thrift: the first `limit` routings.
struct Naive {
  std::uint64_t generated = 0;
  std::uint64_t not_actuated = 0;
  std::vector<std::uint64_t> failed;  // by constraint
  std::vector<Design> kept;
};

inline bool admitted(const ExploreOptions& options, const ObjectiveValues& values, Naive& naive) {
  for (std::size_t c = 0; c < options.constraints.size(); ++c) {
    if (options.constraints[c].admits(values)) continue;
    ++naive.failed[c];
    return false;
  }
  return true;
}

inline Naive naive_program(const ExploreOptions& options, std::uint64_t limit = UINT64_MAX) {
  Naive naive;
  naive.failed.assign(options.constraints.size(), 0);
  RoutingGenerator generator(options.generator);
  DesignEvaluator evaluator(options.model, options.grasps);
  for (Routing routing; naive.generated < limit && generator.next(routing);) {
    ++naive.generated;
    if (!is_actuated(routing)) {
      ++naive.not_actuated;
      continue;
    }
    const ObjectiveValues values = evaluator.evaluate(routing);
    if (admitted(options, values, naive)) naive.kept.push_back({to_word(routing), values});
  }
  return naive;
}

inline std::uint64_t rejections(const ExploreResult& result) {
  return std::accumulate(result.rejected.begin(), result.rejected.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Rejection& r) { return sum + r.count; });
}

inline void expect_same(const RankedDesign& design, const RankedDesign& expected) {
  ASSERT_EQ(design.design.word, expected.design.word);
  ASSERT_EQ(design.design.values, expected.design.values);
  ASSERT_EQ(design.front, expected.front);
  ASSERT_EQ(design.rank, expected.rank);
}

}  // namespace reeve::testing
