#include <gtest/gtest.h>

#include <string>

#include "core/text.hpp"

namespace reeve::testing {
namespace {

TEST(Utf8, EncodesCharactersOfAnyLength) {
  for (const char* text : {"", "abc\n", "Führung 1,5 µm", "→", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "a\xEF\xBB\xBF"}) {
    EXPECT_EQ(first_not_utf8(text), std::nullopt) << text;
  }
}

TEST(Utf8, EndsAtTheFirstInvalidByte) {
  EXPECT_EQ(first_not_utf8("F\xFChrung"), 1U);
  EXPECT_EQ(first_not_utf8("\xC3\xBC\x80"), 2U);      // a byte that only follows others
  EXPECT_EQ(first_not_utf8("ab\xC3"), 2U);            // cut off
  EXPECT_EQ(first_not_utf8("ab\xE2\x86"), 2U);        // likewise
  EXPECT_EQ(first_not_utf8("\xE2\x86x"), 0U);         // its third byte is another character
  EXPECT_EQ(first_not_utf8("\xC0\x80"), 0U);          // overlong
  EXPECT_EQ(first_not_utf8("\xE0\x9F\xBF"), 0U);      // likewise
  EXPECT_EQ(first_not_utf8("\xF0\x8F\xBF\xBF"), 0U);  // likewise
  EXPECT_EQ(first_not_utf8("\xED\xA0\x80"), 0U);      // half of a pair of UTF-16
  EXPECT_EQ(first_not_utf8("\xF4\x90\x80\x80"), 0U);  // beyond U+10FFFF
}

}  // namespace
}  // namespace reeve::testing
