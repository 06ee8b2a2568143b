#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "core/notation.hpp"
#include "search/exploration_part.hpp"
#include "search/explore.hpp"

namespace reeve {
namespace {

// A routing for each place below a million, told apart by the arms of a bar.
Routing numbered(std::uint64_t place) {
  const auto part = [](std::uint64_t value) { return static_cast<std::uint16_t>(value); };
  return {{{{bar(1, {part(place / 1000), part(place % 1000)})}}}};
}

std::uint64_t number(const Routing& routing) {
  const ArmRatio arms = routing.tendons.front().walk.front().arms;
  return std::uint64_t{1000} * arms.left + arms.right;
}

DesignSample of(std::size_t size, std::uint64_t begin, std::uint64_t end) {
  DesignSample sample(size);
  for (std::uint64_t place = begin; place < end; ++place) sample.add(place, numbered(place));
  return sample;
}

std::set<std::uint64_t> numbers(const DesignSample& sample) {
  std::set<std::uint64_t> numbers;
  for (const Routing& routing : sample.routings()) numbers.insert(number(routing));
  return numbers;
}

TEST(Sample, HoldsAllOfAFewInOrder) {
  const std::vector<Routing> routings = of(10, 3, 8).routings();
  ASSERT_EQ(routings.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(number(routings[i]), i + 3);
  EXPECT_TRUE(of(0, 0, 100).routings().empty());
}

// Each tenth of the places gives about a tenth of the sample: within five standard deviations.
TEST(Sample, IsSpreadEvenly) {
  std::map<std::uint64_t, int> tenths;
  for (const Routing& routing : of(2000, 0, 100000).routings()) {
    ++tenths[number(routing) / 10000];
  }
  ASSERT_EQ(tenths.size(), 10U);
  for (const auto& [tenth, count] : tenths) EXPECT_NEAR(count, 200, 67) << tenth;
}

TEST(Sample, OfThePartsHoldsThatOfTheWhole) {
  std::set<std::uint64_t> parts = numbers(of(50, 0, 777));
  parts.merge(numbers(of(50, 777, 5000)));
  const std::set<std::uint64_t> whole = numbers(of(50, 0, 5000));
  EXPECT_EQ(whole.size(), 50U);
  EXPECT_TRUE(std::includes(parts.begin(), parts.end(), whole.begin(), whole.end()));
}

ExploreOptions four_fingers() {
  ExploreOptions options;
  options.generator = {full_parts(), 4, FingerIdentity::identical, false};
  options.grasps = single_grasps(4);
  options.constraints = {parse_constraint("sheaths<=3")};
  options.top = 5;
  options.sample = 100;
  options.threads = 1;
  return options;
}

TEST(ExploreShards, HaveTheSampleOfTheWholeAmongTheirs) {
  ExploreOptions options = four_fingers();
  const std::vector<Design> whole = explore(options).sample;
  ASSERT_EQ(whole.size(), 100U);
  for (const std::uint64_t count : {2U, 5U}) {
    std::map<std::string, ObjectiveValues> parts;
    for (std::uint64_t index = 1; index <= count; ++index) {
      options.shard = {index, count};
      const std::vector<Design> part = explore(options).sample;
      for (const Design& design : part) parts[design.word] = design.values;
    }
    for (const Design& design : whole) {
      ASSERT_EQ(parts.count(design.word), 1U) << design.word << " of " << count;
      EXPECT_EQ(parts[design.word], design.values);
    }
  }
}

// Return friction too, which is computed only for what is kept.
TEST(Explore, SamplesWhatTheConstraintsAdmitWithAllValues) {
  ExploreOptions options = four_fingers();
  options.sample = 100000;
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.sample.size(), result.evaluated - result.rejected.at(1).count);
  ExploreOptions naive = options;
  naive.order = {Objective::round_trip_efficiency};
  naive.top = 100000;
  std::map<std::string, ObjectiveValues> expected;
  for (const RankedDesign& ranked : explore(naive).top) {
    expected[ranked.design.word] = ranked.design.values;
  }
  ASSERT_EQ(expected.size(), result.sample.size());
  for (const Design& design : result.sample) EXPECT_EQ(design.values, expected.at(design.word));
}

TEST(Sample, ForeseenKnowsWhichPlacesMayEnter) {
  constexpr std::uint64_t places = 2'000'000;
  DesignSample foreseen = of(2, 0, 100'000);
  Workers workers(2);
  foreseen.foresee({0, places}, workers, nullptr);
  const DesignSample looking = of(2, 0, 100'000);
  std::size_t may = 0;
  for (std::uint64_t begin = 0; begin < places; begin += 10'000) {
    const ShardRange range{begin, begin + 10'000};
    bool expected = false;
    for (std::uint64_t place = begin; place < range.end && !expected; ++place) {
      expected = looking.would_enter(place);
    }
    EXPECT_EQ(foreseen.may_have_one(range), expected) << begin;
    if (expected) ++may;
  }
  EXPECT_GT(may, 5U);
  EXPECT_LT(may, 150U);
}

}  // namespace
}  // namespace reeve
