// Constraints on parts: what an exploration finds that does not make what they reject is what one
// finds that makes and evaluates everything.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "causes/library.hpp"
#include "search/exploration_part.hpp"
#include "search/routing_source.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"
#include "tests/search/same_exploration.hpp"

namespace reeve::testing {
namespace {

// Who asks for every design gets every design.
ExploreResult filtered(const ExploreOptions& options) {
  Checkpoint checkpoint;
  std::uint64_t designs = 0;
  checkpoint.design = [&](const EvaluatedDesign&) { ++designs; };
  ExploreResult result = explore(options, {}, checkpoint);
  EXPECT_EQ(designs, result.evaluated);
  return result;
}

ExploreOptions pruned_options(const PartSet& parts, int fingers) {
  ExploreOptions options = options_for(parts, fingers);
  options.top = 15;
  options.sample = 20;
  options.keeps_record = true;
  const RoutingGenerator all(options.generator);
  RoutingGenerator generator(options.generator);
  Routing routing;
  for (const std::uint64_t part : {2U, 5U, 8U, 9U}) {
    generator.seek(all.total() * part / 10);
    while (generator.next(routing) && !is_actuated(routing)) {
    }
    if (is_actuated(routing)) options.references.push_back(routing);
  }
  return options;
}

TEST(ExplorePruning, FindsWhatFilteringFinds) {
  for (const std::vector<std::string>& texts :
       std::vector<std::vector<std::string>>{{"sheaths<=2"},
                                             {"pulleys>=2", "sheaths<4"},
                                             {"parts==5", "uniformity>=0.2"},
                                             {"knots<1", "jams==0", "sheaths<=3"},
                                             {"sheaths<=1", "uniformity>=0.9999"},
                                             {"sheaths<=0"}}) {
    SCOPED_TRACE(texts.front());
    for (const int fingers : {2, 3}) {
      ExploreOptions options = pruned_options(full_parts(), fingers);
      options.constraints = constraints_of(texts);
      expect_same_result(explore(options), filtered(options));
      options.generator.one_tendon = true;
      expect_same_result(explore(options), filtered(options));
    }
    ExploreOptions options = pruned_options(with_blocks(anchored(paper_parts()), 2), 3);
    options.constraints = constraints_of(texts);
    expect_same_result(explore(options), filtered(options));
  }
}

TEST(ExplorePruning, FindsWhatANaiveProgramFinds) {
  ExploreOptions options = pruned_options(full_parts(), 3);
  options.constraints = constraints_of({"sheaths<=3", "pulleys>=2", "efficiency>=0.1"});
  ASSERT_EQ(pruning_constraints(options), 2U);
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.generated, naive.generated);
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(result.rejected[c + 1].count, naive.failed[c]);
  EXPECT_EQ(result.pruned, naive.failed[0] + naive.failed[1]);
  EXPECT_EQ(result.evaluated, naive.generated - naive.not_actuated);
  const std::vector<RankedDesign> expected = rank(naive.kept, options.order);
  ASSERT_EQ(result.top.size(), options.top);
  for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], expected[i]);
}

TEST(ExplorePruning, FindsWhatFilteringFindsUnderRandomConstraints) {
  std::mt19937 random(11);
  const auto one_of = [&](const std::vector<std::string>& words) {
    return words[random() % words.size()];
  };
  for (int i = 0; i < 40; ++i) {
    const bool blocks = random() % 2 == 0;
    ExploreOptions options = pruned_options(
        blocks ? with_blocks(anchored(paper_parts()), 1 + static_cast<int>(random() % 2))
               : full_parts(),
        2 + static_cast<int>(random() % 2));
    std::vector<std::string> texts;
    for (std::uint64_t c = 1 + random() % 3; c > 0; --c) {
      const std::string objective =
          one_of({"sheaths", "pulleys", "knots", "blocks", "parts", "uniformity", "travel"});
      texts.push_back(objective + one_of({"<=", ">=", "<", ">", "=="}) +
                      (objective == "uniformity" ? "0.5" : std::to_string(random() % 6)));
    }
    options.constraints = constraints_of(texts);
    SCOPED_TRACE(texts.front() + (texts.size() > 1 ? " " + texts[1] : "") +
                 (texts.size() > 2 ? " " + texts[2] : ""));
    const std::uint64_t shards = 1 + random() % 3;
    options.shard = {1 + random() % shards, shards};
    options.threads = 1 + static_cast<int>(random() % 3);
    const ExploreResult pruned = explore(options);
    const ExploreResult all = filtered(options);
    if (shards == 1) {
      expect_same_result(pruned, all);
    } else {
      expect_same_counts(pruned, all);
      expect_same_references(pruned, all);
      EXPECT_EQ(sampled_words(*pruned.record), sampled_words(*all.record));
      EXPECT_EQ(steps_of(pruned.tradeoff), steps_of(all.tradeoff));
    }
  }
}

TEST(ExplorePruning, OfShardsTogetherIsThatOfTheWhole) {
  for (const std::vector<std::string>& texts : std::vector<std::vector<std::string>>{
           {"sheaths<=2"}, {"sheaths<=1", "uniformity>=0.9999"}, {"sheaths<=0"}}) {
    SCOPED_TRACE(texts.front());
    for (const PartSet& parts : {full_parts(), with_blocks(anchored(paper_parts()), 2)}) {
      ExploreOptions options = pruned_options(parts, 3);
      options.constraints = constraints_of(texts);
      const ExploreResult whole = explore(options);
      for (const std::uint64_t count : {2U, 7U, 40U}) {
        std::vector<ShardRecord> records;
        for (std::uint64_t index = 1; index <= count; ++index) {
          options.shard = {index, count};
          records.push_back(*explore(options).record);
        }
        options.shard = {};
        expect_same_result(conclude(records, options), whole);
      }
    }
  }
}

TEST(ExplorePruning, DoesNotDependOnThreadsOrBatches) {
  ExploreOptions options = pruned_options(full_parts(), 6);
  options.constraints = constraints_of({"sheaths<=4", "pulleys<=7"});
  const ExploreResult one = explore(options);
  EXPECT_GT(one.evaluated - one.pruned, 8192U);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    expect_same_result(explore(options), one);
  }
}

TEST(ExplorePruning, StoppedItCountsWhatWasLeftOutUntilThere) {
  ExploreOptions options = pruned_options(full_parts(), 5);
  options.constraints = constraints_of({"sheaths<=3"});
  std::atomic<bool> stop{true};
  const ExploreResult result = explore(options, {{}, &stop});
  ASSERT_TRUE(result.partial);
  ASSERT_GT(result.generated, 0U);
  const Naive naive = naive_program(options, result.generated);
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  EXPECT_EQ(result.rejected[1].count, naive.failed[0]);
  EXPECT_EQ(result.evaluated, naive.generated - naive.not_actuated);
}

TEST(ExplorePruning, StoppedWhileItLooksAtAllAgainItIsPartial) {
  ExploreOptions options = pruned_options(full_parts(), 3);
  options.constraints = constraints_of({"sheaths<=1", "uniformity>=0.9999"});
  std::atomic<bool> stop{false};
  Supervision supervision;
  supervision.stop = &stop;
  supervision.report = [&](const Progress& progress) {
    if (progress.done == progress.total) stop = true;
  };
  const ExploreResult result = explore(options, supervision);
  EXPECT_TRUE(result.partial);
  EXPECT_TRUE(result.infeasible.empty());
  EXPECT_EQ(result.generated, result.total);
}

TEST(ExplorePruning, IsOfTheFirstConstraintsThatPartsDecide) {
  ExploreOptions options = pruned_options(full_parts(), 3);
  const auto many = [&](const std::vector<std::string>& texts) {
    options.constraints = constraints_of(texts);
    return pruning_constraints(options);
  };
  EXPECT_EQ(many({}), 0U);
  EXPECT_EQ(many({"sheaths<=3", "pulleys<=2", "uniformity>=0.5", "knots<1"}), 2U);
  EXPECT_EQ(many({"uniformity>=0.5", "sheaths<=3"}), 0U);
  EXPECT_EQ(many({"travel<=3"}), 0U);
  // As far as classes last.
  EXPECT_EQ(many({"sheaths<=5", "pulleys<=5", "knots<=4", "parts<=9"}), 2U);
  options.constraints = constraints_of({"sheaths<=3"});
  options.generator.identity = FingerIdentity::distinct;
  EXPECT_EQ(pruning_constraints(options), 0U);
}

// Friction that grows with the load, bearings that take a force which is all that arrives, and a
// contact that is seized.
TEST(ExplorePruning, WithAModelWhoseSolvesMayNotConvergeFindsWhatFilteringFinds) {
  ExploreOptions options = pruned_options(full_parts(), 2);
  add_effect(options.model, {find_cause("load_dependent_friction"), {}, {-0.3}});
  add_effect(options.model, {find_cause("bearing_drag"), {}, {2}});
  Subject seized;
  seized.routing = "M-1-T-2-F";
  seized.contact = "T1-T2";
  add_effect(options.model, {find_cause("seized_contact"), seized, {}});
  std::uint64_t unconverged = 0;
  for (const char* constraint : {"sheaths<=2", "sheaths>=2", "pulleys<=1"}) {
    SCOPED_TRACE(constraint);
    options.constraints = constraints_of({constraint});
    const ExploreResult pruned = explore(options);
    const ExploreResult all = filtered(options);
    EXPECT_GT(pruned.pruned, 0U);
    EXPECT_EQ(pruned.unconverged, all.unconverged);
    expect_same_result(pruned, all);
    unconverged += pruned.unconverged;
  }
  EXPECT_GT(unconverged, 0U);
  // Also where all are made, as with distinct fingers.
  options.generator.identity = FingerIdentity::distinct;
  options.references.clear();
  options.constraints = constraints_of({"sheaths<=0"});
  EXPECT_EQ(explore(options).unconverged, 0U);
}

TEST(ExplorePruning, WithDistinctFingersEverythingIsMade) {
  ExploreOptions options = pruned_options(paper_parts(), 3);
  options.references.clear();
  options.generator.identity = FingerIdentity::distinct;
  options.constraints = constraints_of({"sheaths<=2"});
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.pruned, 0U);
  expect_same_result(result, filtered(options));
}

// Less is made, and to know what, less is looked at.
TEST(ExplorePruning, LooksAtAFewOfAllRoutings) {
  for (const auto& [parts, fingers, text, less_given, less_looked_at] :
       std::vector<std::tuple<PartSet, int, std::string, std::uint64_t, std::uint64_t>>{
           {full_parts(), 6, "sheaths<=3", 20, 5},
           {full_parts(), 6, "sheaths<=1", 200, 10},
           {with_blocks(all_parts(), 2), 4, "sheaths<=1", 20, 20}}) {
    ExploreOptions options = options_for(parts, fingers);
    options.constraints = constraints_of({text});
    RoutingGenerator limited(options.generator, {options.constraints, options.generator});
    limited.seek(0);
    std::uint64_t many = 0;
    std::uint64_t place = 0;
    for (Routing routing; limited.next(routing, place);) ++many;
    EXPECT_EQ(many, limited.verdicts_before(limited.total())[within_limits]);
    EXPECT_LT(many * less_given, limited.total()) << label_of(options.generator);
    EXPECT_LT(limited.steps() * less_looked_at, limited.total()) << label_of(options.generator);
  }
}

}  // namespace
}  // namespace reeve::testing
