#include "search/explore.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "search/rank/pareto.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

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
    return a.front != b.front ? a.front < b.front : precedes_within_front(a.design, b.design, {});
  });
  for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i].rank = i + 1;
  return ranked;
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

TEST(Explore, AgreesWithANaiveProgramOnTrees) {
  for (const PartSet& parts : {all_parts(), with_blocks(anchored(paper_parts()), 2)}) {
    for (const Objectives& objectives : several_objectives()) {
      ExploreOptions options = options_for(parts, 2, objectives);
      options.top = 20;
      expect_naive_result(options);
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

TEST(Explore, RefusesHardwareThatCannotBe) {
  ExploreOptions options = options_for(full_parts(), 2);
  options.model.hardware.sheath.mu = -1;
  EXPECT_THROW(explore(options), InputError);
}

TEST(ExploreConstraints, CountWhatTheyRejectByTheFirstThatFails) {
  ExploreOptions options = options_for(full_parts(), 3);
  options.top = 100000;
  options.constraints = {parse_constraint("jams==0"), parse_constraint("sheaths<=2"),
                         parse_constraint("efficiency>=0.2")};
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  ASSERT_EQ(result.rejected.size(), 4U);
  EXPECT_FALSE(result.rejected[0].constraint.has_value());
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(result.rejected[c + 1].constraint, c);
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
  const ExploreResult result = explore(options, {{}, &stop});
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
  const ExploreResult result = explore(options_for(full_parts(), 2), {{}, &stop});
  EXPECT_FALSE(result.partial);
  EXPECT_EQ(result.generated, result.total);
}

// Blocks behind the first that nobody worked on are taken off again, with what they said of the
// references; one thread's blocks are not worked on in order where there are several.
TEST(Explore, StoppedInTheMiddleOfABatchItCountsNothingBeyond) {
  ExploreOptions options = several_batches();
  options.generator.fingers = 6;
  options.grasps = single_grasps(6);
  options.threads = 3;
  options.references = {parse_routing("1-P-2-P-3-P-4-P-5-P-6-P-1"),
                        parse_routing("M-1-F+M-2-F+M-3-F+M-4-F+M-5-F+M-6-F"),
                        parse_routing("1b-B-2b-P-3b-B-4b-P-5b-B-6b-P-1b")};
  for (const int pause_ms : {5, 15, 30}) {
    std::atomic<bool> stop{false};
    Supervision supervision;
    supervision.stop = &stop;
    std::thread stopping([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
      stop = true;
    });
    const ExploreResult result = explore(options, supervision);
    stopping.join();
    ASSERT_TRUE(result.partial);
    const Naive naive = naive_program(options, result.generated);
    EXPECT_EQ(result.evaluated, naive.kept.size());
    EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
    expect_top(result, ranked_by_sweep(naive.kept, options.order.objectives), options.top);
    for (const ReferenceStanding& reference : result.references) {
      const Goodness own = goodness(reference.design.values, options.order.objectives);
      std::uint64_t dominators = 0;
      bool generated = false;
      for (const Design& design : naive.kept) {
        dominators += dominates(goodness(design.values, options.order.objectives), own) ? 1 : 0;
        generated |= design.word == reference.design.word;
      }
      EXPECT_EQ(reference.dominated_by, dominators) << reference.design.word;
      EXPECT_EQ(reference.generated, generated) << reference.design.word;
    }
  }
}

TEST(Explore, ToldToStopWhenAllIsDoneItIsWhole) {
  std::atomic<bool> stop{false};
  Supervision supervision;
  supervision.stop = &stop;
  supervision.report = [&](const Progress& progress) { stop = progress.done == progress.total; };
  const ExploreResult result = explore(options_for(full_parts(), 2), supervision);
  EXPECT_FALSE(result.partial);
  EXPECT_EQ(result.generated, result.total);
}

TEST(Explore, ProgressGrowsToTheTotal) {
  std::vector<Progress> heard;
  const ExploreResult result =
      explore(several_batches(), {[&](const Progress& progress) { heard.push_back(progress); }});
  ASSERT_GE(heard.size(), 2U);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_EQ(heard[i].total, result.total);
    EXPECT_GT(heard[i].done, i == 0 ? 0 : heard[i - 1].done);
  }
  EXPECT_EQ(heard.back().done, result.total);
}

}  // namespace
}  // namespace reeve::testing
