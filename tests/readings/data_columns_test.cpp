#include "readings/data_columns.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

std::vector<DataColumn> columns(const std::string& header) {
  const CsvReader csv(header + "\n", "d.csv");
  FaultList faults;
  auto found = read_columns(csv, {}, {}, faults).columns;
  faults.throw_any("d.csv");
  return found;
}

std::string error_of(const std::string& header) {
  return testing::input_error([&] { columns(header); });
}

TEST(DataColumns, KnowTheirNames) {
  const auto found = columns(
      "run,routing,held,direction,motor_tension_N,speed_mm_s,cycle,temperature_C,sheath_angle_rad,"
      " T1_N ,humidity");
  ASSERT_EQ(found.size(), 11U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(found[i].role), i) << found[i].name;
  }
}

TEST(DataColumns, NameSegmentsOfEachKind) {
  const auto found = columns("run,routing,T12_N,Ta_N,Taa_N,Th_N,Th1_N");
  const auto is = [&](std::size_t column, SegmentKind kind, int number) {
    EXPECT_EQ(found[column].role, DataRole::tension);
    EXPECT_EQ(found[column].place.segment.kind, kind);
    EXPECT_EQ(found[column].place.segment.number, number);
  };
  is(2, SegmentKind::strand, 12);
  EXPECT_EQ(found[2].place.segment.finger, 6);
  is(3, SegmentKind::motor_side, 1);
  is(4, SegmentKind::motor_side, 27);
  is(5, SegmentKind::motor_side, 8);
  is(6, SegmentKind::hand, 1);
}

TEST(DataColumns, AreCovariatesWhereNothingElse) {
  const auto found = columns("run,routing,T1_N,T1 [°C],T0,Ta,Tmax_N,T_N");
  for (std::size_t i = 3; i < found.size(); ++i) EXPECT_EQ(found[i].role, DataRole::covariate);
}

TEST(BadDataColumn, IsNamed) {
  EXPECT_EQ(error_of("run,routing,T1_N,run"),
            "d.csv:1: column 4 'run': column 1 has that name already");
  for (const std::string name : {"T0_N", "t00 [lbf]", "Th0_N"}) {
    EXPECT_EQ(error_of("run,routing,T2_N," + name),
              "d.csv:1: column 4 '" + name +
                  "': expected a tension written as T1_N (strand), Ta_N (motor-side segment), "
                  "Th1_N (stretch at the hand) or at_T1_N (the motor-side segment at T1)");
  }
}

TEST(MissingDataColumn, IsNamedWithWhatWasExpected) {
  EXPECT_EQ(error_of("routing,T1_N"),
            "d.csv:1: the header has no column 'run': expected a name or number for each run");
  EXPECT_EQ(error_of("run,T1_N"),
            "d.csv:1: the header has no column 'routing': expected a routing in each row");
  EXPECT_EQ(error_of("run,routing,motor_tension_N"),
            "d.csv:1: the header has no column of tensions: expected at least one such as T1_N "
            "(strand), Ta_N (motor-side segment) or Th1_N (stretch at the hand)");
}

}  // namespace
}  // namespace reeve
