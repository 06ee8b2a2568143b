#include "readings/measured_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

const std::string shares_header = "run,routing,held,direction,T1_N,T2_N,T3_N,T4_N\n";

TEST(MeasuredShares, AreTheMeansOfTheReadingsOfARoutingInAGrasp) {
  const SharesOfData shares = measured_shares(read_data(
      shares_header + "1,TR5,1,,6,2,1,1\n2,TR5,1,,8,8,2,2\n2,TR5,2,,1,1,1,1\n2,TR3,1,,1,1,1,1\n"));
  ASSERT_EQ(shares.groups.size(), 3U);
  EXPECT_TRUE(shares.notes.empty());
  const MeasuredShares& first = shares.groups[0];
  EXPECT_EQ(first.readings, 2U);
  EXPECT_EQ(first.grasp, hold({1}));
  const std::vector<double> mean{0.5, 0.3, 0.1, 0.1};
  ASSERT_EQ(first.mean.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(first.mean[i], mean[i], 1e-12);
  // 0.6 and 0.4, 0.2 and 0.4.
  EXPECT_NEAR(first.deviation[0], std::sqrt(0.02), 1e-12);
  EXPECT_NEAR(first.deviation[1], std::sqrt(0.02), 1e-12);
  EXPECT_NEAR(first.deviation[2], 0, 1e-12);
  EXPECT_TRUE(shares.groups[1].deviation.empty());
}

// A tendon that is tied to its finger has one strand.
TEST(MeasuredShares, AreOfTheStrandsThatTheRoutingHas) {
  const SharesOfData shares =
      measured_shares(read_data("run,routing,held,T1_N,T3_N\n1,M-1x+M-2x,none,3,1\n"));
  ASSERT_EQ(shares.groups.size(), 1U);
  EXPECT_EQ(shares.groups[0].mean, (std::vector<double>{0.75, 0.25}));
}

TEST(MeasuredShares, NeedAllStrandsPulledAndNotAllSlack) {
  const SharesOfData shares = measured_shares(
      read_data(shares_header +
                "1,TR5,1,release,6,2,1,1\n1,TR5,1,,6,,1,1\n1,TR5,1,,0,0,0,0\n1,TR5,1,,6,2,1,1\n"));
  ASSERT_EQ(shares.groups.size(), 1U);
  EXPECT_EQ(shares.groups[0].readings, 1U);
  ASSERT_EQ(shares.notes.size(), 2U);
  EXPECT_EQ(shares.notes[0].lines, std::vector<std::size_t>{2});
  EXPECT_EQ(shares.notes[1].lines, (std::vector<std::size_t>{3, 4}));
}

}  // namespace
}  // namespace reeve::testing
