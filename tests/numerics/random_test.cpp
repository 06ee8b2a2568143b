#include "numerics/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace reeve {
namespace {

using Words = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

// Philox4x32-10 as the paper defines it (J. K. Salmon et al., SC 2011, section 4.3).
Words philox(Words c, Key key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
    const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
    const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    c = {high(b) ^ c[1] ^ key[0], low(b), high(a) ^ c[3] ^ key[1], low(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return c;
}

// The first 53 of the first 64 bits.
double mapped(const Words& words) {
  const std::uint64_t bits = (std::uint64_t{words[0]} << 32) + words[1];
  return std::ldexp(static_cast<double>(bits >> 11), -53);
}

// The published vectors of Random123 (kat_vectors, philox4x32 10).
TEST(Random, TheTestsPhiloxGivesThePublishedVectors) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// The first published vector, 0x6627e8d5e169c58d: its first 53 bits.
TEST(Random, PinnedValue) {
  EXPECT_EQ(uniform(0, 0, 0), static_cast<double>(0x6627e8d5e169c58dU >> 11) / 9007199254740992.0);
  EXPECT_EQ(uniform(0, 0, 0), 0x1.989fa35785a70p-2);
}

TEST(Random, AllBitsOfSeedStreamAndIndexReachTheGenerator) {
  EXPECT_EQ(uniform(0x299f31d0a4093822, 0x13198a2e, 0x85a308d3243f6a88),
            mapped(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0}, {0xa4093822, 0x299f31d0})));
  EXPECT_EQ(uniform(~std::uint64_t{0}, ~std::uint32_t{0}, ~std::uint64_t{0}),
            mapped(philox({0xffffffff, 0xffffffff, 0xffffffff, 0}, {0xffffffff, 0xffffffff})));

  std::set<double> numbers{uniform(0, 0, 0)};
  for (int bit = 0; bit < 64; ++bit) {
    numbers.insert(uniform(std::uint64_t{1} << bit, 0, 0));
    numbers.insert(uniform(0, 0, std::uint64_t{1} << bit));
    if (bit < 32) numbers.insert(uniform(0, std::uint32_t{1} << bit, 0));
  }
  EXPECT_EQ(numbers.size(), 161U);
}

TEST(Random, ANumberIsAFunctionOfItsArguments) {
  const double first = uniform(7, 3, 41);
  uniform(8, 2, 40);
  EXPECT_EQ(uniform(7, 3, 41), first);
}

constexpr int many = 100000;

TEST(Random, NumbersAreInTheUnitIntervalWithTheRightMeanAndVariance) {
  for (const std::uint32_t stream : {0U, 1U, 4000000000U}) {
    double sum = 0;
    double squares = 0;
    for (std::uint64_t i = 0; i < many; ++i) {
      const double x = uniform(42, stream, i);
      ASSERT_GE(x, 0);
      ASSERT_LT(x, 1);
      sum += x;
      squares += (x - 0.5) * (x - 0.5);
    }
    // The variances of x and of (x - 1/2)^2 are 1/12 and 1/180.
    EXPECT_NEAR(sum / many, 1.0 / 2, 4 * std::sqrt(1.0 / 12 / many));
    EXPECT_NEAR(squares / many, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / many));
  }
}

TEST(Random, SeedsStreamsAndNeighboursAreNotCorrelated) {
  double seeds = 0;
  double streams = 0;
  double neighbours = 0;
  for (std::uint64_t i = 0; i < many; ++i) {
    const double x = uniform(42, 0, i) - 0.5;
    seeds += x * (uniform(43, 0, i) - 0.5);
    streams += x * (uniform(42, 1, i) - 0.5);
    neighbours += x * (uniform(42, 0, i + 1) - 0.5);
  }
  const double four_sigma = 4.0 / 12 / std::sqrt(many);
  EXPECT_NEAR(seeds / many, 0, four_sigma);
  EXPECT_NEAR(streams / many, 0, four_sigma);
  EXPECT_NEAR(neighbours / many, 0, four_sigma);
}

TEST(Random, NormalsAreAFunctionOfTheirArguments) {
  const double first = normal(7, 3, 41);
  normal(8, 2, 40);
  EXPECT_EQ(normal(7, 3, 41), first);
  EXPECT_NE(normal(8, 3, 41), first);
  EXPECT_NE(normal(7, 2, 41), first);
  EXPECT_NE(normal(7, 3, 40), first);
}

TEST(Random, NormalsHaveTheMomentsOfTheStandardNormal) {
  for (const std::uint32_t stream : {0U, 1U, 4000000000U}) {
    std::array<double, 4> moments{};
    for (std::uint64_t i = 0; i < many; ++i) {
      const double z = normal(42, stream, i);
      double power = 1;
      for (double& moment : moments) moment += power *= z;
    }
    // The variances of z, z^2, z^3 and z^4 are 1, 2, 15 and 96.
    const double sigma = 1 / std::sqrt(many);
    EXPECT_NEAR(moments[0] / many, 0, 4 * sigma);
    EXPECT_NEAR(moments[1] / many, 1, 4 * std::sqrt(2) * sigma);
    EXPECT_NEAR(moments[2] / many, 0, 4 * std::sqrt(15) * sigma);
    EXPECT_NEAR(moments[3] / many, 3, 4 * std::sqrt(96) * sigma);
  }
}

TEST(Random, NormalsHaveTheTailsOfTheStandardNormal) {
  for (const double beyond : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    const double expected = std::erfc(beyond / std::sqrt(2)) / 2;
    const double four_sigma = 4 * std::sqrt(expected / many);
    int above = 0;
    int below = 0;
    for (std::uint64_t i = 0; i < many; ++i) {
      const double z = normal(43, 5, i);
      above += z > beyond ? 1 : 0;
      below += z < -beyond ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(above) / many, expected, four_sigma) << beyond;
    EXPECT_NEAR(static_cast<double>(below) / many, expected, four_sigma) << beyond;
  }
}

TEST(Random, NormalsOfSeedsStreamsAndNeighboursAreNotCorrelated) {
  std::array<double, 4> sums{};
  for (std::uint64_t i = 0; i < many; ++i) {
    const double z = normal(42, 0, i);
    sums[0] += z * normal(43, 0, i);
    sums[1] += z * normal(42, 1, i);
    sums[2] += z * normal(42, 0, i + 1);
    sums[3] += z * (uniform(42, 0, i) - 0.5) * std::sqrt(12);
  }
  for (const double sum : sums) EXPECT_NEAR(sum / many, 0, 4 / std::sqrt(many));
}

// Across 2^32, where the second word of the counter begins to count.
TEST(Random, UniformNumbersBelowABoundAreFoundInARange) {
  const std::uint64_t begin = (std::uint64_t{1} << 32) - 5000;
  for (const double bound : {0.0, 1e-9, 0.001, 0.4, 1.0}) {
    std::vector<std::uint64_t> expected;
    for (std::uint64_t i = begin; i < begin + 10000; ++i) {
      if (uniform(3, 5, i) < bound) expected.push_back(i);
    }
    EXPECT_EQ(uniform_below(bound, 3, 5, begin, begin + 10000), expected) << bound;
  }
}

}  // namespace
}  // namespace reeve
