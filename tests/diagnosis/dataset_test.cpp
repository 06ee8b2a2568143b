#include "diagnosis/dataset.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

const std::string dataset_header =
    "run,routing,held,direction,motor_tension_N,sheath_angle_rad,T1_N,T2_N,Ta_N\n";

TEST(Dataset, HasACellForEveryMeasuredTensionByRow) {
  const MeasuredData data = read_data(dataset_header +
                                      "1,M-1-F,,,10,,3,2,\n"
                                      "1,M-1-F,,,20,,6,,19\n");
  const Dataset dataset = reeve::dataset(data, {0, 1});
  ASSERT_EQ(dataset.rows.size(), 2U);
  ASSERT_EQ(dataset.cells.size(), 4U);
  EXPECT_EQ(dataset.rows[1].first, 2U);
  EXPECT_EQ(dataset.rows[1].last, 4U);
  EXPECT_EQ(dataset.cells[3].measured_N, 19);
  EXPECT_EQ(dataset.cells[3].channel, 2U);
  EXPECT_EQ(segment_name(data.routings[0].network.segments[dataset.cells[3].segment]), "a");
  EXPECT_EQ(dataset.rows[1].conditions.motor_tension_N, 20);
}

TEST(Dataset, IsOfTheReadingsAskedFor) {
  const MeasuredData data = read_data(dataset_header + "1,M-1-F,,,10,,3,,\n2,M-1-F,,,20,,6,,\n");
  const Dataset dataset = reeve::dataset(data, {1});
  ASSERT_EQ(dataset.rows.size(), 1U);
  EXPECT_EQ(dataset.rows[0].reading, 1U);
}

TEST(Dataset, GroupsWhatSharesANetworkAndItsAngle) {
  const MeasuredData data = read_data(dataset_header +
                                      "1,M-1-F,,,10,,3,2,\n"
                                      "2,M-1-F,,,30,,9,6,\n"
                                      "2,M-1-F,1,,30,,9,6,\n"
                                      "2,M-1-F,,release,30,,9,6,\n"
                                      "2,M-1-F,,,30,3,9,6,\n"
                                      "2,M-1-M,,,30,,9,6,\n");
  const Dataset dataset = reeve::dataset(data, {0, 1, 2, 3, 4, 5});
  ASSERT_EQ(dataset.blocks.size(), 5U);
  EXPECT_EQ(dataset.blocks[0].rows, (std::vector<std::size_t>{0, 1}));
}

// Without motor tension the sum of a row says nothing.
TEST(Dataset, LosesADegreeOfFreedomForEachFreeScale) {
  const MeasuredData data = read_data(dataset_header +
                                      "1,M-1-F,,,10,,3,2,\n"
                                      "1,M-1-F,,,,,3,2,\n"
                                      "1,M-1-F,,,,,3,2,9\n");
  const Dataset dataset = reeve::dataset(data, {0, 1, 2});
  EXPECT_EQ(dataset.cells.size(), 7U);
  EXPECT_EQ(dataset.degrees_of_freedom(), 5);
  EXPECT_TRUE(dataset.rows[0].has_motor_tension);
  EXPECT_FALSE(dataset.rows[1].has_motor_tension);
}

TEST(Dataset, LeavesOutRowsThatSayNothing) {
  const MeasuredData data = read_data(dataset_header +
                                      "1,M-1-F,,,0,,3,2,\n"    // nothing pulls
                                      "1,M-1-F,,,,,3,,\n"      // one tension of unknown scale
                                      "1,M-1-F,,,,,0,0,\n"     // both slack
                                      "1,M-1-F,,,,,0,2,\n"     // one of two slack
                                      "1,M-1-F,,,10,,0,,\n");  // a slack one of known scale
  const Dataset dataset = reeve::dataset(data, {0, 1, 2, 3, 4});
  ASSERT_EQ(dataset.rows.size(), 2U);
  EXPECT_EQ(dataset.rows[0].reading, 3U);
  EXPECT_EQ(dataset.rows[1].reading, 4U);
}

TEST(Survey, KnowsWhatTheDataHave) {
  const MeasuredData data = read_data(
      "run,routing,held,motor_tension_N,speed_mm_s,cycle,T1_N\n"
      "1,M-1-F,1,10,,4,3\n2,M-1-F,,10,,,3\n3,M-1-F,1,10,,,4\n");
  const Survey survey = reeve::survey(data);
  ASSERT_EQ(survey.routings.size(), 1U);
  EXPECT_EQ(survey.routings[0].recorded, (std::vector<Grasp>{hold({1}), Grasp{}}));
  EXPECT_EQ(survey.channels.size(), 1U);
  EXPECT_TRUE(survey.has_cycle);
  EXPECT_FALSE(survey.has_speed);
  EXPECT_FALSE(survey.has_temperature);
  EXPECT_FALSE(survey.sheath_angle_varies);
  EXPECT_TRUE(survey.has_motor_tension);
  EXPECT_FALSE(survey.has_both_directions);
}

TEST(Survey, KnowsChannelsWithReadingsFarApart) {
  const MeasuredData data =
      read_data("run,routing,T1_N,T2_N,T3_N\n1,M-1-T-2-F,10,10,10\n1,M-1-T-2-F,5,4.9,\n");
  const Survey survey = reeve::survey(data);
  ASSERT_EQ(survey.wide_channels.size(), 1U);
  EXPECT_EQ(segment_name(survey.wide_channels[0]), "T2");
}

// Negative readings are no data yet (docs/data.md); who has them is asked for dead zones.
TEST(Survey, KnowsWhetherSensorsReadBelowZero) {
  MeasuredData data = read_data("run,routing,T1_N,T2_N\n1,M-1-T-2-F,10,\n1,M-1-T-2-F,0,2\n");
  EXPECT_FALSE(survey(data).reads_below_zero);
  data.readings[1].tension_N[0] = -0.1;
  EXPECT_TRUE(survey(data).reads_below_zero);
}

TEST(Survey, KnowsWhetherDirectionAndSheathAngleVary) {
  const auto of = [](const std::string& rows) {
    return reeve::survey(read_data("run,routing,direction,sheath_angle_rad,T1_N,T2_N\n" + rows));
  };
  EXPECT_FALSE(of("1,M-1-F,release,3,1,1\n1,M-1-F,release,3,2,2\n").has_both_directions);
  EXPECT_TRUE(of("1,M-1-F,release,3,1,1\n1,M-1-F,pull,3,2,2\n").has_both_directions);
  EXPECT_FALSE(of("1,M-1-F,,3,1,1\n1,M-1-F,,3,2,2\n").sheath_angle_varies);
  EXPECT_TRUE(of("1,M-1-F,,3,1,1\n1,M-1-F,,,2,2\n").sheath_angle_varies);
  EXPECT_FALSE(of("1,M-1-F,,3,1,1\n").has_motor_tension);
}

}  // namespace
}  // namespace reeve::testing
