// Explorations that found the same, whichever way they went.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "search/exploration_part.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {

inline std::vector<std::string> words_of(const std::vector<Design>& designs) {
  std::vector<std::string> words;
  for (const Design& design : designs) words.push_back(design.word);
  return words;
}

inline std::vector<std::string> sampled_words(const ShardRecord& record) {
  std::vector<std::string> words;
  for (const SampledWord& sampled : record.sample) {
    words.push_back(std::to_string(sampled.place) + " " + sampled.word);
  }
  return words;
}

inline std::vector<std::pair<double, std::string>> steps_of(const Tradeoff& tradeoff) {
  std::vector<std::pair<double, std::string>> steps;
  for (const TradeoffStep& step : tradeoff.steps)
    steps.emplace_back(step.at_most, step.design.word);
  return steps;
}

inline std::vector<std::string> choice_of(const Tradeoff& tradeoff) {
  if (!tradeoff.choice) return {};
  return {tradeoff.choice->without.word, tradeoff.choice->with.word};
}

inline void expect_same_counts(const ExploreResult& a, const ExploreResult& b) {
  EXPECT_EQ(a.total, b.total);
  EXPECT_EQ(a.generated, b.generated);
  EXPECT_EQ(a.evaluated, b.evaluated);
  EXPECT_EQ(a.without_tensions.count, b.without_tensions.count);
  EXPECT_EQ(a.without_tensions.example, b.without_tensions.example);
  EXPECT_EQ(a.why_without_tensions, b.why_without_tensions);
  EXPECT_EQ(a.pruned, b.pruned);
  EXPECT_EQ(a.partial, b.partial);
  EXPECT_EQ(a.front_equals_left_out, b.front_equals_left_out);
  ASSERT_EQ(a.rejected.size(), b.rejected.size());
  for (std::size_t i = 0; i < a.rejected.size(); ++i) {
    EXPECT_EQ(a.rejected[i].constraint, b.rejected[i].constraint) << i;
    EXPECT_EQ(a.rejected[i].count, b.rejected[i].count) << i;
  }
}

inline void expect_same_references(const ExploreResult& a, const ExploreResult& b) {
  ASSERT_EQ(a.references.size(), b.references.size());
  for (std::size_t r = 0; r < a.references.size(); ++r) {
    const ReferenceStanding& one = a.references[r];
    const ReferenceStanding& other = b.references[r];
    SCOPED_TRACE(one.design.word);
    EXPECT_EQ(one.design.values, other.design.values);
    EXPECT_EQ(one.dominated_by, other.dominated_by);
    EXPECT_EQ(one.rank, other.rank);
    EXPECT_EQ(one.front, other.front);
    EXPECT_EQ(one.generated, other.generated);
    EXPECT_EQ(one.rejected_by, other.rejected_by);
  }
}

inline void expect_same_infeasible(const ExploreResult& a, const ExploreResult& b) {
  ASSERT_EQ(a.infeasible.size(), b.infeasible.size());
  for (std::size_t c = 0; c < a.infeasible.size(); ++c) {
    EXPECT_EQ(a.infeasible[c].met, b.infeasible[c].met);
    EXPECT_EQ(a.infeasible[c].of_all.above, b.infeasible[c].of_all.above);
    EXPECT_EQ(a.infeasible[c].of_all.below, b.infeasible[c].of_all.below);
    EXPECT_EQ(a.infeasible[c].of_those_that_meet_the_others.above,
              b.infeasible[c].of_those_that_meet_the_others.above);
    EXPECT_EQ(a.infeasible[c].of_those_that_meet_the_others.below,
              b.infeasible[c].of_those_that_meet_the_others.below);
  }
}

inline void expect_same_result(const ExploreResult& a, const ExploreResult& b) {
  expect_same_counts(a, b);
  ASSERT_EQ(a.top.size(), b.top.size());
  for (std::size_t i = 0; i < a.top.size(); ++i) expect_same(a.top[i], b.top[i]);
  ASSERT_EQ(a.front.size(), b.front.size());
  for (std::size_t i = 0; i < a.front.size(); ++i) expect_same(a.front[i], b.front[i]);
  ASSERT_EQ(words_of(a.sample), words_of(b.sample));
  for (std::size_t i = 0; i < a.sample.size(); ++i) {
    EXPECT_EQ(a.sample[i].values, b.sample[i].values) << a.sample[i].word;
  }
  EXPECT_EQ(steps_of(a.tradeoff), steps_of(b.tradeoff));
  EXPECT_EQ(choice_of(a.tradeoff), choice_of(b.tradeoff));
  expect_same_references(a, b);
  expect_same_infeasible(a, b);
  ASSERT_EQ(a.record.has_value(), b.record.has_value());
  if (!a.record) return;
  EXPECT_EQ(sampled_words(*a.record), sampled_words(*b.record));
  EXPECT_EQ(a.record->steps, b.record->steps);
  EXPECT_EQ(a.record->constraint_failures, b.record->constraint_failures);
  ASSERT_EQ(a.record->archive.size(), b.record->archive.size());
}

}  // namespace reeve::testing
