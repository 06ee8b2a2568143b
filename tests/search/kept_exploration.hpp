// An exploration of several batches, and whether another one came to the same.
#pragma once

#include <gtest/gtest.h>

#include "search/explore.hpp"
#include "tests/search/generated.hpp"

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

inline void expect_same(const ExploreResult& a, const ExploreResult& b) {
  EXPECT_EQ(a.generated, b.generated);
  EXPECT_EQ(a.evaluated, b.evaluated);
  EXPECT_EQ(a.unconverged, b.unconverged);
  for (std::size_t i = 0; i < b.rejected.size(); ++i) {
    EXPECT_EQ(a.rejected[i].count, b.rejected[i].count);
  }
  EXPECT_EQ(a.references[0].dominated_by, b.references[0].dominated_by);
  EXPECT_EQ(a.references[0].generated, b.references[0].generated);
  ASSERT_EQ(a.top.size(), b.top.size());
  for (std::size_t i = 0; i < b.top.size(); ++i) {
    EXPECT_EQ(a.top[i].design.word, b.top[i].design.word);
    EXPECT_EQ(a.top[i].design.values, b.top[i].design.values);
  }
  ASSERT_EQ(a.sample.size(), b.sample.size());
  for (std::size_t i = 0; i < b.sample.size(); ++i) EXPECT_EQ(a.sample[i].word, b.sample[i].word);
  EXPECT_EQ(a.front_equals_left_out, b.front_equals_left_out);
}

}  // namespace reeve::testing
