#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <vector>

#include "search/enumerate/checked.hpp"
#include "search/enumerate/grammar.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

TEST(Digits, AreTakenFromTheLastOn) {
  Digits digits(2 + 3 * (4 + 5 * 6));
  EXPECT_EQ(digits.take(3), 2U);
  EXPECT_EQ(digits.take(5), 4U);
  EXPECT_EQ(digits.rest(), 6U);
}

TEST(Digits, ChoicesThatLieBeforeAreTakenOff) {
  Digits digits(7);
  EXPECT_FALSE(digits.is_among(5));
  EXPECT_FALSE(digits.is_among(2));
  EXPECT_FALSE(digits.is_among(0));
  EXPECT_TRUE(digits.is_among(1));
  EXPECT_EQ(digits.rest(), 0U);
}

TEST(Digits, EveryMultisetHasOneIndex) {
  for (std::uint64_t n = 1; n <= 5; ++n) {
    for (std::uint64_t m = 1; m <= 4; ++m) {
      std::set<std::vector<std::uint64_t>> seen;
      for (std::uint64_t index = 0; index < multichoose(n, m); ++index) {
        std::uint64_t rest = index;
        std::vector<std::uint64_t> multiset;
        for (std::uint64_t left = m; left > 0; --left) {
          multiset.push_back(greatest_of_multiset(n, left, rest));
        }
        EXPECT_TRUE(std::is_sorted(multiset.rbegin(), multiset.rend()));
        EXPECT_LT(multiset.front(), n);
        EXPECT_TRUE(seen.insert(multiset).second);
      }
    }
  }
}

TEST(Digits, PairsOfBillions) {
  const std::uint64_t n = 3000000000;
  std::uint64_t index = multichoose(n, 2) - 1;
  EXPECT_EQ(greatest_of_multiset(n, 2, index), n - 1);
  EXPECT_EQ(index, n - 1);
}

TEST(FingerSets, EverySubsetOfASizeIsTakenOnce) {
  const FingerSet whole = 0b1011101;
  for (int many = 0; many <= 5; ++many) {
    const std::uint64_t ways = binomial(5, static_cast<std::uint64_t>(many));
    std::set<FingerSet> seen;
    for (std::uint64_t index = 0; index < ways; ++index) {
      Digits digits(index + 10 * ways);
      FingerSet rest = whole;
      const FingerSet taken = take_some(rest, many, digits, distinct);
      EXPECT_EQ(std::popcount(taken), many);
      EXPECT_EQ(taken & rest, 0U);
      EXPECT_EQ(taken | rest, whole);
      EXPECT_EQ(digits.rest(), 10U);
      EXPECT_TRUE(seen.insert(taken).second);
    }
  }
}

TEST(FingerSets, TheLeastAndOthers) {
  std::set<FingerSet> seen;
  for (std::uint64_t index = 0; index < 3; ++index) {
    Digits digits(index);
    FingerSet rest = 0b1011010;
    const FingerSet taken = take_least_and(rest, 2, digits, distinct);
    EXPECT_EQ(std::popcount(taken), 3);
    EXPECT_EQ(taken & 0b11, 0b10U);
    EXPECT_EQ(rest ^ taken, 0b1011010U);
    EXPECT_TRUE(seen.insert(taken).second);
  }
}

TEST(FingerSets, OneByOneInEveryOrder) {
  std::set<std::vector<int>> seen;
  for (std::uint64_t index = 0; index < 6; ++index) {
    Digits digits(index);
    FingerSet rest = 0b11001;
    std::vector<int> order;
    while (rest != 0) order.push_back(take_one(rest, digits, distinct));
    EXPECT_EQ(std::set<int>(order.begin(), order.end()), (std::set<int>{1, 4, 5}));
    seen.insert(order);
  }
  EXPECT_EQ(seen.size(), 6U);
}

TEST(FingerSets, IdenticalFingersTakeNoDigits) {
  Digits digits(5);
  FingerSet none = fingers_up_to(4, identical);
  EXPECT_EQ(none, 0U);
  EXPECT_EQ(take_some(none, 2, digits, identical), 0U);
  EXPECT_EQ(take_one(none, digits, identical), 0);
  EXPECT_EQ(digits.rest(), 5U);
  EXPECT_EQ(fingers_up_to(3, distinct), 0b111U);
  EXPECT_EQ(fingers_up_to(64, distinct), ~FingerSet{0});
}

}  // namespace
}  // namespace reeve::testing
