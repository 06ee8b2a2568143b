#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "readings/data_columns.hpp"
#include "readings/reading_options.hpp"
#include "tests/readings/read_data.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

std::vector<DataColumn> columns(const std::string& header) {
  const CsvReader csv(header + "\n", "d.csv");
  FaultList faults;
  auto found = read_columns(csv, {}, {}, faults).columns;
  faults.throw_any("d.csv");
  return found;
}

std::string error_of(const std::string& header) {
  return input_error([&] { columns(header); });
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

using Lines = std::vector<std::size_t>;

std::string error_with_map(const std::string& header, std::vector<ColumnMeaning> map) {
  const CsvReader csv(header + "\n", "d.csv");
  ReadingOptions options;
  options.map_option = "--map";
  options.map = std::move(map);
  FaultList faults;
  read_columns(csv, {}, options, faults);
  return input_error([&] { faults.throw_any("d.csv"); });
}

// As a covariate, each of them would say something else of all rows.
TEST(AColumnThatMayBeKnown, MustBeSaidToBeItOrNone) {
  const std::string start = "run,routing,T1_N,";
  const std::string no_error = "no such error was thrown";
  EXPECT_EQ(error_with_map(start + "Richtung", {}),
            "d.csv:1: column 4 'Richtung': expected its meaning, which may be direction: --map "
            "'Richtung=direction', or --map 'Richtung=Richtung' if it is none");
  for (const std::string column : {"gehaltene Finger", "Motorkraft / N", "Kraft 3 [N]"}) {
    EXPECT_NE(error_with_map(start + column, {}).find("which may be"), std::string::npos);
    EXPECT_EQ(error_with_map(start + column, {{column, column}}), no_error);
  }
  // Known already, no strand, no force, and nothing that every row hangs on.
  EXPECT_EQ(error_with_map(start + "motor_tension_N,Motorkraft [N],Kraft 1 [N],load [kg]", {}),
            no_error);
  EXPECT_EQ(error_with_map(start + "load_cell_2_temp_C,plastic 3,Temperatur,Zyklus", {}), no_error);
}

TEST(AMissingColumn, IsMappedToWhatMayBeIt) {
  const std::string error = error_with_map("Versuch,Verlegung,T1_N", {});
  EXPECT_NE(error.find("name it with --map 'Versuch=run'"), std::string::npos) << error;
  EXPECT_NE(error.find("name it with --map 'Verlegung=routing'"), std::string::npos) << error;
}

TEST(DataColumns, HaveUnitsBehindASlashOrIn) {
  const auto found = columns("run,routing,T1 / kgf,T2 in N,Ta / N,humidity in pct,T3 / T1");
  EXPECT_EQ(found[2].role, DataRole::tension);
  EXPECT_EQ(std::string(found[2].unit.name), "kgf");
  EXPECT_EQ(found[3].role, DataRole::tension);
  EXPECT_EQ(found[4].role, DataRole::tension);
  EXPECT_EQ(found[5].role, DataRole::covariate);
  EXPECT_EQ(found[6].role, DataRole::covariate);
}

TEST(ARowOfUnits, IsNoReadingAndIsNoted) {
  const MeasuredData data =
      read_data("run,routing,speed,T1,Ta,humidity,time\n-,-,m/s,lbf,N,%RH,s\nA,TR5,0.5,2,3,40,7\n");
  EXPECT_EQ(noted_lines(data.notes, NoteKind::passed_over), Lines{2});
  EXPECT_EQ(data.readings[0].speed_mm_s, 500);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[0], 2 * 4.4482216152605);
  EXPECT_EQ(data.channels[1].name, "a");
  EXPECT_EQ(note_text(data.notes, NoteKind::column_names),
            "columns are read so: 'speed' as speed_mm_s (from m/s), 'T1' as T1_N (from lbf), 'Ta' "
            "as Ta_N");
}

// A reading whose tensions are all missing is one, if a bad one.
TEST(ARowOfUnits, HasNoRoutingAndNoNumber) {
  EXPECT_EQ(data_error("run,routing,T1_N\nA,TR5,N\n"),
            "d.csv:2: column 'T1_N' = 'N': expected a number from -1000000000 to 1000000000, or an "
            "empty cell");
  EXPECT_EQ(data_error("run,routing,T1_N,T2_N\n,,N,3\nA,TR5,1,2\n").substr(0, 15),
            "d.csv: 3 faults");
}

TEST(ARowOfUnits, MustAgreeWithTheNames) {
  EXPECT_EQ(data_error("run,routing,T1_N\n-,-,lbf\nA,TR5,1\n"),
            "d.csv:1: column 3 'T1_N': expected one unit: the name says N, and line 2 says lbf");
  EXPECT_EQ(data_error("run,routing,T1_N,T2\n-,-,N,rpm\nA,TR5,1,1\n"),
            "d.csv:1: column 4 'T2': expected a unit of force (N, mN, cN, daN, kN, gf, kgf, lbf, "
            "ozf), and line 2 says 'rpm'");
}

TEST(AMissingUnit, IsAssumedAndNoted) {
  const MeasuredData data = read_data("run,routing,T1,T2_N\nA,TR5,4,3\n");
  EXPECT_EQ(note_text(data.notes, NoteKind::column_names),
            "columns are read so: 'T1' as T1_N (no unit is said: N is assumed)");
  EXPECT_EQ(count_notes(read_data("run,routing,T1_N\nA,TR5,4\n").notes, NoteKind::column_names),
            0U);
}

TEST(AUnitThatIsGiven, IsOfAllTensionsOrOfOneColumn) {
  const std::string text = "run,routing,speed_mm_s,motor_tension_N,T1,T2\nA,TR5,7,2,1,1\n";
  ReadingOptions options;
  options.units = {parse_column_unit("kgf"), parse_column_unit("T2=lbf"),
                   parse_column_unit("speed=m/s")};
  const MeasuredData data = read_data(text, options);
  EXPECT_EQ(data.readings[0].speed_mm_s, 7000);
  EXPECT_DOUBLE_EQ(*data.readings[0].motor_tension_N, 2 * 9.80665);
  ASSERT_EQ(data.channels.size(), 2U);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[0], 9.80665);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[1], 4.4482216152605);
  EXPECT_EQ(
      note_text(data.notes, NoteKind::column_names),
      "columns are read so: 'speed_mm_s' as speed_mm_s (from m/s), though its name says mm/s, "
      "'motor_tension_N' as motor_tension_N (from kgf), though its name says N, 'T1' as T1_N "
      "(from kgf), 'T2' as T2_N (from lbf)");
}

TEST(AUnitThatIsGiven, MustBeOneOfItsColumn) {
  EXPECT_EQ(data_error("run,routing,T1\nA,TR5,1\n", {{}, {{"T1", "m/s"}}, {}}),
            "d.csv:1: column 3 'T1': expected a unit of force (N, mN, cN, daN, kN, gf, kgf, lbf, "
            "ozf), and 'm/s' is given");
  EXPECT_EQ(data_error("run,routing,T1\nA,TR5,1\n", {{}, {{"T9", "lbf"}}, {}}),
            "d.csv:1: the header has no column 'T9': expected the column that is in lbf");
}

TEST(Limits, AreThoseOfTheFilesUnit) {
  EXPECT_EQ(
      data_error("run,routing,temperature_F,T1\nA,TR5,-500,1\n"),
      "d.csv:2: column 'temperature_F' = '-500': expected a number from -459.66999999999996 to "
      "18032, or an empty cell");
}

TEST(AColumnThatIsMapped, IsReadAsWhatItMeans) {
  ReadingOptions options;
  options.map = {parse_column_meaning("Kraft Motor=motor_tension_N"),
                 parse_column_meaning("F=1=T1 [lbf]"), parse_column_meaning("Versuch=run")};
  const MeasuredData data = read_data("Versuch,routing,Kraft Motor,F=1\nA,TR5,20,2\n", options);
  EXPECT_EQ(data.readings[0].motor_tension_N, 20);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[0], 2 * 4.4482216152605);
  EXPECT_EQ(data_error("run,routing,T1_N\nA,TR5,1\n", {{{"Kraft", "T2_N"}}, {}, {}}),
            "d.csv:1: the header has no column 'Kraft': expected the column that means T2_N");
}

TEST(AColumnThatIsMapped, KeepsTheUnitOfItsName) {
  for (const char* name :
       {"Kraft Motor [kgf]", "Kraft [kgf] Motor", "Kraft (kg)", "Motor kg", "F_kgf", "Kraft/kgf"}) {
    for (const char* meaning : {"motor_tension", "motor_tension_kgf"}) {
      const MeasuredData data = read_data("run,routing,T1_N," + std::string(name) + "\nA,TR5,1,2\n",
                                          {.map = {{name, meaning}}, .units = {}, .group = {}});
      EXPECT_EQ(data.readings[0].motor_tension_N, 2 * 9.80665) << name;
      EXPECT_EQ(note_text(data.notes, NoteKind::column_names),
                "columns are read so: '" + std::string(name) + "' as motor_tension_N (from kgf)");
    }
  }
  ReadingOptions options;
  options.map = {{"Kraft [g]", "T1"}, {"v_m_s", "speed"}, {"Kraft A [lbf]", "Ta"}};
  const MeasuredData data =
      read_data("run,routing,Kraft [g],v_m_s,Kraft A [lbf]\nA,TR5,1000,2,1\n", options);
  ASSERT_EQ(data.channels.size(), 2U);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[0], 9.80665);
  EXPECT_DOUBLE_EQ(*data.readings[0].tension_N[1], 4.4482216152605);
  EXPECT_EQ(data.readings[0].speed_mm_s, 2000);
}

TEST(AColumnThatIsMapped, HasNoUnitOfALetterOrAWordThatIsNone) {
  for (const char* name : {"Kraft G", "Sensor n", "pull in", "kgf"}) {
    const MeasuredData data = read_data("run,routing," + std::string(name) + "\nA,TR5,2\n",
                                        {.map = {{name, "T1"}}, .units = {}, .group = {}});
    EXPECT_EQ(data.readings[0].tension_N[0], 2) << name;
    EXPECT_NE(note_text(data.notes, NoteKind::column_names).find("N is assumed"),
              std::string::npos);
  }
}

TEST(AColumnThatIsMapped, IsNotGivenAnotherUnitThanItsNameSays) {
  const std::string text = "run,routing,T1_N,Kraft [kgf]\nA,TR5,1,2\n";
  ReadingOptions options;
  options.map = {{"Kraft [kgf]", "motor_tension_N"}};
  EXPECT_EQ(data_error(text, options),
            "d.csv:1: column 4 'Kraft [kgf]': expected one unit: the name says kgf, and the "
            "meaning that it is given N");
  options.units = {{"Kraft [kgf]", "N"}};
  const MeasuredData data = read_data(text, options);
  EXPECT_EQ(data.readings[0].motor_tension_N, 2);
  EXPECT_EQ(note_text(data.notes, NoteKind::column_names),
            "columns are read so: 'Kraft [kgf]' as motor_tension_N, though its name says kgf");
}

TEST(AColumnThatIsMapped, AgreesWithTheRowOfUnits) {
  EXPECT_EQ(data_error("run,routing,T1_N,Kraft [kgf]\n-,-,N,N\nA,TR5,1,2\n",
                       {.map = {{"Kraft [kgf]", "motor_tension"}}, .units = {}, .group = {}}),
            "d.csv:1: column 4 'Kraft [kgf]': expected one unit: the name says kgf, and line 2 "
            "says N");
}

TEST(AColumnThatIsMapped, IsNoneOfALog) {
  EXPECT_EQ(
      data_error("run,routing,Zeit,T1_N\nA,TR5,1,2\n", {{{"Zeit", "time_s"}}, {}, {}}),
      "d.csv:1: column 3 'Zeit': expected a meaning that columns of readings have, and time_s "
      "is of the log of a rig");
}

TEST(ReadingOptions, AreReadFromWordsOrRefused) {
  EXPECT_EQ(parse_column_meaning("Motor [N]=Motor [N]").meaning, "Motor [N]");
  for (const char* text : {"a", "=T1_N", "a=", "a=nothing"}) {
    EXPECT_EQ(input_error([&] { parse_column_meaning(text); }),
              "'" + std::string(text) +
                  "': expected a column of the file, '=', and a name that reeve knows, such as "
                  "'Kraft Motor=motor_tension_N'");
  }
  for (const char* text : {"", "stone", "=N", "T1=", "m/s"}) {
    EXPECT_EQ(
        input_error([&] { parse_column_unit(text); }),
        "'" + std::string(text) +
            "': expected a unit of force (N, mN, cN, daN, kN, gf, kgf, lbf, ozf), or a column, "
            "'=' and its unit, such as T1=kgf");
  }
}

}  // namespace
}  // namespace reeve::testing
