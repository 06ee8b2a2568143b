// What a logger's file may look like, and what is made of it.
#include "readings/rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "readings/reading_options.hpp"
#include "tests/readings/read_data.hpp"

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

TEST(ALoggersFile, MayMarkMissingNumbersInManyWays) {
  for (const char* missing : {"", "-", "--", "NaN", "nan", "NA", "n/a", "N.A.", "#N/A", "NULL"}) {
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

TEST(ACellThatMarksAnError, IsEmptyAndCounted) {
  for (const char* cell :
       {"#DIV/0!", "#WERT!", "#REF!", "#VALUE!", "#NAME?", "#NUM!", "Inf", "-Inf", "OVL", "ERR",
        "None", "NaT", "n.v.", "?", "---", "-nan(ind)", "1.#QNAN"}) {
    const std::string text(cell);
    const MeasuredData data = read_data("run,routing,held,T1_N,T2_N,x\nA,TR5,1,4," + text + "," +
                                        text + "\nA,TR5,1,5,2,3\n");
    EXPECT_FALSE(data.readings[0].tension_N[1]) << text;
    EXPECT_FALSE(data.readings[0].covariates[0]) << text;
    EXPECT_EQ(note_text(data.notes, NoteKind::passed_over),
              "an error or a word in place of a number is read as an empty cell: 2 cells, '" +
                  text + "' first")
        << text;
  }
  EXPECT_EQ(
      count_notes(read_data("run,routing,T1_N,T2_N\nA,TR5,1,#N/A\n").notes, NoteKind::passed_over),
      0U);
}

TEST(ARowOfSummary, IsLeftOutAndNoted) {
  const std::string rows = "run,routing,T1_N\nA,TR5,1\n";
  for (const char* name : {"mean", "Average", "AVG", "sd", "std", "StDev", "min", "max", "sum",
                           "total", "Mittelwert", "mean:"}) {
    const MeasuredData data = read_data(rows + name + ",,3\n");
    EXPECT_EQ(data.readings.size(), 1U) << name;
    EXPECT_EQ(noted_lines(data.notes, NoteKind::passed_over), Lines{3}) << name;
  }
  EXPECT_EQ(read_data("run,routing,direction,T1_N\nA,TR5,pull,1\n,,Mittelwert,2\n").readings.size(),
            1U);
  EXPECT_EQ(read_data(rows + "mean 2,TR5,3\n").readings.size(), 2U);
  EXPECT_EQ(data_error("run,routing,T1_N\nmax,TR5,1\n"),
            "d.csv:1: expected readings below the header, and there are rows of summary alone: "
            "give their runs other names");
}

TEST(AThousandsSeparator, IsNamed) {
  for (const char* number : {"17.190,000", "17'190", "17 190,5", "1.234.567"}) {
    EXPECT_NE(data_error(std::string("run;routing;T1_mN\nA;TR5;") + number + "\n")
                  .find("a number without a thousands separator"),
              std::string::npos)
        << number;
  }
  for (const char* number : {"\"17,190.000\"", "\"17,190\"", "17'190"}) {
    EXPECT_NE(data_error(std::string("run,routing,T1_mN\nA,TR5,") + number + "\n")
                  .find("a number without a thousands separator"),
              std::string::npos)
        << number;
  }
}

std::size_t thousands_notes(const std::string& rows) {
  const auto notes = read_data("run;routing;held;T1_mN;T2_N\n" + rows).notes;
  return std::ranges::count_if(notes, [](const DataNote& note) {
    return note.text.find("are these thousands separators?") != std::string::npos;
  });
}

TEST(AThousandsSeparator, IsSuspectedWhereThreeDigitsStandBesideWholeNumbers) {
  EXPECT_EQ(thousands_notes("A;TR5;1;24.665;1\nA;TR5;1;833;2\nA;TR5;1;9.030;2\n"), 1U);
  EXPECT_EQ(thousands_notes("A;TR5;1;24.665;1\nA;TR5;1;83.3;2\nA;TR5;1;833;2\n"), 0U);
  EXPECT_EQ(thousands_notes("A;TR5;1;24.665;1\nA;TR5;1;0;2\nA;TR5;1;9.030;2\n"), 0U);
  EXPECT_EQ(thousands_notes("A;TR5;1;24.665;1\nA;TR5;1;0.665;2\nA;TR5;1;833;2\n"), 0U);
}

TEST(DecimalCommas, MayStandInQuotesBetweenCommas) {
  EXPECT_EQ(first_row("run,routing,motor_tension_N,T1_N,T2_N\nA,TR5,\"20,5\",\"4,250\",3\n"),
            (std::vector<double>{20.5, 4.25, 3}));
  EXPECT_EQ(data_error("run,routing,T1_N,T2_N\nA,TR5,\"20,5\",4.25\n"),
            "d.csv:2: column 'T2_N' = '4.25': the file has decimal commas (line 2) and decimal "
            "points (line 2): expected one of them throughout");
}

TEST(AnInvisibleCharacter, IsABlank) {
  EXPECT_EQ(first_row("run,routing,motor\u00A0tension [N]\u00A0,T1_N\u200B,\uFEFFT2_N\n"
                      "A,\u00A0TR5,20\u202F,4,3\u2009\n"),
            twenty_four_three);
}

TEST(ALineBreakInAName, IsABlank) {
  const MeasuredData data =
      read_data("run,routing,\"Motor tension\r\n[N]\",T1_N,\"air\n\nhumidity\"\nA,TR5,20,4,40\n");
  EXPECT_EQ(data.readings[0].motor_tension_N, 20);
  EXPECT_EQ(data.covariates, std::vector<std::string>{"air humidity"});
}

TEST(ASpreadsheetsOwnFile, IsRefusedByName) {
  EXPECT_EQ(data_error("PK\x03\x04..."),
            "d.csv: is a workbook of a spreadsheet (.xlsx, .ods or another zip archive), not text: "
            "expected its sheet saved as CSV");
  EXPECT_EQ(data_error("\xD0\xCF\x11\xE0..."),
            "d.csv: is a workbook of a spreadsheet (.xls), not text: expected its sheet saved as "
            "CSV");
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

TEST(AColumnOfWords, ThatSeveralRowsShareMayTellGroups) {
  const auto notes = [](const char* second) {
    ReadingOptions options;
    options.group_option = "--group";
    const std::string text = fmt::format(
        "run,routing,lot,T1_N\nA,TR5,blue,1\nA,TR5,{0},2\nB,TR5,blue,1\nB,TR5,{0},2\n", second);
    return note_text(read_data(text, options).notes, NoteKind::passed_over);
  };
  const std::string read = "column 'lot' has words and is none that is known: it is not read";
  EXPECT_EQ(notes("red"),
            read + ". If it tells lots, winches or operators apart, --group 'lot' compares these");
  EXPECT_EQ(notes("blue"), read);
}

TEST(Directions, MayBeNamedByWhatTheFingersDo) {
  const MeasuredData data = read_data(
      "run,routing,direction,T1_N\nA,TR5,Flexion,1\nA,TR5,unloading,2\nA,TR5,PULL,2\nA,TR5,,1\n");
  EXPECT_EQ(data.readings[0].direction, Direction::pull);
  EXPECT_EQ(data.readings[1].direction, Direction::release);
  EXPECT_EQ(data.readings[2].direction, Direction::pull);
  EXPECT_EQ(note_text(data.notes, NoteKind::column_names),
            "directions are read so: 'Flexion' as pull, 'unloading' as release");
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

TEST(RowsOfZeros, MayBeAllThatAFileHas) {
  EXPECT_EQ(
      data_error("run,routing,T1_N\nTare,TR5,1\n"),
      "d.csv:1: expected readings below the header, and there are rows of zeros (tare) alone");
}

// Files that were put together as they stand.
TEST(AHeaderThatIsRepeated, IsToldOnce) {
  const std::string expected =
      ": expected one header at the beginning: where files were put together, take out that of each "
      "but the first, and see that runs of different files have names of their own";
  const std::string header = "run,routing,held,T1_N\n";
  EXPECT_EQ(data_error(header + "A,TR5,,1\n" + header + "B,TR5,,1\n"),
            "d.csv:3: line 3 repeats the header" + expected);
  EXPECT_EQ(data_error(header + header + "A,TR5,,1\n" + header + header),
            "d.csv:2: line 2 repeats the header, and so do 2 more" + expected);
  EXPECT_EQ(input_error([] { parse_logged_series("t,T1_N,T2_N\n0,1,2\nt,T1_N,T2_N\n", "l.csv"); }),
            "l.csv:3: line 3 repeats the header" + expected);
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

// As words they mean something.
TEST(AWordForAnError, IsItselfAmongWords) {
  EXPECT_EQ(
      read_data("run,routing,grease,T1_N\nA,TR5,none,1\nB,TR5,oil,1\n", {{}, {}, "grease"}).groups,
      (std::vector<std::string>{"none", "oil"}));
  for (const char* held : {"?", "error", ".0"}) {
    EXPECT_THROW(read_data("run,routing,held,T1_N\nA,TR5," + std::string(held) + ",1\n"),
                 InputError)
        << held;
  }
}

// The check for thousands has to end for any text.
TEST(AVeryLongNumber, IsACellThatCannotBeRead) {
  std::string cell = "123";
  for (int i = 0; i < 100'000; ++i) cell += ",123";
  EXPECT_THROW(read_data("run;routing;T1_N\nA;TR5;" + cell + "\n"), InputError);
}

TEST(AColumnOfGroups, NeedNotHaveTheCapitalsOfTheOption) {
  const std::string rows = "\nA,TR5,left,right,1\n";
  EXPECT_EQ(read_data("run,routing,Winch,side,T1_N" + rows, {{}, {}, "winch"}).groups,
            std::vector<std::string>{"left"});
  EXPECT_EQ(read_data("run,routing,Winch,winch,T1_N" + rows, {{}, {}, "winch"}).groups,
            std::vector<std::string>{"right"});
}

TEST(AColumnOfGroups, IsNotGuessedFromTwo) {
  EXPECT_EQ(
      data_error("run,routing,Winch,winch,T1_N\nA,TR5,left,right,1\n", {{}, {}, "WINCH"}),
      "d.csv:1: the header has no column 'WINCH': expected the column of groups; did you mean "
      "Winch?");
}

TEST(AColumnOfGroups, HasNoOtherMeaning) {
  const std::string file = "run,routing,T1_N,T2 [lbf],Ta\nA,TR5,1,1,1\n";
  const auto expected = [](const char* column, const char* meaning) {
    return fmt::format(
        "d.csv:1: column {}: expected a column without another meaning to group "
        "rows by, and this is read as {}",
        column, meaning);
  };
  EXPECT_EQ(data_error(file, {{}, {}, "run"}), expected("1 'run'", "run"));
  EXPECT_EQ(data_error(file, {{}, {}, "T1_N"}), expected("3 'T1_N'", "T1_N"));
  EXPECT_EQ(data_error(file, {{}, {}, "T2 [lbf]"}), expected("4 'T2 [lbf]'", "T2_N"));
  EXPECT_EQ(read_data(file, {{}, {}, "Ta"}).groups, std::vector<std::string>{"1"});
}

std::string rows_error(const std::string& text, const std::vector<ColumnMeaning>& map = {}) {
  ReadingOptions options;
  options.map_option = "--map";
  options.map = map;
  return data_error(text, options);
}

TEST(AColumnOfFingers, IsAskedAbout) {
  for (const char* name : {"grasp", "Finger", "blocked", "fixed", "holding", "obstacle"}) {
    const std::string text = std::string("run,routing,T1_N,") + name +
                             "\nA,TR5,1,\nA,TR5,2,1\nA,TR5,3,none\nA,TR5,3,2\n";
    EXPECT_EQ(rows_error(text),
              fmt::format("d.csv:1: column 4 '{0}': expected its meaning, which may be held: --map "
                          "'{0}=held', or --map '{0}={0}' if it is none",
                          name));
    EXPECT_EQ(rows_error(text, {{name, "held"}}), "no such error was thrown");
  }
  const auto is_asked = [](const std::string& text) {
    return rows_error(text).find("may be held") != std::string::npos;
  };
  EXPECT_FALSE(is_asked("run,routing,T1_N,grasp\nA,TR5,1,1\nA,TR5,2,7.5\n"));
  EXPECT_FALSE(is_asked("run,routing,T1_N,grasp\nA,TR5,1,\nA,TR5,2,\n"));
  EXPECT_FALSE(is_asked("run,routing,T1_N,held,grasp\nA,TR5,1,1,1\n"));
  EXPECT_FALSE(is_asked("run,routing,T1_N,humidity\nA,TR5,1,1\n"));
  EXPECT_NE(input_error([] {
              ReadingOptions options;
              options.map_option = "--map";
              parse_logged_series("t,T1_N,T2_N,grasp\n0,1,2,1\n1,1,2,1\n", "l.csv", options);
            }).find("l.csv:1: column 4 'grasp': expected its meaning, which may be held"),
            std::string::npos);
}

TEST(AMotorTension, IsAskedAboutWhateverItsName) {
  for (const char* name : {"Motor [N]", "Motor_N", "F_motor [N]", "tension_motor_N",
                           "motor_load_cell_N", "Motor [kg]", "Antrieb (N)"}) {
    EXPECT_NE(rows_error(std::string("run,routing,T1_N,") + name + "\nA,TR5,1,2\n")
                  .find("which may be motor_tension: --map"),
              std::string::npos)
        << name;
  }
  for (const char* name : {"Motor", "motor_mm_s", "Motor [°C]", "motor_number", "total_N"}) {
    EXPECT_EQ(rows_error(std::string("run,routing,T1_N,") + name + "\nA,TR5,1,2\n"),
              "no such error was thrown")
        << name;
  }
  EXPECT_EQ(rows_error("run,routing,T1_N,motor_tension_N,Motor [N]\nA,TR5,1,2,2\n"),
            "no such error was thrown");
}

TEST(AKnownNameInAUnitThatIsNoForce, IsRefused) {
  const std::string units = "(N, mN, cN, daN, kN, gf, kgf, lbf, ozf)";
  EXPECT_EQ(
      rows_error("run,routing,T1_N,T2 [counts]\nA,TR5,1,2\n"),
      "d.csv:1: column 4 'T2 [counts]': the unit counts is no force: expected a unit of force " +
          units + ", or --map 'T2 [counts]=T2 [counts]' if it is no tension");
  EXPECT_EQ(
      rows_error("run,routing,T1_N,motor_tension_mA\nA,TR5,1,2\n"),
      "d.csv:1: column 4 'motor_tension_mA': the unit mA is no force: expected a unit of force " +
          units +
          ", or --map 'motor_tension_mA=motor_tension_mA' if it is no tension; a current is no "
          "tension; multiplied by newton per ampere of motor and spool it would be "
          "motor_tension_N");
  EXPECT_NE(rows_error("run,routing,T1_N,motor_tension [Nm]\nA,TR5,1,2\n")
                .find("divided by the spool's radius"),
            std::string::npos);
  for (const char* columns : {"T2 [°C]", "T2_C", "Ta [K]", "T2_N,T2 [counts]", "T2_x"}) {
    const std::string cells = std::string(columns).find(',') == std::string::npos ? "2" : "2,3";
    EXPECT_EQ(rows_error(std::string("run,routing,T1_N,") + columns + "\nA,TR5,1," + cells + "\n"),
              "no such error was thrown")
        << columns;
  }
  EXPECT_EQ(
      rows_error("run,routing,T1_N,T2 [counts]\nA,TR5,1,2\n", {{"T2 [counts]", "T2 [counts]"}}),
      "no such error was thrown");
}

TEST(AMotorTension, ThatIsBelowZeroThroughoutMayHaveTheOtherSign) {
  EXPECT_EQ(data_error("run,routing,motor_tension_N,T1_N\nA,TR5,-20,1\nA,TR5,-21,1\n"),
            "d.csv: motor_tension_N is below zero in every row: expected motor tensions from 0: "
            "exchange the sign of that column");
}

}  // namespace
}  // namespace reeve::testing
