// Designs found beforehand, beside those of a search that was stopped.
#include "search/foreseen_designs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "search/batches.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/same_exploration.hpp"

namespace reeve::testing {
namespace {

ExploreOptions searched() {
  ExploreOptions options = options_for(full_parts(), 4);
  options.top = 20;
  options.constraints = constraints_of({"sheaths<=5"});
  return options;
}

ExplorationPart found_in(const ExploreOptions& options) {
  return search_batches(options, {}, EvaluatedDesigns::that_may_be_kept, {});
}

std::vector<Design> kept_of(ExploreOptions options, const PartSet& parts, std::uint64_t limit) {
  options.generator.parts = parts;
  return naive_program(options, limit).kept;
}

// The first third of all, and those without round tubes, which slide worse.
std::vector<Design> expected_designs(const ExploreOptions& options, std::uint64_t third) {
  std::map<std::string, Design> designs;
  for (const Design& design : kept_of(options, full_parts(), third)) {
    designs[design.word] = design;
  }
  const PartSet with_bearings = parts_of("bearing", "B,P", "M,F");
  for (const Design& design : kept_of(options, with_bearings, UINT64_MAX)) {
    designs[design.word] = design;
  }
  std::vector<Design> result;
  for (auto& [word, design] : designs) result.push_back(std::move(design));
  return result;
}

TEST(ForeseenDesigns, StandOnceBesideThoseOfAStoppedSearch) {
  ExploreOptions options = searched();
  options.shard = {1, 3};
  ExplorationPart stopped = found_in(options);
  const std::vector<Design> designs = expected_designs(options, stopped.generated);
  options.shard = {};
  ForeseenDesigns(options, nullptr).add_to(stopped);
  TradeoffArchive steps(options.order, options.tradeoff.by);
  for (const Design& design : designs) steps.add(design);
  const ExploreResult result = conclude(std::move(stopped), options);

  const std::vector<RankedDesign> ranked = rank(designs, options.order);
  ASSERT_EQ(result.top.size(), options.top);
  for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], ranked[i]);
  EXPECT_EQ(steps_of(result.tradeoff), steps_of(tradeoff(steps.candidates(), ranked.front().design,
                                                         options.order, options.tradeoff)));
}

TEST(ForeseenDesigns, RejectNoneThatIsAmongTheBestOfAll) {
  const ExploreOptions options = searched();
  const ForeseenDesigns foreseen(options, nullptr);
  EXPECT_GT(foreseen.visited().designs, 0U);
  const std::vector<RankedDesign> ranked = rank(naive_program(options).kept, options.order);
  for (std::size_t i = 0; i < options.top; ++i) {
    EXPECT_TRUE(foreseen.may_keep(ranked[i].design.values)) << ranked[i].design.word;
  }
  EXPECT_FALSE(foreseen.may_keep(ranked.back().design.values));
}

}  // namespace
}  // namespace reeve::testing
