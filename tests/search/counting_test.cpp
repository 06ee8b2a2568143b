#include "search/enumerate/counting.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "search/enumerate/checked.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/support/counting.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

constexpr FingerIdentity identities[] = {FingerIdentity::identical, FingerIdentity::distinct};

const std::string too_many =
    "these parts and fingers make more than 2^63 routings: fewer fingers or parts are needed";

// Every set of parts that makes a routing, empty lists of joins or of ends among them.
TEST(Counting, EverySetOfPartsAgreesWithIndependentFormulas) {
  for (const char* tips : {"tube", "bearing", "tube,bearing"}) {
    for (const char* joins : {"", "T", "B", "P", "T,B", "T,P", "B,P", "T,B,P"}) {
      for (const char* ends : {"", "M", "F", "M,F"}) {
        const PartSet parts{parse_tips(tips), parse_joins(joins), parse_ends(ends)};
        if (parts.joins.empty() && parts.ends.empty()) continue;
        for (const FingerIdentity identity : identities) {
          const int most = identity == FingerIdentity::identical ? 12 : 9;
          for (int fingers = 1; fingers <= most; ++fingers) {
            const RoutingCounts counts = count_routings(parts, fingers, identity);
            const testing::RoutingCounts expected = testing::count_trees(
                {testing::counted(parts)}, fingers, 0, identity == FingerIdentity::identical);
            const auto where = std::string(tips) + " " + joins + " " + ends + " " +
                               std::to_string(fingers) +
                               (identity == FingerIdentity::identical ? "" : " distinct");
            EXPECT_EQ(counts.all, expected.all) << where;
            EXPECT_EQ(counts.actuated, expected.actuated) << where;
            EXPECT_EQ(counts.one_tendon, expected.one_tendon) << where;
          }
        }
      }
    }
  }
}

// One finger: M-1-M, M-1-F, F-1-F, 1-T-1, 1-P-1. Two fingers: 7 actuated ones, F-1-T-2-F,
// 1-T-2-T-1.
TEST(Counting, TendonsThroughFewFingers) {
  EXPECT_EQ(tendon_counts(paper_parts(), 2, FingerIdentity::identical), (TendonCounts{0, 5, 9}));
  // M-1-T-2-F and M-2-T-1-F are two, and so are M-1-P-2-F and M-2-P-1-F.
  EXPECT_EQ(tendon_counts(paper_parts(), 2, FingerIdentity::distinct), (TendonCounts{0, 5, 11}));
}

// Of three shapes a, b, c through one finger and one shape d through two.
TEST(Counting, SetsOfIdenticalFingers) {
  const TendonCounts tendons{0, 3, 1};
  // aa ab ac bb bc cc d
  EXPECT_EQ(tendon_sets(tendons, 2, FingerIdentity::identical),
            (std::vector<std::uint64_t>{1, 3, 7}));
  EXPECT_EQ(tendon_sets(tendons, 1, FingerIdentity::identical),
            (std::vector<std::uint64_t>{1, 3, 6}));
  EXPECT_EQ(tendon_sets(tendons, 0, FingerIdentity::identical),
            (std::vector<std::uint64_t>{1, 0, 0}));
}

TEST(Counting, SetsOfDistinctFingers) {
  const TendonCounts tendons{0, 3, 1};
  // Each finger has its own of the three, or d has both.
  EXPECT_EQ(tendon_sets(tendons, 2, FingerIdentity::distinct),
            (std::vector<std::uint64_t>{1, 3, 10}));
  EXPECT_EQ(tendon_sets(tendons, 1, FingerIdentity::distinct),
            (std::vector<std::uint64_t>{1, 3, 9}));
}

TEST(Counting, WithoutJoinsEveryFingerHasItsOwnTendon) {
  const PartSet parts{parse_tips("tube"), {}, parse_ends("M,F")};
  EXPECT_EQ(tendon_counts(parts, 3, FingerIdentity::identical), (TendonCounts{0, 3, 0, 0}));
  EXPECT_EQ(count_routings(parts, 3, FingerIdentity::identical).all, 10U);  // multisets of 3 of 3
  EXPECT_EQ(count_routings(parts, 3, FingerIdentity::distinct).all, 27U);
  EXPECT_EQ(count_routings(parts, 3, FingerIdentity::identical).one_tendon, 0U);
}

TEST(Counting, NumbersThatDoNotFitAreRefused) {
  EXPECT_EQ(
      testing::input_error([] { count_routings(full_parts(), 64, FingerIdentity::identical); }),
      too_many);
  EXPECT_EQ(
      testing::input_error([] { count_routings(paper_parts(), 30, FingerIdentity::distinct); }),
      too_many);
  EXPECT_EQ(
      testing::input_error([] { tendon_counts(full_parts(), 64, FingerIdentity::identical); }),
      too_many);
}

TEST(Counting, CheckedNumbersThrowInsteadOfWrapping) {
  constexpr std::uint64_t half = std::uint64_t{1} << 62;
  EXPECT_EQ(plus(half, half - 1), 2 * half - 1);
  EXPECT_EQ(testing::input_error([&] { plus(half, half); }), too_many);
  EXPECT_EQ(times(half / 2, 3), half / 2 * 3);
  EXPECT_EQ(testing::input_error([&] { times(half, 2); }), too_many);
  EXPECT_EQ(testing::input_error([&] { times(half, half); }), too_many);
  EXPECT_EQ(power(2, 62), half);
  EXPECT_EQ(testing::input_error([] { power(2, 63); }), too_many);
  EXPECT_EQ(factorial(20), 2432902008176640000U);
  EXPECT_EQ(testing::input_error([] { factorial(21); }), too_many);
}

TEST(Counting, ChoicesOfThings) {
  EXPECT_EQ(binomial(5, 2), 10U);
  EXPECT_EQ(binomial(5, 0), 1U);
  EXPECT_EQ(binomial(2, 3), 0U);
  EXPECT_EQ(binomial(61, 30), 232714176627630544U);
  EXPECT_EQ(multichoose(3, 2), 6U);
  EXPECT_EQ(multichoose(0, 0), 1U);
  EXPECT_EQ(multichoose(0, 2), 0U);
  EXPECT_EQ(power(0, 0), 1U);
}

}  // namespace
}  // namespace reeve
