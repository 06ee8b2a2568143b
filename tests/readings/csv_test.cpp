#include "readings/csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

using Fields = std::vector<std::string>;

struct Table {
  Fields header;
  std::vector<CsvRow> rows;
  std::vector<CsvComment> comments;
};

Table read(const std::string& text) {
  CsvReader reader(text, "d.csv");
  Table table{reader.header().fields, {}, {}};
  for (CsvRow row; reader.next(row);) {
    if (row.ragged) throw InputError(*row.ragged);
    table.rows.push_back(row);
  }
  table.comments = reader.comments();
  return table;
}

std::string error_in(const std::string& text) {
  return input_error([&] { read(text); });
}

TEST(Csv, HasAHeaderAndRowsWithTheirLines) {
  const Table table = read("a,b\n1,2\n\n3,\n");
  EXPECT_EQ(table.header, (Fields{"a", "b"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].fields, (Fields{"1", "2"}));
  EXPECT_EQ(table.rows[0].line, 2U);
  EXPECT_EQ(table.rows[1].fields, (Fields{"3", ""}));
  EXPECT_EQ(table.rows[1].line, 4U);
}

TEST(Csv, ReadsTheSameWithCrlfAndAByteOrderMarkAndWithoutALastLineEnd) {
  for (const char* text : {"a,b\n1,2\n", "a,b\r\n1,2\r\n",
                           "\xEF\xBB\xBF"
                           "a,b\n1,2",
                           "a,b\r\n1,2"}) {
    const Table table = read(text);
    EXPECT_EQ(table.header, (Fields{"a", "b"}));
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(table.rows[0].fields, (Fields{"1", "2"}));
  }
}

TEST(Csv, TakesSeparatorsQuotesAndLineEndsInQuotes) {
  const Table table = read("a,b\n\"1,5\",\"say \"\"no\"\"\"\n\"x\ny\",\"\"\n\"\"\"\",z\n");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].fields, (Fields{"1,5", "say \"no\""}));
  EXPECT_EQ(table.rows[1].fields, (Fields{"x\ny", ""}));
  EXPECT_EQ(table.rows[2].fields, (Fields{"\"", "z"}));
  EXPECT_EQ(table.rows[2].line, 5U);
}

TEST(Csv, KeepsCommentsWithTheirLines) {
  const Table table = read("# of May\na,b\n#1,2\n\"#3\",4\n5,#6\n");
  ASSERT_EQ(table.comments.size(), 2U);
  EXPECT_EQ(table.comments[0].text, " of May");
  EXPECT_EQ(table.comments[1].line, 3U);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].fields, (Fields{"#3", "4"}));
  EXPECT_EQ(table.rows[1].fields, (Fields{"5", "#6"}));
}

TEST(Csv, TakesTheSeparatorFromTheHeader) {
  EXPECT_EQ(read("a;b\n1,5;2\n").rows[0].fields, (Fields{"1,5", "2"}));
  EXPECT_EQ(read("a,b\n1;2,3\n").rows[0].fields, (Fields{"1;2", "3"}));
  EXPECT_EQ(read("\"a;1\",b\n1,2\n").rows[0].fields, (Fields{"1", "2"}));
  EXPECT_EQ(read("a\n1\n").rows[0].fields, (Fields{"1"}));
  EXPECT_EQ(error_in("a;b,c\n"),
            "d.csv:1:1: the header has 1 commas and 1 semicolons outside quotes: expected one of "
            "them, as separator");
  EXPECT_EQ(read("a\tb\n1,5\t2\n").rows[0].fields, (Fields{"1,5", "2"}));
}

std::vector<std::string> titles_of(const std::string& text) {
  std::vector<std::string> titles;
  const CsvReader reader(text, "d.csv");
  for (const CsvComment& title : reader.titles()) titles.push_back(title.text);
  return titles;
}

// Titles may have separators of their own, numbers, or a row of blank fields.
TEST(Csv, FindsTheHeaderBelowTitles) {
  const std::string log = "Zeit [s];Kraft F1 [N]\r\n0,0;1,5\r\n0,1;1,6\r\n";
  for (const char* line : {"Messung vom 14.03.2024\r\n", "Rig 3, Zug; Seil\r\n", "Messung;\r\n",
                           "Rate;100\r\n", "\"Messung\nzwei\"\r\n"}) {
    const std::string title(line);
    const Table table = read(title + "\r\n" + log);
    EXPECT_EQ(table.header, (Fields{"Zeit [s]", "Kraft F1 [N]"})) << title;
    ASSERT_EQ(table.rows.size(), 2U) << title;
    EXPECT_EQ(table.rows[0].fields, (Fields{"0,0", "1,5"})) << title;
    EXPECT_EQ(titles_of(title + log).size(), 1U) << title;
  }
  EXPECT_EQ(read("Messung\nMai\n" + log).rows[0].line, 4U);
  EXPECT_EQ(titles_of("# c\nMessung\nMai\n" + log), (Fields{"Messung", "Mai"}));
}

// LabVIEW writes lines with a word for each channel, and two with numbers.
TEST(Csv, FindsTheHeaderBelowTitlesOfChannels) {
  const std::string titles = "Date\t2026/11/30\t2026/11/30\nY_Unit\tN\tN\nX0\t0.0\t0.0\n";
  const Table table = read(titles + "X_Value\tT1\tT2\n0\t1\t2\n0.1\t1\t2\n");
  EXPECT_EQ(table.header, (Fields{"X_Value", "T1", "T2"}));
  EXPECT_EQ(table.rows.size(), 2U);
  // Not where as many numbers stand above: a row of words may be in the midst of readings.
  EXPECT_EQ(read("a,b\n1,2\nx,y\n3,4\n").header, (Fields{"a", "b"}));
  EXPECT_EQ(read("a,b\n1,2\na,b\n3,4\n5,6\n").header, (Fields{"a", "b"}));
}

TEST(Csv, BeginsWithItsHeaderIfNoRowBelowFitsBetter) {
  for (const char* text : {"a,b\n1,2\n", "a,b\nx,y\n1,2\n", "a,b\n1,2,3\n", "a,b\nx,y\n",
                           "1,2\n3,4\n", "a,b,\n1,2\n", "a,b\n1,\n2,\n"}) {
    EXPECT_TRUE(titles_of(text).empty()) << text;
  }
}

TEST(BadCsv, NamesLineAndColumnOfARaggedRow) {
  EXPECT_EQ(error_in("# c\na,b,c\n1,2\n"),
            "d.csv:3:4: 2 fields: expected 3, as many as the header in line 2 "
            "has");
  EXPECT_EQ(error_in("a,b\n1,2,3\n"),
            "d.csv:2:5: 3 fields: expected 2, as many as the header in line 1 has");
  EXPECT_EQ(error_in("a,b\n1"),
            "d.csv:2:2: 1 field: expected 2, as many as the "
            "header in line 1 has");
}

TEST(BadCsv, NamesWhereAQuoteIsNotClosedOrNotAlone) {
  EXPECT_EQ(error_in("a,b\n1,\"2\n3,4\n5,6\n"),
            "d.csv:2:3: the quote is not closed: expected another one");
  EXPECT_EQ(error_in("a,b\n1,2\"\n"),
            "d.csv:2:4: a quote inside a field: expected the whole field in quotes, and the quote "
            "twice");
  EXPECT_EQ(error_in("a,b\n\"1\n2\"x,3\n"),
            "d.csv:3:3: 'x' behind the closing quote: expected ',' or the end of the line");
}

TEST(BadCsv, NamesBytesThatAreNoText) {
  using namespace std::string_literals;
  const std::string expected =
      "a NUL byte: expected text in UTF-8. If the file is UTF-16, convert it by iconv -f UTF-16 -t "
      "UTF-8";
  EXPECT_EQ(error_in("a,b\n1,\0\n"s), "d.csv:2:3: " + expected);
  EXPECT_EQ(error_in("\xFF\xFE"
                     "a\0,\0"s),
            "d.csv:1:4: " + expected);
  EXPECT_EQ(error_in("a,b\r1,2\r"),
            "d.csv:1:4: a carriage return alone: expected LF or CRLF at line ends");
  EXPECT_EQ(error_in("# c\ra,b\r1,2\r"),
            "d.csv:1:4: a carriage return alone: expected LF or CRLF at line ends");
}

TEST(BadCsv, NamesWhatIsCompressed) {
  EXPECT_EQ(error_in("\x1F\x8B..."), "d.csv: is compressed (gzip): expected the file unpacked");
  EXPECT_EQ(error_in("BZh9..."), "d.csv: is compressed (bzip2): expected the file unpacked");
}

TEST(BadCsv, NamesColumnsThatBlanksOrBarsPart) {
  const std::string expected = ": expected commas, semicolons or tabs";
  EXPECT_EQ(error_in("run  routing  T1_N\nA  TR5  1.5\n"),
            "d.csv:1:1: columns are separated by blanks" + expected);
  EXPECT_EQ(error_in("run | routing | T1_N\nA | TR5 | 1.5\n"),
            "d.csv:1:1: columns are separated by bars (|)" + expected);
  EXPECT_EQ(error_in("force of the motor\n1.5\n"), "no such error was thrown");
}

TEST(BadCsv, NamesTheFirstByteThatIsNoUtf8AndWhatTheFileLooksLike) {
  const std::string looks =
      "text in UTF-8. The file looks like Latin-1 or Windows-1252, as spreadsheets on Windows "
      "write: save it as 'CSV UTF-8', or convert it by iconv -f WINDOWS-1252 -t UTF-8";
  EXPECT_EQ(error_in("a,b\nF\xFC"
                     "hr1,2\nF\xFC"
                     "hr2,2\n"),
            "d.csv:2:2: the byte FC ('ü' in Latin-1): expected " + looks);
  EXPECT_EQ(error_in("\xEF\xBB\xBF# 5 \x80\na,b\n1,2\n"),
            "d.csv:1:5: the byte 80: expected " + looks);
  EXPECT_EQ(error_in("a,b\nFühr1,2\n"), "no such error was thrown");
}

TEST(BadCsv, MayHaveNoHeader) {
  for (const char* text : {"", "\n\n", "# only this", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(error_in(text), "d.csv: is empty: expected a header and rows below it");
  }
}

// However long a row is, its first field too many is found without reading on.
TEST(BadCsv, MayHaveTooManyColumns) {
  EXPECT_EQ(error_in(std::string(20000, ',')),
            "d.csv:1:10001: a further field: expected at most 10000");
}

TEST(CsvFile, ThatCannotBeReadIsNamed) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& name) {
    return folder.error_of([&] { CsvReader::open(folder.path() / name); });
  };
  EXPECT_EQ(error_of("none.csv"), "none.csv: cannot be read: No such file or directory");
  std::filesystem::create_directory(folder.path() / "sub");
  EXPECT_EQ(error_of("sub"), "sub: is a directory: expected a CSV file");
  folder.write("large.csv", "a,b\n");
  std::filesystem::resize_file(folder.path() / "large.csv", max_csv_size + 1);
  EXPECT_EQ(error_of("large.csv"),
            "large.csv: is larger than 512 MiB: expected a CSV file with one row per reading");
}

TEST(ForMessage, ShortensAndReplacesWhatBreaksLines) {
  EXPECT_EQ(for_message("a\nb\x7F"), "a?b?");
  EXPECT_EQ(one_line("\xFC\xC3\xBC\xE2\x86x"), "?\xC3\xBC??x");
  EXPECT_EQ(for_message(std::string(50, 'x')), std::string(40, 'x') + "…");
  EXPECT_EQ(for_message(std::string(39, 'x') + "ä"), std::string(39, 'x') + "…");
}

constexpr double infinity = std::numeric_limits<double>::infinity();

double read(CsvNumberReader& reader, const std::string& text, std::size_t line = 1) {
  return reader.read(text, line, -infinity, infinity);
}

TEST(CsvNumber, HasADecimalPointBetweenCommas) {
  CsvNumberReader reader(',');
  EXPECT_EQ(read(reader, "1.5"), 1.5);
  EXPECT_EQ(read(reader, "+2"), 2);
  EXPECT_EQ(read(reader, "-3e-2"), -0.03);
  EXPECT_EQ(
      input_error([&] { read(reader, "1,5"); }),
      "the file has decimal commas (line 1) and decimal points (line 1): expected one of them "
      "throughout");
  for (const char* text : {"x", "1.5 N", "nan", "inf", "1e999", "0x10", "+-1", "--1", "+"}) {
    EXPECT_EQ(input_error([&] { read(reader, text); }),
              "expected a finite number such as 12.5, or an empty cell")
        << text;
  }
}

TEST(CsvNumber, MayHaveADecimalCommaBetweenSemicolons) {
  CsvNumberReader commas(';');
  EXPECT_EQ(read(commas, "1,5"), 1.5);
  EXPECT_EQ(read(commas, "7"), 7);
  CsvNumberReader points(';');
  EXPECT_EQ(read(points, "1.5"), 1.5);
}

TEST(CsvNumber, IsRefusedWhereCommasAndPointsMeet) {
  CsvNumberReader reader(';');
  read(reader, "1,5", 2);
  EXPECT_EQ(
      input_error([&] { read(reader, "1.5", 9); }),
      "the file has decimal commas (line 2) and decimal points (line 9): expected one of them "
      "throughout");
  CsvNumberReader thousands(';');
  EXPECT_EQ(input_error([&] { read(thousands, "1.234,5", 3); }),
            "expected a number without a thousands separator");
}

TEST(CsvNumber, IsInItsRange) {
  CsvNumberReader reader(',');
  EXPECT_EQ(reader.read("0", 1, 0, 100), 0);
  EXPECT_EQ(reader.read("100", 1, 0, 100), 100);
  for (const char* text : {"-0.1", "100.1", "nan"}) {
    EXPECT_EQ(input_error([&] { reader.read(text, 1, 0, 100); }),
              "expected a number from 0 to 100, or an empty cell");
  }
}

}  // namespace
}  // namespace reeve::testing
