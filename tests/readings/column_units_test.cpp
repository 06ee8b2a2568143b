// Which unit a column is in, and what it means, by the file and by who reads it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "readings/reading_options.hpp"
#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

using Lines = std::vector<std::size_t>;

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

TEST(AUnitThatNobodySays, IsAssumedAndNoted) {
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
