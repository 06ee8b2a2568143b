// Limits on parts, against a look at every routing.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/network.hpp"
#include "core/performance.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/limits/limited_counts.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

// By the parts of the routing's network.
std::size_t looked_up_verdict(const Routing& routing, const std::vector<Constraint>& constraints) {
  if (!is_actuated(routing)) return not_actuated;
  DesignOutcome outcome;
  Network network;
  expand(routing, network);
  outcome.parts = parts(network);
  ObjectiveValues values{};
  for (const Constraint& constraint : constraints) {
    value(values, constraint.objective) = row(constraint.objective).compute(outcome);
  }
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (!constraints[c].admits(values)) return failing(c);
  }
  return within_limits;
}

// Everything that there is, in its order.
struct All {
  std::vector<Routing> routings;
  std::vector<std::size_t> verdicts;
};

All everything(const GeneratorOptions& options, const std::vector<Constraint>& constraints) {
  All all;
  for_each_generated(options, [&](const Routing& routing) {
    all.routings.push_back(routing);
    all.verdicts.push_back(looked_up_verdict(routing, constraints));
  });
  return all;
}

std::vector<std::uint64_t> tally(const All& all, std::size_t verdicts, std::uint64_t end) {
  std::vector<std::uint64_t> counts(verdicts, 0);
  for (std::size_t i = 0; i < end; ++i) ++counts[all.verdicts[i]];
  return counts;
}

void expect_from(RoutingGenerator& limited, const All& all, std::uint64_t begin) {
  limited.seek(begin);
  Routing routing;
  std::uint64_t place = 0;
  for (std::size_t i = begin; i < all.routings.size(); ++i) {
    if (all.verdicts[i] != within_limits) continue;
    ASSERT_TRUE(limited.next(routing, place)) << "from " << begin << " to " << i;
    ASSERT_EQ(place, i) << "from " << begin;
    ASSERT_EQ(to_word(routing), to_word(all.routings[i]));
    ASSERT_EQ(routing, all.routings[i]);
  }
  EXPECT_FALSE(limited.next(routing, place));
  EXPECT_FALSE(limited.next(routing, place));
}

void expect_all(const GeneratorOptions& options, const std::vector<std::string>& texts,
                std::uint64_t seeks = 12) {
  SCOPED_TRACE(label_of(options) + ": " + (texts.empty() ? "" : texts.front()) +
               (texts.size() > 1 ? " " + texts[1] : ""));
  const std::vector<Constraint> constraints = constraints_of(texts);
  const All all = everything(options, constraints);
  RoutingGenerator limited(options, {constraints, options});
  ASSERT_EQ(limited.total(), all.routings.size());
  expect_from(limited, all, 0);
  const std::uint64_t n = all.routings.size();
  for (std::uint64_t s = 0; s <= seeks; ++s) {
    const std::uint64_t place = n * s / seeks;
    ASSERT_EQ(limited.verdicts_before(place), tally(all, constraints.size() + 2, place)) << place;
    if (place < n) {
      ASSERT_EQ(limited.place_of(all.routings[place]), place) << to_word(all.routings[place]);
    }
    expect_from(limited, all, place);
  }
}

TEST(LimitedGenerator, GivesOfOneOrMoreTendonsThoseWithinTheLimits) {
  for (const int fingers : {1, 2, 3, 4}) {
    for (const PartSet& parts : {paper_parts(), full_parts(), anchored(full_parts())}) {
      for (const bool one_tendon : {false, true}) {
        const GeneratorOptions options = generating(parts, fingers, identical, one_tendon);
        expect_all(options, {"sheaths<=2"});
        expect_all(options, {"pulleys>=3", "sheaths<3"});
        expect_all(options, {"parts==5"});
        expect_all(options, {"knots>0", "sheaths<=2"});
      }
    }
  }
}

TEST(LimitedGenerator, GivesOfOddPartsThoseWithinTheLimits) {
  for (const PartSet& parts : odd_parts()) {
    for (const int fingers : {1, 2, 4}) {
      expect_all(generating(parts, fingers, identical), {"sheaths<=2", "pulleys<=3"});
      expect_all(generating(with_blocks(anchored(parts), 2), fingers > 2 ? 3 : fingers, identical),
                 {"sheaths<=2", "pulleys<=3"});
    }
  }
}

TEST(LimitedGenerator, GivesOfFloatingBlocksThoseWithinTheLimits) {
  for (const int fingers : {1, 2, 3}) {
    for (const int blocks : {1, 2, 3}) {
      for (const bool one_tree : {false, true}) {
        const GeneratorOptions options =
            generating(with_blocks(anchored(paper_parts()), blocks), fingers, identical, one_tree);
        expect_all(options, {"sheaths<=2"});
        expect_all(options, {"blocks>=2", "sheaths==1"});
        expect_all(options, {"parts<=4"});
        expect_all(options, {"knots>=1", "pulleys<1"});
      }
    }
  }
  for (const PartSet& parts :
       {all_parts(), linked(all_parts()), in_series(all_parts()), barred(all_parts()),
        becketed(passed_twice(paper_parts())), becketed(barred(passed_twice(paper_parts())))}) {
    expect_all(generating(with_blocks(parts, 2), 3, identical), {"sheaths<=1", "pulleys<=2"});
  }
  for (const PartSet& parts : {anchored(paper_parts()), linked(anchored(paper_parts())),
                               in_series(anchored(parts_of("tube", "P", "M"))),
                               barred(linked(anchored(parts_of("tube", "P", "M"))))}) {
    expect_all(generating(with_blocks(parts, 4), 4, identical), {"sheaths<=1"}, 3);
  }
}

TEST(LimitedGenerator, KeepsToRandomLimits) {
  std::mt19937 random(7);
  const auto one_of = [&](const std::vector<std::string>& words) {
    return words[random() % words.size()];
  };
  for (int i = 0; i < 60; ++i) {
    std::vector<std::string> texts;
    for (std::uint64_t c = 1 + random() % 3; c > 0; --c) {
      texts.push_back(one_of({"sheaths", "pulleys", "knots", "blocks", "parts"}) +
                      one_of({"<=", ">=", "<", ">", "=="}) + std::to_string(random() % 7) +
                      one_of({"", ".5"}));
    }
    const int blocks = static_cast<int>(random() % 3);
    PartSet parts = random() % 2 == 0 ? full_parts() : paper_parts();
    parts.anchored = blocks > 0 || random() % 2 == 0;
    parts.blocks = blocks;
    const int fingers = 1 + static_cast<int>(random() % (blocks > 0 ? 3 : 4));
    const GeneratorOptions options = generating(parts, fingers, identical, random() % 4 == 0);
    if (decided_by_parts(constraints_of(texts), options) < texts.size()) continue;
    expect_all(options, texts, 5);
  }
}

// Of seven fingers there are more tendons through all of them than a list has. Where a search
// saves, or is stopped, or another one takes a piece, it must not begin at the first of them again.
TEST(LimitedGenerator, CountsAndSeeksFromWhereItHasBeen) {
  const GeneratorOptions options = generating(full_parts(), 7, identical);
  const std::vector<Constraint> constraints = constraints_of({"sheaths<=1"});
  const PartClasses classes(constraints, options);
  RoutingGenerator plain(options, classes), limited(options, classes);
  Routing routing;
  std::vector<std::uint64_t> places;
  plain.seek(0);
  for (std::uint64_t place = 0; plain.next(routing, place);) places.push_back(place);
  ASSERT_GT(places.size(), 4000U);
  ASSERT_GT(plain.steps(), 100000U);

  const std::uint64_t far = 1 << 15;
  const std::uint64_t of_walk = plain.steps();
  EXPECT_EQ(plain.verdicts_before(places.back())[within_limits], places.size() - 1);
  EXPECT_LT(plain.steps(), of_walk + far);

  limited.seek(0);
  std::uint64_t place = 0;
  std::uint64_t queries = 0;
  std::vector<std::vector<std::uint64_t>> counted;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_TRUE(limited.next(routing, place));
    if (i % 100 != 50) continue;
    // The one before: a search is a batch ahead of what it has put down.
    counted.push_back(limited.verdicts_before(places[i - 50]));
    EXPECT_EQ(counted.back()[within_limits], i - 50);
    ++queries;
  }
  EXPECT_LT(limited.steps(), of_walk + queries * far);
  const std::uint64_t before_seeks = limited.steps();
  for (std::size_t i = 50; i < places.size(); i += 500) {
    limited.seek(places[i]);
    ASSERT_TRUE(limited.next(routing, place));
    EXPECT_EQ(place, places[i]);
    RoutingGenerator other(options, classes);
    EXPECT_EQ(other.verdicts_before(places[i - 50]), counted[i / 100]);
  }
  EXPECT_LT(limited.steps(), before_seeks + (places.size() / 500 + 1) * far);
}

TEST(LimitedGenerator, StopsWithinAFewSteps) {
  const GeneratorOptions options{full_parts(), 9, FingerIdentity::identical, false};
  RoutingGenerator generator(options, {{}, options});
  const std::uint64_t before = generator.steps();
  const std::atomic<bool> stop = true;
  generator.stop_with(StopCheck(&stop));
  EXPECT_THROW(generator.seek(generator.total() / 10), WayStopped);
  EXPECT_THROW(generator.verdicts_before(generator.total() / 12), WayStopped);
  EXPECT_LE(generator.steps() - before, 4096U);
  RoutingGenerator all(options);
  all.stop_with(StopCheck(&stop));
  EXPECT_THROW(all.seek(all.total() / 10), WayStopped);
}

// By formula, against all routings, made and filtered.
LimitedCounts filtered(const All& all, std::size_t constraints) {
  const std::vector<std::uint64_t> tallied = tally(all, constraints + 2, all.routings.size());
  LimitedCounts counts{tallied[within_limits], 0, {tallied.begin() + failing(0), tallied.end()}};
  for (std::size_t i = 0; i < all.routings.size(); ++i) {
    const std::vector<std::size_t> tree_of = trees(all.routings[i]);
    const bool is_one_tree =
        std::all_of(tree_of.begin(), tree_of.end(), [](auto t) { return t == 0; });
    if (all.verdicts[i] == within_limits && is_one_tree) ++counts.one_tendon;
  }
  return counts;
}

TEST(LimitedCounts, AreThoseOfAllRoutingsFiltered) {
  for (const PartSet& parts : {paper_parts(), full_parts(), all_parts(),
                               linked(in_series(with_blocks(anchored(paper_parts()), 3))),
                               barred(in_series(with_blocks(anchored(paper_parts()), 2))),
                               becketed(passed_twice(with_blocks(anchored(paper_parts()), 2)))}) {
    for (int fingers = 1; fingers <= (parts.blocks > 0 ? 3 : 4); ++fingers) {
      const GeneratorOptions options{parts, fingers};
      for (const std::vector<std::string>& texts : {std::vector<std::string>{"sheaths<=2"},
                                                    {"pulleys>=2", "sheaths<3"},
                                                    {"knots<=0", "parts<=5"},
                                                    {"blocks>=1"},
                                                    {"sheaths==1"}}) {
        SCOPED_TRACE(texts.front() + " of " + std::to_string(fingers));
        const std::vector<Constraint> constraints = constraints_of(texts);
        const LimitedCounts counted = count_limited(options, constraints);
        const LimitedCounts expected =
            filtered(everything(options, constraints), constraints.size());
        EXPECT_EQ(counted.meeting, expected.meeting);
        EXPECT_EQ(counted.one_tendon, expected.one_tendon);
        EXPECT_EQ(counted.rejected, expected.rejected);
      }
    }
  }
}

TEST(LimitedCounts, RefuseWhatTheyCannotCount) {
  GeneratorOptions options{full_parts(), 3};
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=2", "uniformity>=0.5"})),
               InputError);
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=20", "pulleys<=20", "knots<=20"})),
               InputError);
  options.identity = FingerIdentity::distinct;
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=2"})), InputError);
}

}  // namespace
}  // namespace reeve::testing
