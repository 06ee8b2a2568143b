#include <gtest/gtest.h>

#include <limits>

#include "reports/shown_value.hpp"

namespace reeve {
namespace {

TEST(TellingDigits, AreAsManyAsTellValuesApart) {
  EXPECT_EQ(telling_digits({0.1, 0.2, 0.1}), 4);
  EXPECT_EQ(telling_digits({0.1, 0.10001}), 5);
  EXPECT_EQ(telling_digits({0.5, 0.50000001}), 8);
  EXPECT_EQ(telling_digits({1, 1 + 1e-15}), 12);
  EXPECT_EQ(telling_decimals(0.5, 8, 3), 3);
  EXPECT_EQ(telling_decimals(1e-4, 8, 3), 5);
  EXPECT_EQ(telling_decimals(0, 8, 3), 3);
}

TEST(SignificantDecimals, ShowThreeDigitsWithoutTheZerosBehindThem) {
  EXPECT_EQ(significant_decimals(17.05, 2), 2);
  EXPECT_EQ(significant_decimals(0.3, 2), 2);
  EXPECT_EQ(significant_decimals(0.125, 2), 3);
  EXPECT_EQ(significant_decimals(0.0021, 2), 4);
  EXPECT_EQ(significant_decimals(-0.00123456, 2), 5);
  EXPECT_EQ(significant_decimals(0.0099999, 2), 2);
  EXPECT_EQ(significant_decimals(1e-10, 2), 10);
  EXPECT_EQ(significant_decimals(0, 2), 2);
  EXPECT_EQ(significant_decimals(std::numeric_limits<double>::infinity(), 2), 2);
}

TEST(RoundedText, StaysOnItsSide) {
  EXPECT_EQ(rounded_text(20.00001, Rounding::up), "20.01");
  EXPECT_EQ(rounded_text(0.98, Rounding::up), "0.98");
  EXPECT_EQ(rounded_text(0.98, Rounding::down), "0.98");
  EXPECT_EQ(rounded_text(0.0123456, Rounding::down), "0.01234");
  EXPECT_EQ(rounded_text(-1.23456, Rounding::up), "-1.234");
  EXPECT_EQ(rounded_text(0, Rounding::up), "0");
}

}  // namespace
}  // namespace reeve
