#include "search/rank/equivalent.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "tests/search/naive_exploration.hpp"

namespace reeve::testing {
namespace {

std::string plain(const std::string& word) {
  return to_word(without_bearings(parse_routing(word), FingerIdentity::identical));
}

TEST(WithoutBearings, HasTubesAtTipsAndJoins) {
  EXPECT_EQ(plain("1-P-2b-P-1"), "1-P-2-P-1");
  EXPECT_EQ(plain("M-1b-B-2-F"), "M-1-T-2-F");
  EXPECT_EQ(plain("M-1-T-2-F"), "M-1-T-2-F");
  // A pulley on the carriage is no superfluous bearing.
  EXPECT_EQ(plain("F-1-P-2-F"), "F-1-P-2-F");
}

std::map<std::string, std::string> equivalents_of(const ExploreOptions& options) {
  const ExploreResult result = explore(options);
  const std::vector<std::size_t> firsts =
      first_equivalent(result.top, result.routings, options.order, options.generator.identity);
  std::map<std::string, std::string> first_of;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    EXPECT_LE(firsts[i], i);
    EXPECT_EQ(firsts[firsts[i]], firsts[i]);
    first_of[result.top[i].design.word] = result.top[firsts[i]].design.word;
  }
  return first_of;
}

TEST(FirstEquivalent, TakesTheThreeLoopsOfTwoFingersForOne) {
  const std::map<std::string, std::string> first_of = equivalents_of(options_for(full_parts(), 2));
  EXPECT_EQ(first_of.at("1-P-2-P-1"), "1-P-2-P-1");
  EXPECT_EQ(first_of.at("1-P-2b-P-1"), "1-P-2-P-1");
  EXPECT_EQ(first_of.at("1b-P-2b-P-1b"), "1-P-2-P-1");
  // Equal in both objectives, but threaded otherwise.
  EXPECT_EQ(first_of.at("F-1b-P-2b-F"), "F-1b-P-2b-F");
  EXPECT_EQ(first_of.at("M-1b-B-2b-M"), "M-1b-B-2b-M");
  // The same but for bearings that do change something.
  EXPECT_EQ(first_of.at("M-1b-B-2b-F"), "M-1b-B-2b-F");
}

TEST(FirstEquivalent, TellsApartWhatTheRankingCounts) {
  const std::map<std::string, std::string> first_of = equivalents_of(
      options_for(full_parts(), 2,
                  {Objective::uniformity_mean, Objective::efficiency_mean, Objective::pulleys}));
  EXPECT_EQ(first_of.at("1-P-2b-P-1"), "1-P-2b-P-1");
  EXPECT_EQ(first_of.at("1b-P-2b-P-1b"), "1b-P-2b-P-1b");
  // As many bearings, in other places.
  EXPECT_EQ(first_of.at("M-1b-M+2-P-2"), "M-1-M+2b-P-2b");
}

// In one front and with the same product, but force and travel are traded.
TEST(FirstEquivalent, TellsApartWhatIsEqualOnlyInWhatOrdersWithinAFront) {
  const std::vector<Routing> routings{parse_routing("1-P-2-P-1"), parse_routing("1-P-2b-P-1")};
  std::vector<RankedDesign> ranked;
  for (const double amount : {1.0, 2.0}) {
    RankedDesign entry{{to_word(routings[ranked.size()]), {}}, 1, ranked.size() + 1};
    value(entry.design.values, Objective::force_transmission) = amount;
    value(entry.design.values, Objective::travel) = amount;
    ranked.push_back(entry);
  }
  const auto firsts = [&](const Order& order) {
    return first_equivalent(ranked, routings, order, FingerIdentity::identical);
  };
  EXPECT_EQ(firsts({Objective::force_transmission, Objective::travel}),
            (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(firsts({Objective::jams}), (std::vector<std::size_t>{0, 0}));
}

// By definition, over all pairs of a whole exploration.
TEST(FirstEquivalent, AgreesWithItsDefinition) {
  ExploreOptions options = options_for(full_parts(), 3, {Objective::uniformity_worst});
  const ExploreResult result = explore(options);
  const std::vector<std::size_t> firsts =
      first_equivalent(result.top, result.routings, options.order, options.generator.identity);
  std::size_t equivalent = 0;
  for (std::size_t i = 0; i < result.top.size(); ++i) {
    std::size_t expected = i;
    for (std::size_t k = 0; k < i && expected == i; ++k) {
      const ObjectiveValues& a = result.top[i].design.values;
      const ObjectiveValues& b = result.top[k].design.values;
      const bool equal =
          value(a, Objective::uniformity_worst) == value(b, Objective::uniformity_worst) &&
          decisive_value(a, options.order) == decisive_value(b, options.order);
      if (equal && plain(result.top[i].design.word) == plain(result.top[k].design.word)) {
        expected = k;
      }
    }
    ASSERT_EQ(firsts[i], expected) << result.top[i].design.word;
    if (expected != i) ++equivalent;
  }
  EXPECT_GT(equivalent, 20U);
}

}  // namespace
}  // namespace reeve::testing
