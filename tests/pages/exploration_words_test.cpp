#include "pages/exploration/exploration_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pages/exploration/exploration_answer.hpp"
#include "tests/pages/explored.hpp"

namespace reeve {
namespace {

using testing::explored;
using testing::small_options;

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + " ";
  return text;
}

void expect_says(const std::vector<std::string>& sentences, const std::string& what) {
  EXPECT_NE(joined(sentences).find(what), std::string::npos)
      << "'" << what << "' is not in: " << joined(sentences);
}

TEST(ExplorationWords, NameTheFirstAndWhy) {
  const ExplorationWords words = exploration_words(explored(small_options()));
  expect_says(words.won,
              "1-P-2-P-1 comes first of 54 designs: uniformity mean 0.9979 and "
              "efficiency mean 0.3224, with 4 sheaths, 2 pulleys and 1 knot.");
  expect_says(words.won, "one of 3 designs on the Pareto front");
  expect_says(words.won, "of those with the same product it needs fewest parts");
  expect_says(words.won, "the next of these, K2, has rank 16: 13 designs dominate it");
  expect_says(words.won, "Next comes 1-P-2b-P-1, which equals it in these");
}

// One of a part is said, none of it is not.
TEST(ExplorationAnswer, CountsThePartsOfTheFirst) {
  ExploreOptions options = small_options();
  options.constraints.push_back(parse_constraint("pulleys==1"));
  const ExploreReport report = explored(options);
  const std::string values =
      pages::answer_body(report, testing::view(report).solve)["slots"][0]["values"];
  EXPECT_EQ(values, "uniformity mean 0.567, efficiency mean 0.253; 2 sheaths, 1 pulley");
}

TEST(ExplorationAnswer, AdvisesADesignOnceIfItIsAffordableAndTheKnee) {
  ExploreReport report = explored(small_options());
  report.tradeoff.affordable = report.tradeoff.steps[0];
  for (const auto& [knee, labels] :
       {std::pair<std::size_t, std::vector<std::string>>{0, {"within 2 %, knee"}},
        {1, {"within 2 %", "knee"}}}) {
    report.tradeoff.tradeoff.knee = knee;
    std::vector<std::string> advised;
    for (const auto& design : pages::advised_designs(report)) advised.push_back(design.label);
    EXPECT_EQ(advised, labels);
  }
}

TEST(ExplorationWords, SayWhatWasCountedAndWhatHasItsOwnFriction) {
  ExploreReport report = explored(small_options());
  expect_says(pages::explored_words(report), "; any number of tendons; fingers count as alike.");
  expect_says(pages::explored_words(report), "sheaths μ 0.18 over 360°. ");
  report.options.generator.one_tendon = true;
  report.options.generator.identity = FingerIdentity::distinct;
  Hardware& hardware = report.options.model.hardware;
  hardware.block = ContactLaw{0.25, 3};
  hardware.contacts.push_back({"T1", "T2", 0.1, {}});
  expect_says(pages::explored_words(report), "; one tendon; fingers are told apart.");
  expect_says(pages::explored_words(report),
              ", floating blocks μ 0.25 over 171.9°. 0 fingers and 1 contact have values of their "
              "own.");
}

TEST(ExplorationWords, SayWhenTheFirstStandsAlone) {
  const ExplorationWords words = exploration_words(explored(small_options(3)));
  expect_says(words.won, "It stands alone on the Pareto front");
}

TEST(ExplorationWords, TellWhatFloatsAtTheHand) {
  ExploreOptions options = small_options();
  options.generator.parts.anchored = true;
  options.generator.parts.blocks = 1;
  expect_says(
      exploration_words(explored(options)).won,
      "M-Y1+1x-Y1-2x comes first of 283 designs: uniformity mean 0.9979 and efficiency mean "
      "0.3224, with 1 sheath, 0 pulleys, 0 knots and 1 floating block.");
}

TEST(ExplorationWords, SayThatTheScoreOrders) {
  ExploreOptions options = small_options();
  options.order.by_score = true;
  options.score = authors_score();
  const ExplorationWords words = exploration_words(explored(options));
  expect_says(words.won, "Among these the one with the greatest score comes first");
  EXPECT_EQ(joined(words.won).find("product"), std::string::npos) << joined(words.won);
  expect_says(
      words.explored,
      "(which fingers are held). Sorted by Pareto front (uniformity_mean, efficiency_mean), "
      "within a front by the score, the weighted mean of adaptability=1,");
}

TEST(ExplorationWords, SayThatFewestPartsDecideBetweenEqualScores) {
  ExploreOptions options = small_options();
  options.order = {{Objective::score}, true};
  options.score = parse_score("uniformity=1");
  ExploreReport report = explored(options);
  ASSERT_GT(report.front.size(), 1U);
  expect_says(exploration_words(report).won,
              "comes first; of those with the same score it needs fewest parts.");
}

TEST(ExplorationWords, CountWhatWasExploredAndRejected) {
  ExploreOptions options = small_options();
  options.constraints.push_back(parse_constraint("sheaths<=2"));
  const ExploreReport report = explored(options);
  const ExplorationWords words = exploration_words(report);
  expect_says(words.explored, "126 of 126 routings of 2 fingers were generated");
  expect_says(words.rejected, "72: not actuated; one of the tendons hangs on no motor.");
  const std::uint64_t failed = report.result.rejected.at(1).count;
  ASSERT_GT(failed, 0U);
  expect_says(words.rejected, std::to_string(failed) + ": constraint sheaths<=2 not met.");
  EXPECT_EQ(ranked_designs(report), 54 - failed);
  EXPECT_EQ(report.top.size(), 54 - failed);
  expect_says(words.won, "comes first of " + std::to_string(54 - failed) + " designs");
}

TEST(ExplorationWords, SayWhoComesFirstByOneObjectiveAlone) {
  const ExploreReport report = explored(small_options());
  expect_says(exploration_words(report).changes, "force transmission (M-1b-B-2b-F)");
  for (const SingleBest& best : single_bests(report)) {
    const auto get = [&](const ListedDesign& design) {
      const double v = value(design.ranked.design.values, best.objective.objective);
      return best.objective.better == Better::higher ? v : -v;
    };
    std::size_t equal = 0;
    for (const ListedDesign& design : report.top) {
      EXPECT_LE(get(design), get(best.design));
      if (get(design) != get(best.design)) continue;
      EXPECT_GE(design.ranked.rank, best.design.ranked.rank) << best.objective.name;
      ++equal;
    }
    EXPECT_EQ(equal, best.equal + 1) << best.objective.name;
  }
}

TEST(ExplorationWords, SayWhatTheListLeavesOut) {
  ExploreOptions options = small_options();
  options.top = 7;
  expect_says(exploration_words(explored(options)).changes,
              "The list holds the first 7 of 54 ranked designs.");
  options.shard = {2, 3};
  expect_says(exploration_words(explored(options)).caveats, "This is part 2 of 3 of the whole");
}

TEST(ExplorationWords, SayHowSureTheOrderIs) {
  ExploreReport report = explored(small_options());
  expect_says(exploration_words(report).changes, "was not computed; --uncertainty");
  report.uncertainty = UncertaintyOptions{};
  report.uncertainty->draws = 200;
  for (ListedDesign& design : report.top) design.distribution = RankDistribution{};
  report.top[0].distribution->first = 0.25;
  report.top[3].distribution->first = 0.75;
  const ExplorationWords words = exploration_words(report);
  expect_says(words.changes, "drawn 200 times from their ranges, 1-P-2-P-1 stays first in 25.0 %");
  expect_says(words.changes, report.top[3].ranked.design.word + " is first most often: in 75.0 %.");
  EXPECT_EQ(joined(words.changes).find("it shares first place"), std::string::npos);
  report.top[0].distribution->first_shared = 0.125;
  report.top[0].constraints_met = 0.5;
  const ExplorationWords more = exploration_words(report);
  expect_says(more.changes, "In 12.5 % it shares first place with designs that equal it.");
  expect_says(more.changes, "in 50.0 % of the draws it meets all of them.");
}

TEST(ExplorationWords, CountDesignsOfTheFrontThatAreNotListed) {
  ExploreReport report = explored(small_options());
  report.result.front_equals_left_out = 4;
  expect_says(exploration_words(report).won, "It is one of 7 designs on the Pareto front");
}

TEST(ExplorationWords, SayWhereKnownRoutingsStand) {
  ExploreReport report = explored(small_options());
  std::vector<ReferenceStanding>& known = report.result.references;
  known[0].rank = 5;
  known[1].rank = 4;
  known[1].dominated_by = 1;
  expect_says(exploration_words(report).won,
              "It is a known routing; the next of these, K2, has rank 4: 1 design dominates it");
  known = {known[2]};
  expect_says(exploration_words(report).won,
              "It is a known routing; no other of these is among the listed designs.");
  known[0].rank = 0;
  expect_says(exploration_words(report).won,
              "None of the known routings is among the listed designs.");
}

TEST(ExplorationWords, NameTheFirstOnlyWhereItStaysFirst) {
  const ExploreReport report = explored(small_options());
  const std::string changes = joined(exploration_words(report).changes);
  EXPECT_NE(changes.find("1-P-2-P-1 stays first, or equal to the first, by "), std::string::npos);
  EXPECT_EQ(changes.find("(1-P-2-P-1)"), std::string::npos) << changes;
}

// Of the whole, no part of it.
TEST(ExplorationWords, WarnOnlyWhereItApplies) {
  EXPECT_EQ(joined(exploration_words(explored(small_options())).caveats), "");
}

TEST(ExplorationWords, AreNoneForAnEmptyList) {
  ExploreOptions options = small_options();
  options.constraints.push_back(parse_constraint("sheaths<=0"));
  const ExploreReport report = explored(options);
  const ExplorationWords words = exploration_words(report);
  expect_says(words.won, "No design is left to rank: every routing was rejected.");
  EXPECT_TRUE(words.changes.empty());
  EXPECT_TRUE(single_bests(report).empty());
}

}  // namespace
}  // namespace reeve
