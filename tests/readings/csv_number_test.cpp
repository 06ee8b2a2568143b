#include "readings/csv_number.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::input_error;

constexpr double infinity = std::numeric_limits<double>::infinity();

double read(CsvNumberReader& reader, const std::string& text, std::size_t line = 1) {
  return reader.read(text, line, -infinity, infinity);
}

TEST(CsvNumber, HasADecimalPointBetweenCommas) {
  CsvNumberReader reader(',');
  EXPECT_EQ(read(reader, "1.5"), 1.5);
  EXPECT_EQ(read(reader, "+2"), 2);
  EXPECT_EQ(read(reader, "-3e-2"), -0.03);
  for (const char* text : {"1,5", "x", "1.5 N", "nan", "inf", "1e999", "0x10", "+-1", "--1", "+"}) {
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
  EXPECT_EQ(
      input_error([&] { read(thousands, "1.234,5", 3); }),
      "the file has decimal commas (line 3) and decimal points (line 3): expected one of them "
      "throughout");
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
}  // namespace reeve
