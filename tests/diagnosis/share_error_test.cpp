#include "diagnosis/verdict/share_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

// Forecasts for T1 … T4; those of the runs left out are others too.
struct Forecasts {
  std::vector<double> before, after, left_out;
};

// Every cell with the same forecasts, times scales that shares do not see.
std::vector<ComparedCell> compared(const MeasuredData& data, const Forecasts& forecasts) {
  std::vector<ComparedCell> cells = cells_as_measured(data);
  for (ComparedCell& cell : cells) {
    cell.before_N = forecasts.before[cell.cell.channel];
    cell.after_N = 3 * forecasts.after[cell.cell.channel];
    cell.left_out_N = 5 * forecasts.left_out[cell.cell.channel];
  }
  return cells;
}

const Forecasts all_alike{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}};

TEST(ShareErrors, AreRootSumSquaresOverTheStrandsAndMeansOverTheRoutings) {
  const MeasuredData data = read_data(
      "run,routing,held,T1_N,T2_N,T3_N,T4_N\n"
      "1,TR3,1,40,30,20,10\n"
      "2,TR3,1,4,3,2,1\n"
      "3,TR5,1,25,25,25,25\n");
  const Forecasts forecasts{{1, 1, 1, 1}, {0.4, 0.3, 0.2, 0.1}, {0.4, 0.2, 0.3, 0.1}};
  const ShareErrors errors = share_errors(data, compared(data, forecasts));
  ASSERT_EQ(errors.groups.size(), 2U);
  const double off = std::sqrt(0.15 * 0.15 + 0.05 * 0.05 + 0.05 * 0.05 + 0.15 * 0.15);
  const double exchanged = std::sqrt(0.1 * 0.1 + 0.1 * 0.1);
  EXPECT_EQ(errors.groups[0].rows, 2U);
  EXPECT_NEAR(errors.groups[0].before, off, 1e-12);
  EXPECT_NEAR(errors.groups[0].after, 0, 1e-12);
  EXPECT_NEAR(errors.groups[1].before, 0, 1e-12);
  EXPECT_NEAR(errors.groups[1].after, off, 1e-12);
  EXPECT_NEAR(*errors.groups[0].left_out, exchanged, 1e-12);
  EXPECT_NEAR(*errors.groups[1].left_out, off, 1e-12);
  // Over the routings, not over the rows.
  EXPECT_NEAR(errors.before, off / 2, 1e-12);
  EXPECT_NEAR(errors.after, off / 2, 1e-12);
  EXPECT_NEAR(*errors.left_out, (exchanged + off) / 2, 1e-12);
}

TEST(ShareErrors, NeedAllStrandsOfAPulledRow) {
  const MeasuredData data = read_data(
      "run,routing,direction,T1_N,T2_N,T3_N,T4_N\n"
      "1,TR3,pull,40,30,20,\n"
      "1,TR3,release,40,30,20,10\n");
  EXPECT_TRUE(share_errors(data, compared(data, all_alike)).groups.empty());
}

TEST(ShareErrors, OfRunsLeftOutAreThereOnlyIfAllAre) {
  const MeasuredData data =
      read_data("run,routing,T1_N,T2_N,T3_N,T4_N\n1,TR3,40,30,20,10\n2,TR5,25,25,25,25\n");
  std::vector<ComparedCell> cells = compared(data, all_alike);
  for (ComparedCell& cell : cells) {
    if (cell.cell.reading == 1) cell.left_out_N.reset();
  }
  const ShareErrors errors = share_errors(data, cells);
  EXPECT_TRUE(errors.groups[0].left_out.has_value());
  EXPECT_FALSE(errors.groups[1].left_out.has_value());
  EXPECT_FALSE(errors.left_out.has_value());
}

TEST(ShareErrors, AreOfStrandsAlone) {
  const MeasuredData data =
      read_data("run,routing,Ta_N,T1_N,T2_N,T3_N,T4_N\n1,TR3,80,40,30,20,10\n");
  const Forecasts forecasts{{1, 4, 3, 2, 1}, {1, 40, 30, 20, 10}, {1, 4, 3, 2, 1}};
  const ShareErrors errors = share_errors(data, compared(data, forecasts));
  ASSERT_EQ(errors.groups.size(), 1U);
  EXPECT_NEAR(errors.before, 0, 1e-12);
}

TEST(ShareErrors, AreOfEachGraspByItself) {
  const MeasuredData data = read_data(
      "run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,TR3,1,40,30,20,10\n1,TR3,2,40,30,20,10\n"
      "2,TR3,2,40,30,20,10\n");
  std::vector<ComparedCell> cells = compared(data, all_alike);
  for (ComparedCell& cell : cells) cell.held_out = cell.cell.reading == 2;
  const ShareErrors errors = share_errors(data, cells);
  ASSERT_EQ(errors.groups.size(), 2U);
  EXPECT_EQ(errors.groups[0].grasp, hold({1}));
  EXPECT_EQ(errors.groups[1].rows, 2U);
  EXPECT_EQ(errors.groups[0].held_out_rows, 0U);
  EXPECT_EQ(errors.groups[1].held_out_rows, 1U);
}

}  // namespace
}  // namespace reeve::testing
