#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/explore.hpp"
#include "search/rank/pareto.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

std::uint64_t dominators(const Design& of, const Naive& naive, const Objectives& objectives) {
  const Goodness own = goodness(of.values, objectives);
  return static_cast<std::uint64_t>(std::count_if(
      naive.kept.begin(), naive.kept.end(),
      [&](const Design& other) { return dominates(goodness(other.values, objectives), own); }));
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
      EXPECT_EQ(standing.design.values, entry->design.values);
      EXPECT_EQ(standing.dominated_by, dominators(standing.design, naive, objectives));
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

// Most are only estimated there, and some equal a reference.
TEST(ExploreReferences, AreCountedAmongManyThatAreFarFromTheBest) {
  ExploreOptions options = several_batches();
  options.top = 1;
  options.threads = 2;
  const Naive naive = naive_program(options);
  for (std::size_t i = 0; i < naive.kept.size(); i += naive.kept.size() / 40) {
    options.references.push_back(parse_routing(naive.kept[i].word));
  }
  const ExploreResult result = explore(options);
  for (const ReferenceStanding& standing : result.references) {
    EXPECT_EQ(standing.dominated_by, dominators(standing.design, naive, both));
    EXPECT_TRUE(standing.generated);
  }
}

// An estimate would be on the other side of the limit.
TEST(ExploreConstraints, AreHeldAgainstTheValuesThemselves) {
  ExploreOptions options = several_batches();
  options.top = 1;
  const Naive all = naive_program(options);
  std::vector<double> values;
  for (const Design& design : all.kept) {
    values.push_back(value(design.values, Objective::uniformity_mean));
  }
  const auto median = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), median, values.end());
  Constraint just_above = parse_constraint("uniformity_mean>=0");
  just_above.bound = *median + 5e-10;
  options.constraints = {just_above};
  const auto failed =
      std::ranges::count_if(values, [&](double each) { return each < just_above.bound; });
  EXPECT_EQ(explore(options).rejected[1].count, static_cast<std::uint64_t>(failed));
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
  EXPECT_EQ(stranger.dominated_by, dominators(stranger.design, naive, both));
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
  const Naive naive = naive_program(options);
  EXPECT_EQ(result.references[0].dominated_by,
            dominators(result.references[0].design, naive, both));
  EXPECT_LT(result.references[0].dominated_by, of_all);
}

}  // namespace
}  // namespace reeve::testing
