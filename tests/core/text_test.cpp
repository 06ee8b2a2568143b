#include "core/text.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace reeve {
namespace {

TEST(NumberIn, ReadsTheWholeTextOrNothing) {
  EXPECT_EQ(number_in("12.5"), 12.5);
  EXPECT_EQ(number_in("-1e-3"), -1e-3);
  EXPECT_EQ(number_in("0"), 0);
  for (const char* text :
       {"", " 1", "1 ", "+1", "1.5mm", "1,5", "x", "0x10", "nan", "inf", "1e999"}) {
    EXPECT_EQ(number_in(text), std::nullopt) << text;
  }
}

TEST(WholeNumberIn, ReadsTheWholeTextOrNothing) {
  EXPECT_EQ(whole_number_in("12"), 12);
  EXPECT_EQ(whole_number_in("-3"), -3);
  for (const char* text : {"", " 1", "1.0", "1b", "99999999999"}) {
    EXPECT_EQ(whole_number_in(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace reeve
