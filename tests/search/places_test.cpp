// Places that equal designs share: against comparing each with each.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/equivalent.hpp"
#include "tests/search/uncertain.hpp"

namespace reeve::testing {
namespace {

Design random_design(std::size_t number, std::mt19937& random) {
  Design design{std::to_string(number), {}};
  for (const Objective objective :
       {Objective::uniformity_mean, Objective::efficiency_mean, Objective::score}) {
    value(design.values, objective) = static_cast<double>(random() % 3) / 4;
  }
  value(design.values, Objective::sheaths) = static_cast<double>(random() % 2);
  return design;
}

bool is_equal(const Design& a, const Design& b, const Order& order) {
  for (const Objective objective : order.objectives) {
    if (value(a.values, objective) != value(b.values, objective)) return false;
  }
  return decisive_value(a.values, order) == decisive_value(b.values, order);
}

TEST(Places, AreTheRankOfTheFirstEqualDesign) {
  std::mt19937 random(7);
  const std::vector<Order> orders{{Objective::uniformity_mean, Objective::efficiency_mean},
                                  {Objective::sheaths},
                                  Order({Objective::score}, true),
                                  Order({Objective::uniformity_mean, Objective::sheaths}, true)};
  std::size_t shared_places = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Design> designs;
    for (std::size_t i = 0; i < 12; ++i) designs.push_back(random_design(i, random));
    for (const Order& order : orders) {
      const std::vector<RankedDesign> ranked = rank(designs, order);
      const std::vector<std::size_t> shared = places(ranked, order);
      ASSERT_EQ(shared.size(), ranked.size());
      for (std::size_t i = 0; i < ranked.size(); ++i) {
        std::size_t expected = ranked[i].rank;
        for (std::size_t j = i; j-- > 0;) {
          if (is_equal(ranked[i].design, ranked[j].design, order)) expected = ranked[j].rank;
        }
        EXPECT_EQ(shared[i], expected);
        shared_places += shared[i] == ranked[i].rank ? 0 : 1;
      }
    }
  }
  EXPECT_GT(shared_places, 1000U);
}

DrawnDesigns drawn_words(const std::vector<std::string>& words) {
  return drawn_designs(parsed(words), options_of_like_contacts(200)).value();
}

TEST(Places, OfTheLoopAndItsTwinsAreAllFirstInEveryDraw) {
  for (const RankDistribution& ranks :
       drawn_words({"1-P-2-P-1", "1-P-2b-P-1", "1b-P-2b-P-1b"}).ranks) {
    EXPECT_EQ(ranks.first, 1);
    EXPECT_EQ(ranks.first_shared, 1);
    EXPECT_EQ(ranks.median, 1);
    EXPECT_EQ(ranks.high, 1);
  }
}

// TR3 and TR6 are equal behind TR7: both second, and TR2 fourth.
TEST(Places, BehindEqualDesignsAreAsManyFurtherBack) {
  const auto ranks = drawn_words({"F-1-P-2-F", "1-T-2-P-1", "M-1-T-2-M", "1-P-2-P-1"}).ranks;
  EXPECT_EQ(ranks[0].low, 2);
  EXPECT_EQ(ranks[0].high, 2);
  EXPECT_EQ(ranks[1].low, 2);
  EXPECT_EQ(ranks[1].high, 2);
  EXPECT_EQ(ranks[2].low, 4);
  EXPECT_EQ(ranks[3].first, 1);
  EXPECT_EQ(ranks[3].first_shared, 0);
}

}  // namespace
}  // namespace reeve::testing
