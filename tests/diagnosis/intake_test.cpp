// What a logger's file may look like, and what is made of it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/data/intake/reading_options.hpp"
#include "tests/diagnosis/read_data.hpp"

namespace reeve::testing {
namespace {

using Lines = std::vector<std::size_t>;

std::vector<double> first_row(const std::string& text, const ReadingOptions& options = {}) {
  const MeasuredData data = read_data(text, options);
  std::vector<double> values{data.readings.at(0).motor_tension_N.value_or(-99)};
  for (const auto& tension : data.readings[0].tension_N) values.push_back(tension.value_or(-99));
  return values;
}

const std::vector<double> twenty_four_three{20, 4, 3};

// Each row of the table in docs/data.md.
TEST(ALoggersFile, IsReadWhateverItsFormLooksLike) {
  for (const char* text : {
           "run,routing,motor_tension_N,T1_N,T2_N\nA,TR5,20,4,3\n",
           "\xEF\xBB\xBFrun,routing,motor_tension_N,T1_N,T2_N\r\nA,TR5,20,4,3\r\n",
           "run\trouting\tmotor_tension_N\tT1_N\tT2_N\nA\tTR5\t20,0\t4,0\t3,0\n",
           "run;routing;motor_tension_N;T1_N;T2_N\nA;TR5;20,0;4,0;3,0\n",
           "Run,Routing,Motor Tension,T1,t2_n\nA,TR5,20,4,3\n",
           "run,routing,Motor Tension [N],T1 (N),T2 [N]\nA,TR5,20,4,3\n",
           "run,routing,motor_tension_N,T1_N,T2_N,,\nA,TR5,20,4,3,,\n",
           "run,routing,motor_tension_N,T1_N,T2_N,\nA,TR5,20,4,3\n",
           "run,routing,motor_tension_N,T1_N,T2_N\nA,TR5,20,4,3,,\n,,,,\n",
           "run,routing,motor_tension_N,T1_N,T2_N\n-,-,N,N,N\nA,TR5,20,4,3\n",
           "run,routing,held,motor_tension,T1,T2\n,[-],,[N],[mN],[kN]\nA,TR5,-,20,4000,0.003\n",
           ",run,routing,motor_tension_N,T1_N,T2_N\n0,A,TR5,20,4,3\n",
       }) {
    EXPECT_EQ(first_row(text), twenty_four_three) << text;
  }
}

TEST(ALoggersFile, MayWriteInManyWaysThatANumberIsMissing) {
  for (const char* missing : {"", "-", "--", "NaN", "nan", "NA", "n/a", "#N/A", "NULL"}) {
    const std::string cell(missing);
    const MeasuredData data =
        read_data("run,routing,held,direction,speed_mm_s,T1_N,T2_N,x\nA,TR5," + cell + "," + cell +
                  "," + cell + ",4," + cell + "," + cell + "\n");
    EXPECT_FALSE(data.readings[0].tension_N[1]) << missing;
    EXPECT_FALSE(data.readings[0].speed_mm_s) << missing;
    EXPECT_FALSE(data.readings[0].covariates[0]) << missing;
    EXPECT_EQ(data.readings[0].direction, Direction::pull);
  }
}

TEST(ASpreadsheetsOwnFile, IsRefusedByName) {
  EXPECT_EQ(data_error("PK\x03\x04..."),
            "d.csv: is a workbook of a spreadsheet (.xlsx, .ods or another zip archive), not text: "
            "expected its sheet saved as CSV");
  EXPECT_EQ(data_error("\xD0\xCF\x11\xE0..."),
            "d.csv: is a workbook of a spreadsheet (.xls), not text: expected its sheet saved as "
            "CSV");
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

TEST(TwoColumnsOfOneMeaning, AreRefusedByName) {
  EXPECT_EQ(data_error("run,routing,T1_N,T1 [lbf]\nA,TR5,1,2\n"),
            "d.csv:1: column 4 'T1 [lbf]': expected one column of its meaning, and column 3 'T1_N' "
            "has it");
  EXPECT_EQ(
      data_error("run,routing,T1_N,Run\nA,TR5,1,2\n"),
      "d.csv:1: column 4 'Run': expected one column of its meaning, and column 1 'run' has it");
}

TEST(AColumnOfWords, IsPassedOverAndNoted) {
  const MeasuredData data =
      read_data("run,routing,x,operator,T1_N,y\nA,TR5,1,Ann,1,5\nA,TR5,,\"Bob, 3\",2,6\n");
  EXPECT_EQ(data.covariates, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(data.readings[1].covariates, (std::vector<std::optional<double>>{{}, 6}));
  EXPECT_EQ(note_text(data.notes, NoteKind::passed_over),
            "column 'operator' has words and is none that is known: it is not read");
}

TEST(AColumnOfNumbers, MayHaveNoWords) {
  EXPECT_EQ(data_error("run,routing,x,T1_N\nA,TR5,1,1\nA,TR5,4O,2\n"),
            "d.csv:3: column 'x' = '4O': expected a finite number such as 12.5, or an empty cell");
}

TEST(WordsWithCommas, AreNoDecimalCommas) {
  EXPECT_EQ(first_row("run;routing;note;T1_N;T2_N\nA;TR5;slow, oiled;1.5;2.5\n"),
            (std::vector<double>{-99, 1.5, 2.5}));
}

TEST(CellsWithoutAColumn, AreNoted) {
  const MeasuredData data = read_data("run,routing,T1_N,,\nA,TR5,1,,\nA,TR5,2,7,\n");
  EXPECT_EQ(noted_lines(data.notes, NoteKind::passed_over), Lines{3});
}

TEST(ARowOfZeros, IsTakenOffTheReadingsBelow) {
  const std::string header = "run,routing,motor_tension_N,T1_N,T2_N\n";
  const MeasuredData data = read_data(header +
                                      "A,TR5,20,4,3\n"
                                      "tare,,1,0.5,\n"
                                      "A,TR5,20,4,3\n"
                                      "A,Tare,2,-0.25,1\n"
                                      "A,tare,4,-0.75,\n"
                                      "A,TR5,20,4,3\n");
  ASSERT_EQ(data.readings.size(), 3U);
  const auto expect = [&](std::size_t reading, double motor, double first, double second) {
    EXPECT_EQ(data.readings[reading].motor_tension_N, motor);
    EXPECT_EQ(data.readings[reading].tension_N,
              (std::vector<std::optional<double>>{first, second}));
  };
  expect(0, 20, 4, 3);
  expect(1, 19, 3.5, 3);
  expect(2, 17, 4.5, 2);  // the mean of two rows of zeros, and the one of the two that has it
  EXPECT_EQ(noted_lines(data.notes, NoteKind::tare), (Lines{3, 5, 6}));
  EXPECT_EQ(data.runs, std::vector<std::string>{"A"});
}

TEST(SamplesOfARow, GiveTheErrorOfItsMean) {
  const MeasuredData data = read_data(
      "run,routing,readings,T1_N,T1_sd_N,T2_N,at_T1_N,at_T1_sd\n"
      "A,TR5,16,4,0.2,3,6,0.4\nA,TR5,,4,0.2,,,\nA,TR5,4,,0.2,1,,\n");
  using Errors = std::vector<std::optional<double>>;
  EXPECT_EQ(data.readings[0].error_N, (Errors{0.05, {}, 0.1}));
  EXPECT_EQ(data.readings[1].error_N, (Errors{0.2, {}, {}}));
  EXPECT_EQ(data.readings[2].error_N, (Errors{{}, {}, {}}));
  EXPECT_EQ(data_error("run,routing,readings,T1_N\nA,TR5,0,1\n"),
            "d.csv:2: column 'readings' = '0': expected a number from 1 to 1000000000000000, or an "
            "empty cell");
  EXPECT_EQ(data_error("run,routing,T1_N,T2_sd_N\nA,TR5,1,1\n"),
            "d.csv:1: column 4 'T2_sd_N': expected the column T2_N beside it");
}

TEST(AColumnOfGroups, IsReadAsWords) {
  const MeasuredData data =
      read_data("run,routing,winch,T1_N\nA,TR5,left,1\nA,TR5,2,1\nA,TR5,left,2\nA,TR5,,2\n",
                {{}, {}, "winch"});
  EXPECT_EQ(data.groups, (std::vector<std::string>{"left", "2"}));
  EXPECT_EQ(data.readings[0].group, 0U);
  EXPECT_EQ(data.readings[1].group, 1U);
  EXPECT_EQ(data.readings[2].group, 0U);
  EXPECT_FALSE(data.readings[3].group);
  EXPECT_TRUE(data.covariates.empty());
  EXPECT_EQ(data_error("run,routing,T1_N\nA,TR5,1\n", {{}, {}, "winch"}),
            "d.csv:1: the header has no column 'winch': expected the column of groups");
}

TEST(AColumnBesideAStrand, IsThatSegmentWhateverItsLetter) {
  const MeasuredData data = read_data(
      "run,routing,T1_N,at_T1_N,at_T4_N\nA,M-1-T-2-M,1,2,3\nA,1-T-2-P-1,1,2,3\nA,TR5,1,2,3\n");
  const auto reading = [&](std::size_t row, const std::string& segment) -> std::optional<double> {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (data.channels[c].name == segment) return data.readings[row].tension_N[c];
    }
    return std::nullopt;
  };
  EXPECT_EQ(reading(0, "a"), 2);
  EXPECT_EQ(reading(0, "b"), 3);
  EXPECT_EQ(reading(1, "a"), 3);
  EXPECT_EQ(reading(1, "b"), 2);
  EXPECT_EQ(reading(2, "a"), 2);
  EXPECT_FALSE(reading(2, "b"));
  EXPECT_EQ(reading(2, "d"), 3);
  const MeasuredRouting& loop = data.routings[1];
  EXPECT_FALSE(loop.segments.back());  // d
  EXPECT_EQ(data_error("run,routing,T1_N,at_T2_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T2_N' = '2': the routing 'M-1-T-2-M' has no motor-side segment at "
            "T2: expected an empty cell; its segments are a, T1, T2, T3, T4, b");
  EXPECT_EQ(data_error("run,routing,Ta_N,at_T1_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T1_N' = '2': in the routing 'M-1-T-2-M' that is segment a, which "
            "another column has: expected an empty cell in one of the two");
}

TEST(Letters, ThatThePaperUsesOtherwiseAreNoted) {
  const auto letters = [](const std::string& column, const std::string& routing) {
    return note_text(read_data("run,routing,T1_N," + column + "\nA," + routing + ",1,2\n").notes,
                     NoteKind::letters);
  };
  EXPECT_EQ(letters("Ta_N", "1-T-2-P-1"),
            "letters run in walk order: in 1-T-2-P-1 a is beside T4. Where a, b, c, d were meant "
            "beside T1, T2, T3, T4, name the columns at_T1_N and so on");
  for (const char* same : {"M-1-T-2-F", "M-1-P-2-F", "M-1-P-2-M"}) {
    EXPECT_EQ(letters("Ta_N", same), "") << same;
  }
  for (const char* other : {"M-1-T-2-M", "F-1-P-2-F", "1-P-2-P-1"}) {
    EXPECT_NE(letters("Tb_N", other), "") << other;
  }
  EXPECT_EQ(letters("at_T4_N", "1-T-2-P-1"), "");
  const MeasuredData none = read_data("run,routing,T1_N,Ta_N\nA,1-T-2-P-1,1,\nA,M-1-F,1,2\n");
  EXPECT_EQ(count_notes(none.notes, NoteKind::letters),
            0U);  // no letter of that routing is measured
}

TEST(AllFaults, AreToldAtOnceByTheirLines) {
  EXPECT_EQ(
      data_error("run,routing,direction,T1_N,T1,speed,x\n"
                 "A,TR5,push,x,1,-1,1\n"
                 "A,TR5\n"
                 ",M-1-Q,,1,,1,1\n"
                 "A,TR5,,2,,1,u\n"),
      "d.csv: 8 faults:\n"
      "  d.csv:1: column 5 'T1': expected one column of its meaning, and column 4 'T1_N' has "
      "it\n"
      "  d.csv:2: column 'T1_N' = 'x': expected a number from -1000000000 to 1000000000, or an "
      "empty cell\n"
      "  d.csv:2: column 'speed' = '-1': expected a number from 0 to 1000000000, or an empty "
      "cell\n"
      "  d.csv:2: column 'direction' = 'push': expected pull, release, or an empty cell (pull)\n"
      "  d.csv:3:6: the row ends after 2 fields: expected 7, as many as the header in line 1 "
      "has\n"
      "  d.csv:4: column 'run' = '': expected a name or number for the run\n"
      "  d.csv:4: column 'routing' = 'M-1-Q': routing 'M-1-Q', column 5: unknown token 'Q': "
      "expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a "
      "bar such as W1\n"
      "  d.csv:5: column 'x' = 'u': expected a finite number such as 12.5, or an empty cell");
}

TEST(AllFaults, AreCountedWhereTheyAreTooManyToTell) {
  std::string text = "run,routing,T1_N,T2_N\n";
  for (int i = 0; i < 300; ++i) text += i % 3 == 0 ? "A,TR5,x,1\n" : "A,TR5,1,y\n";
  text += "A,TR5,1,\"2\n";
  const std::string message = data_error(text);
  EXPECT_EQ(
      message.substr(0, message.find('\n')),
      "d.csv: 301 faults: 200 in column 'T2_N', 100 in column 'T1_N', 1 where the rest cannot "
      "be read; the first 20, and 281 more:");
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
}

TEST(AllFaults, HaveTheirParts) {
  try {
    read_data("run,routing,T1_N\nA,TR5,x\nA,TR5,y\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault().where, "d.csv");
    ASSERT_EQ(error.fault().parts.size(), 2U);
    EXPECT_EQ(error.fault().parts[1].where, "d.csv:3");
    EXPECT_EQ(error.fault().parts[1].what, "column 'T1_N'");
    EXPECT_EQ(error.fault().parts[1].value, "y");
    const InputError placed = error.at("file");
    EXPECT_EQ(placed.fault().parts.size(), 2U);
    EXPECT_EQ(std::string(placed.what()).substr(0, 22), "file: d.csv: 2 faults:");
  }
}

}  // namespace
}  // namespace reeve::testing
