// Tests the best listed design that never jams, and the most robust design.
#include "studies/listed_design.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve {
namespace {

using studies::ListedDesign;
using studies::ListedTradeoff;

std::vector<ListedDesign> listed(const std::vector<std::string>& words) {
  DesignEvaluator evaluator(Hardware{}, single_grasps(4));
  std::vector<Design> designs;
  for (const std::string& word : words) {
    designs.push_back({word, evaluator.evaluate(parse_routing(word))});
  }
  const std::vector<RankedDesign> ranked = rank(designs, Order{});
  std::vector<Routing> routings;
  for (const RankedDesign& design : ranked) routings.push_back(parse_routing(design.design.word));
  return studies::list_designs(ranked, routings, {}, Model{}, Catalogue{});
}

ListedTradeoff tradeoff_of(const std::vector<ListedDesign>& designs) {
  return studies::list_tradeoff({}, designs, Order{}, Model{}, std::nullopt, Catalogue{});
}

TEST(ListedDesigns, SayWithWhichFingersHeldTheyJam) {
  const auto designs = listed({"1-P-2-P-1+3-P-4-P-3"});
  EXPECT_EQ(designs.front().smallest_jams, (std::vector<Grasp>{hold({1, 2}), hold({3, 4})}));
  EXPECT_EQ(value(designs.front().ranked.design.values, Objective::jams_all), 6);
}

TEST(ListedDesigns, HaveABestThatNeverJams) {
  const auto designs = listed(
      {"1-P-2-P-1+3-P-4-P-3", "M-1-T-2-T-3-T-4-F", "1-P-2-P-3-P-4-P-1", "F-1-P-2-P-3-T-4-F"});
  ASSERT_EQ(designs.front().ranked.design.word, "1-P-2-P-1+3-P-4-P-3");
  const ListedTradeoff tradeoff = tradeoff_of(designs);
  ASSERT_TRUE(tradeoff.never_jams);
  EXPECT_EQ(tradeoff.never_jams->ranked.design.word, "1-P-2-P-3-P-4-P-1");
  EXPECT_FALSE(tradeoff_of(listed({"1-P-2-P-1+3-P-4-P-3"})).never_jams);
}

std::string robust_word(const std::vector<ListedDesign>& designs, const Order& order = {}) {
  return studies::robust_first(designs, order)->robust.design.ranked.design.word;
}

TEST(ListedDesigns, HaveARobustBestOfTheGreatestLowQuantileOverDraws) {
  auto designs = listed({"1-P-2-P-3-P-4-P-1", "F-1-P-2-P-3-T-4-F", "M-1-T-2-T-3-T-4-F"});
  designs[0].decisive = Band{0.3, 0.1, 0.5};
  designs[1].decisive = Band{0.2, 0.15, 0.3};
  designs[2].decisive = Band{0.2, 0.16, 0.3};
  EXPECT_EQ(robust_word(designs), designs[2].ranked.design.word);
  // Bearings that change nothing otherwise matter where contacts are not alike.
  designs[2].same_as = designs[1].ranked.design.word;
  EXPECT_EQ(robust_word(designs), designs[2].ranked.design.word);
  EXPECT_TRUE(studies::robust_first(designs, Order{})->over_draws);
  EXPECT_EQ(studies::robust_first(designs, Order{})->nominal.design.ranked.design.word,
            designs[0].ranked.design.word);
}

TEST(ListedDesigns, HaveARobustBestOverContactsWhereNothingIsDrawn) {
  auto designs = listed({"1-P-2-P-3-P-4-P-1", "F-1-P-2-P-3-T-4-F", "M-1-T-2-T-3-T-4-F"});
  const auto set = [&](std::size_t i, double uniformity, double efficiency) {
    value(designs[i].ranked.design.values, Objective::uniformity_p5) = uniformity;
    value(designs[i].ranked.design.values, Objective::efficiency_p5) = efficiency;
  };
  set(0, 0.9, 0.2);
  set(1, 0.5, 0.3);
  set(2, 0.95, 0.25);
  EXPECT_EQ(robust_word(designs), designs[2].ranked.design.word);
  EXPECT_FALSE(studies::robust_first(designs, Order{})->over_draws);
  EXPECT_FALSE(studies::robust_first(designs, Order({Objective::travel}, true)));
  EXPECT_FALSE(studies::robust_first({}, Order{}));
}

}  // namespace
}  // namespace reeve
