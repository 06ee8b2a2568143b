// An exploration of several batches, and whether another one came to the same.
#pragma once

#include <gtest/gtest.h>

#include "search/explore.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/same_exploration.hpp"

namespace reeve::testing {

inline ExploreOptions kept_options(int threads) {
  ExploreOptions options;
  options.generator.fingers = 5;
  options.generator.parts = full_parts();
  options.grasps = single_grasps(5);
  options.top = 20;
  options.sample = 50;
  options.threads = threads;
  options.constraints = {parse_constraint("sheaths<=4"), parse_constraint("jams<=3")};
  options.references = {parse_routing("M-1-T-2-T-3-T-4-T-5-F")};
  options.keeps_record = true;
  return options;
}

// The number of solves included, and what else values tell.
inline void expect_same(const ExploreResult& a, const ExploreResult& b) {
  EXPECT_EQ(a.unconverged, b.unconverged);
  expect_same_result(a, b);
}

}  // namespace reeve::testing
