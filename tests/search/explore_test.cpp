#include "search/explore.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/judge/evaluation.hpp"
#include "search/judge/pareto.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using Objectives = std::vector<Objective>;

const Objectives both{Objective::uniformity_mean, Objective::efficiency_mean};

const std::vector<Objectives>& several_objectives() {
  static const std::vector<Objectives> all{
      both,
      {Objective::uniformity_worst},
      {Objective::sheaths},
      {Objective::uniformity_worst, Objective::sheaths},
      {Objective::efficiency_mean, Objective::return_friction, Objective::travel},
      {Objective::uniformity_mean, Objective::efficiency_mean, Objective::jams, Objective::pulleys,
       Objective::force_transmission}};
  return all;
}

ExploreOptions options_for(const PartSet& parts, int fingers, const Objectives& objectives = both) {
  ExploreOptions options;
  options.generator = {parts, fingers, FingerIdentity::identical, false};
  options.grasps = single_grasps(fingers);
  options.order = objectives;
  options.threads = 1;
  return options;
}

// More than one batch: 3402 routings of 4 fingers would be evaluated at once.
ExploreOptions several_batches() {
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

bool admitted(const ExploreOptions& options, const ObjectiveValues& values, Naive& naive) {
  for (std::size_t c = 0; c < options.constraints.size(); ++c) {
    if (options.constraints[c].admits(values)) continue;
    ++naive.failed[c];
    return false;
  }
  return true;
}

Naive naive_program(const ExploreOptions& options, std::uint64_t limit = UINT64_MAX) {
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

// Fronts of two objectives by one sweep from great to small; rank() would compare all pairs.
std::vector<RankedDesign> ranked_by_sweep(const std::vector<Design>& designs,
                                          const Objectives& objectives) {
  struct Point {
    double x, y;
    const Design* design;
  };
  std::vector<Point> points;
  for (const Design& design : designs) {
    const Goodness worth = goodness(design.values, objectives);
    points.push_back({worth[0], worth[1], &design});
  }
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x > b.x : a.y > b.y; });
  std::vector<Point> highest;  // of each front; of several, the one with the greatest x
  std::vector<RankedDesign> ranked;
  for (const Point& point : points) {
    const auto front = std::find_if(highest.begin(), highest.end(), [&](const Point& h) {
      return h.y < point.y || (h.y == point.y && h.x == point.x);
    });
    const auto number = static_cast<int>(front - highest.begin()) + 1;
    if (front == highest.end()) {
      highest.push_back(point);
    } else if (front->y < point.y) {
      *front = point;
    }
    ranked.push_back({*point.design, number, 0});
  }
  std::sort(ranked.begin(), ranked.end(), [](const RankedDesign& a, const RankedDesign& b) {
    return a.front != b.front ? a.front < b.front : precedes_within_front(a.design, b.design);
  });
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i].rank = i + 1;
  return ranked;
}

void expect_same(const RankedDesign& design, const RankedDesign& expected) {
  ASSERT_EQ(design.design.word, expected.design.word);
  ASSERT_EQ(design.design.values, expected.design.values);
  ASSERT_EQ(design.front, expected.front);
  ASSERT_EQ(design.rank, expected.rank);
}

void expect_top(const ExploreResult& result, const std::vector<RankedDesign>& expected,
                std::size_t top) {
  ASSERT_EQ(result.top.size(), std::min(top, expected.size()));
  for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], expected[i]);
}

std::size_t front_size(const std::vector<RankedDesign>& ranked) {
  return static_cast<std::size_t>(std::count_if(
      ranked.begin(), ranked.end(), [](const RankedDesign& entry) { return entry.front == 1; }));
}

std::uint64_t rejections(const ExploreResult& result) {
  return std::accumulate(result.rejected.begin(), result.rejected.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Rejection& r) { return sum + r.count; });
}

void expect_naive_result(const ExploreOptions& options) {
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.total, naive.generated);
  EXPECT_EQ(result.generated, naive.generated);
  EXPECT_EQ(result.evaluated, naive.generated - naive.not_actuated);
  EXPECT_EQ(rejections(result) + naive.kept.size(), naive.generated);
  EXPECT_FALSE(result.partial);
  const std::vector<RankedDesign> expected = rank(naive.kept, options.order);
  expect_top(result, expected, options.top);
  EXPECT_EQ(result.front.size() + result.front_equals_left_out, front_size(expected));
  for (const RankedDesign& entry : result.front) EXPECT_EQ(entry.front, 1);
}

void expect_equal_results(const ExploreResult& a, const ExploreResult& b) {
  EXPECT_EQ(a.total, b.total);
  EXPECT_EQ(a.generated, b.generated);
  EXPECT_EQ(a.evaluated, b.evaluated);
  EXPECT_EQ(a.partial, b.partial);
  EXPECT_EQ(a.front_equals_left_out, b.front_equals_left_out);
  ASSERT_EQ(a.rejected.size(), b.rejected.size());
  for (std::size_t i = 0; i < a.rejected.size(); ++i) {
    EXPECT_EQ(a.rejected[i].reason, b.rejected[i].reason);
    EXPECT_EQ(a.rejected[i].count, b.rejected[i].count);
  }
  ASSERT_EQ(a.top.size(), b.top.size());
  for (std::size_t i = 0; i < a.top.size(); ++i) expect_same(a.top[i], b.top[i]);
  ASSERT_EQ(a.front.size(), b.front.size());
  for (std::size_t i = 0; i < a.front.size(); ++i) expect_same(a.front[i], b.front[i]);
  ASSERT_EQ(a.references.size(), b.references.size());
  for (std::size_t i = 0; i < a.references.size(); ++i) {
    EXPECT_EQ(a.references[i].dominated_by, b.references[i].dominated_by);
    EXPECT_EQ(a.references[i].rank, b.references[i].rank);
    EXPECT_EQ(a.references[i].front, b.references[i].front);
    EXPECT_EQ(a.references[i].design.values, b.references[i].design.values);
  }
}

TEST(Explore, AgreesWithANaiveProgram) {
  for (const int fingers : {2, 3}) {
    for (const PartSet& parts : {full_parts(), paper_parts()}) {
      for (const Objectives& objectives : several_objectives()) {
        for (const std::size_t top : {1U, 10U, 1000U}) {
          SCOPED_TRACE(std::to_string(fingers) + " fingers, " + tips_text(parts) + ", " +
                       std::to_string(objectives.size()) + " objectives, top " +
                       std::to_string(top));
          ExploreOptions options = options_for(parts, fingers, objectives);
          options.top = top;
          expect_naive_result(options);
        }
      }
    }
  }
}

TEST(Explore, AgreesWithANaiveProgramOnDistinctFingersAndOnOneTendon) {
  ExploreOptions options = options_for(paper_parts(), 3);
  options.generator.identity = FingerIdentity::distinct;
  options.model.hardware.fingers.push_back({2, 0.3, {}, 0.1, {}, {}, 2});
  expect_naive_result(options);
  options = options_for(full_parts(), 3);
  options.generator.one_tendon = true;
  expect_naive_result(options);
}

TEST(Explore, AgreesWithANaiveProgramOverSeveralBatches) {
  const ExploreOptions options = several_batches();
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  ASSERT_GT(result.evaluated, 20000U);
  const std::vector<RankedDesign> expected = ranked_by_sweep(naive.kept, options.order.objectives);
  expect_top(result, expected, options.top);
  EXPECT_EQ(result.front.size() + result.front_equals_left_out, front_size(expected));
  EXPECT_EQ(result.generated, naive.generated);
  EXPECT_EQ(result.evaluated, naive.kept.size());
}

TEST(Explore, FindsTheSevenRoutingsOfThePaper) {
  ExploreOptions options = options_for(paper_parts(), 2);
  options.generator.one_tendon = true;
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.top.size(), 7U);
  EXPECT_EQ(result.top.front().design.word, "1-P-2-P-1");
  EXPECT_EQ(result.front.size(), 1U);
}

TEST(ExploreThreads, DoNotChangeTheResult) {
  ExploreOptions options = options_for(full_parts(), 3, several_objectives()[3]);
  options.top = 15;
  options.constraints = {parse_constraint("jams==0"), parse_constraint("sheaths<=4")};
  options.references = {parse_routing("1-P-2-P-3-P-1"), parse_routing("M-1-T-2-T-3-F")};
  const ExploreResult one = explore(options);
  for (const int threads : {2, 3, 8}) {
    SCOPED_TRACE(threads);
    options.threads = threads;
    expect_equal_results(explore(options), one);
  }
}

TEST(ExploreThreads, DoNotChangeTheResultOfSeveralBatches) {
  ExploreOptions options = several_batches();
  options.references = {parse_routing("M-1-T-2-T-3-T-4-T-5-F")};
  const ExploreResult one = explore(options);
  for (const int threads : {2, 3, 8}) {
    SCOPED_TRACE(threads);
    options.threads = threads;
    expect_equal_results(explore(options), one);
  }
}

TEST(Explore, RefusesHardwareThatCannotBe) {
  ExploreOptions options = options_for(full_parts(), 2);
  options.model.hardware.sheath.mu = -1;
  EXPECT_THROW(explore(options), InputError);
}

TEST(ExploreShards, TogetherAreTheWhole) {
  ExploreOptions options = options_for(full_parts(), 3);
  options.top = 12;
  options.constraints = {parse_constraint("jams==0")};
  const ExploreResult whole = explore(options);
  for (const std::uint64_t count : {1U, 2U, 3U, 7U, 50U}) {
    std::uint64_t total = 0;
    std::uint64_t generated = 0;
    std::uint64_t evaluated = 0;
    std::vector<std::uint64_t> rejected(whole.rejected.size(), 0);
    std::set<std::string> tops;
    for (std::uint64_t index = 1; index <= count; ++index) {
      options.shard = {index, count};
      const ExploreResult part = explore(options);
      EXPECT_FALSE(part.partial) << index << " of " << count;
      total += part.total;
      generated += part.generated;
      evaluated += part.evaluated;
      for (std::size_t r = 0; r < rejected.size(); ++r) rejected[r] += part.rejected[r].count;
      for (const RankedDesign& entry : part.top) tops.insert(entry.design.word);
    }
    EXPECT_EQ(total, whole.total);
    EXPECT_EQ(generated, whole.generated);
    EXPECT_EQ(evaluated, whole.evaluated);
    for (std::size_t r = 0; r < rejected.size(); ++r)
      EXPECT_EQ(rejected[r], whole.rejected[r].count);
    for (const RankedDesign& entry : whole.top) {
      EXPECT_EQ(tops.count(entry.design.word), 1U) << entry.design.word << " of " << count;
    }
  }
}

TEST(ExploreShards, MayBeEmpty) {
  ExploreOptions options = options_for(paper_parts(), 1);
  options.shard = {1, 1000};
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.total, 0U);
  EXPECT_EQ(result.evaluated, 0U);
  EXPECT_FALSE(result.partial);
  EXPECT_TRUE(result.top.empty());
  EXPECT_TRUE(result.front.empty());
}

TEST(ExploreConstraints, CountWhatTheyRejectByTheFirstThatFails) {
  ExploreOptions options = options_for(full_parts(), 3);
  options.top = 100000;
  options.constraints = {parse_constraint("jams==0"), parse_constraint("sheaths<=2"),
                         parse_constraint("efficiency>=0.2")};
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  ASSERT_EQ(result.rejected.size(), 4U);
  EXPECT_EQ(result.rejected[0].reason, "not actuated");
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  const std::vector<std::string> texts{"jams==0", "sheaths<=2", "efficiency>=0.2"};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(result.rejected[c + 1].reason, "constraint " + texts[c]);
    EXPECT_EQ(result.rejected[c + 1].count, naive.failed[c]);
    EXPECT_GT(naive.failed[c], 0U);
  }
  EXPECT_EQ(result.generated, rejections(result) + result.top.size());
  EXPECT_EQ(result.top.size(), naive.kept.size());
  expect_naive_result(options);
}

TEST(ExploreConstraints, MayLeaveNothing) {
  ExploreOptions options = options_for(full_parts(), 2);
  options.constraints = {parse_constraint("uniformity>1")};
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.evaluated, 54U);
  EXPECT_EQ(rejections(result), result.generated);
  EXPECT_TRUE(result.top.empty() && result.front.empty());
}

TEST(Explore, StoppedItIsPartialAndTrueToWhatItSaw) {
  const ExploreOptions options = several_batches();
  const std::atomic<bool> stop{true};
  Supervision supervision;
  supervision.stop = &stop;
  const ExploreResult result = explore(options, supervision);
  EXPECT_TRUE(result.partial);
  EXPECT_GT(result.generated, 0U);
  EXPECT_LT(result.generated, result.total);
  EXPECT_EQ(result.evaluated + rejections(result), result.generated);
  const Naive naive = naive_program(options, result.generated);
  EXPECT_EQ(result.evaluated, naive.kept.size());
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  expect_top(result, ranked_by_sweep(naive.kept, options.order.objectives), options.top);
}

TEST(Explore, ToldNotToStopItFinishes) {
  const std::atomic<bool> stop{false};
  Supervision supervision;
  supervision.stop = &stop;
  const ExploreResult result = explore(options_for(full_parts(), 2), supervision);
  EXPECT_FALSE(result.partial);
  EXPECT_EQ(result.generated, result.total);
}

TEST(Explore, ToldToStopWhenAllIsDoneItIsWhole) {
  const std::atomic<bool> stop{true};
  Supervision supervision;
  supervision.stop = &stop;
  const ExploreResult result = explore(options_for(full_parts(), 2), supervision);
  EXPECT_FALSE(result.partial);
  EXPECT_EQ(result.generated, result.total);
}

TEST(Explore, ProgressGrowsToTheTotal) {
  std::vector<Progress> heard;
  Supervision supervision;
  supervision.report = [&](const Progress& progress) { heard.push_back(progress); };
  const ExploreResult result = explore(several_batches(), supervision);
  ASSERT_GE(heard.size(), 2U);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_EQ(heard[i].total, result.total);
    EXPECT_GT(heard[i].done, i == 0 ? 0 : heard[i - 1].done);
  }
  EXPECT_EQ(heard.back().done, result.total);
}

TEST(ExploreReferences, StandWhereTheNaiveRankingPutsThem) {
  for (const Objectives& objectives : several_objectives()) {
    ExploreOptions options = options_for(full_parts(), 3, objectives);
    options.top = 60;
    const Naive naive = naive_program(options);
    const std::vector<RankedDesign> ranked = rank(naive.kept, objectives);
    for (const std::size_t place : {0U, 1U, 59U, 60U, 200U, 425U}) {
      options.references.push_back(parse_routing(ranked[place].design.word));
    }
    const ExploreResult result = explore(options);
    ASSERT_EQ(result.references.size(), options.references.size());
    for (const ReferenceStanding& standing : result.references) {
      const auto entry = std::find_if(ranked.begin(), ranked.end(), [&](const RankedDesign& r) {
        return r.design.word == standing.design.word;
      });
      ASSERT_NE(entry, ranked.end());
      const Goodness own = goodness(standing.design.values, objectives);
      const auto dominators = std::count_if(ranked.begin(), ranked.end(), [&](const auto& other) {
        return dominates(goodness(other.design.values, objectives), own);
      });
      EXPECT_EQ(standing.design.values, entry->design.values);
      EXPECT_EQ(standing.dominated_by, static_cast<std::uint64_t>(dominators));
      const bool is_kept = entry->rank <= options.top || entry->front == 1;
      EXPECT_EQ(standing.rank, is_kept ? entry->rank : 0) << entry->rank;
      EXPECT_EQ(standing.front, is_kept ? entry->front : 0);
    }
  }
}

TEST(ExploreReferences, HaveTheirRankOnAFrontThatIsLongerThanTheList) {
  ExploreOptions options = options_for(full_parts(), 2,
                                       {Objective::uniformity_mean, Objective::efficiency_mean,
                                        Objective::sheaths, Objective::pulleys});
  options.top = 1;
  options.references = {parse_routing("M-1-T-2-F")};
  const ExploreResult result = explore(options);
  ASSERT_GT(result.front.size(), 1U);
  const auto entry = std::find_if(result.front.begin(), result.front.end(), [](const auto& ranked) {
    return ranked.design.word == "M-1-T-2-F";
  });
  ASSERT_NE(entry, result.front.end());
  EXPECT_EQ(result.references[0].rank, entry->rank);
  EXPECT_EQ(result.references[0].front, 1);
}

TEST(ExploreReferences, NeedNotBeAmongTheRoutings) {
  ExploreOptions options = options_for(paper_parts(), 2);
  options.references = {parse_routing("M-1b-B-2b-M"), parse_routing("1-P-2-P-1")};
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  const ReferenceStanding& stranger = result.references[0];
  EXPECT_EQ(stranger.rank, 0U);
  EXPECT_EQ(stranger.front, 0);
  EXPECT_EQ(stranger.design.values,
            DesignEvaluator(options.model, options.grasps).evaluate(options.references[0]));
  const Goodness own = goodness(stranger.design.values, both);
  const auto dominators = std::count_if(naive.kept.begin(), naive.kept.end(), [&](const Design& d) {
    return dominates(goodness(d.values, both), own);
  });
  EXPECT_EQ(stranger.dominated_by, static_cast<std::uint64_t>(dominators));
  EXPECT_EQ(result.references[1].rank, 1U);
  EXPECT_EQ(result.references[1].dominated_by, 0U);
}

TEST(ExploreReferences, ARejectedOneHasNoRank) {
  ExploreOptions options = options_for(paper_parts(), 2);
  options.constraints = {parse_constraint("sheaths<=2")};
  options.references = {parse_routing("1-P-2-P-1")};
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.references[0].rank, 0U);
  EXPECT_EQ(result.references[0].dominated_by, 0U);
  EXPECT_GT(value(result.references[0].design.values, Objective::uniformity_mean), 0.99);
}

TEST(ExploreReferences, ARejectedDesignDominatesNone) {
  ExploreOptions options = options_for(paper_parts(), 2);
  options.references = {parse_routing("M-1-T-2-F")};
  const std::uint64_t of_all = explore(options).references[0].dominated_by;
  options.constraints = {parse_constraint("sheaths<=1")};
  const ExploreResult result = explore(options);
  const Goodness own = goodness(result.references[0].design.values, both);
  const Naive naive = naive_program(options);
  const auto dominators = std::count_if(naive.kept.begin(), naive.kept.end(), [&](const Design& d) {
    return dominates(goodness(d.values, both), own);
  });
  EXPECT_EQ(result.references[0].dominated_by, static_cast<std::uint64_t>(dominators));
  EXPECT_LT(result.references[0].dominated_by, of_all);
}

TEST(ParseShard, ReadsPartAndNumberOfParts) {
  const Shard first = parse_shard("1/1");
  EXPECT_EQ(first.index, 1U);
  EXPECT_EQ(first.count, 1U);
  const Shard other = parse_shard("3/64");
  EXPECT_EQ(other.index, 3U);
  EXPECT_EQ(other.count, 64U);
}

TEST(ParseShardError, SaysWhatAShardIs) {
  for (const std::string text : {"3/2",
                                 "0/4",
                                 "a/b",
                                 "1/",
                                 "",
                                 "1/0",
                                 "-1/2",
                                 "1/2/3",
                                 "/",
                                 "/2",
                                 "1",
                                 "1/-2",
                                 "1/b",
                                 " 1/2",
                                 "1 /2",
                                 "1/2 ",
                                 "1.5/2",
                                 "+1/2",
                                 "0/0",
                                 "99999999999999999999/2",
                                 "1/99999999999999999999"}) {
    EXPECT_EQ(testing::input_error([&] { parse_shard(text); }),
              "shard '" + text + "': expected i/N with 1 <= i <= N, such as 2/8");
  }
}

}  // namespace
}  // namespace reeve
