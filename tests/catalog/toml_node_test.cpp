#include "catalog/toml_node.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::TemporaryFolder;

std::string error_in_toml(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_toml(folder.write("t.toml", text)); });
}

std::string repeated(const std::string& piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

TEST(TomlNode, KnowsNamesAndPlacesInTheOrderOfTheFile) {
  const TemporaryFolder folder;
  const TomlNode root = read_toml(folder.write("t.toml", "z = 1\n[b.c]\n  a = [ 2, \"x\" ]\n"));
  ASSERT_EQ(root.children.size(), 2U);
  EXPECT_EQ(root.children[0].key, "z");
  const TomlNode& array = root.find("b")->require("c", "").require("a", "");
  EXPECT_EQ(array.name, "b.c.a");
  EXPECT_EQ(array.key_at.line, 3U);
  EXPECT_EQ(array.key_at.column, 3U);
  EXPECT_EQ(array.at.column, 7U);
  EXPECT_EQ(array.items()[1].name, "b.c.a[2]");
  EXPECT_EQ(array.items()[1].at.column, 12U);
}

TEST(TomlNode, ReadsMinusZeroAsZero) {
  const TemporaryFolder folder;
  const TomlNode root = read_toml(folder.write("t.toml", "z = -0.0\n"));
  EXPECT_FALSE(std::signbit(root.find("z")->number));
}

TEST(TomlNode, ReportsUnknownKeysInTheOrderOfTheFile) {
  const TemporaryFolder folder;
  const TomlNode root = read_toml(folder.write("t.toml", "z = 1\na = 1\n"));
  EXPECT_EQ(folder.error_of([&] {
    root.allow_only({"b", "c"});
  }),
            "t.toml:1:1: unknown key 'z': expected one of b, c");
}

TEST(TomlNode, DoesNotRoundLargeWholeNumbersAway) {
  const TemporaryFolder folder;
  const TomlNode root = read_toml(folder.write("t.toml", "a = 9007199254740993\n"));
  EXPECT_EQ(folder.error_of([&] { root.find("a")->integer(0, 5); }),
            "t.toml:1:5: a = 9007199254740992: expected a whole number from 0 to 5");
}

TEST(TomlNode, KeepsMessagesToOneLineAndShort) {
  const TemporaryFolder folder;
  const TomlNode root =
      read_toml(folder.write("t.toml", "a = \"x\\ny" + repeated("é", 100) + "\"\n"));
  EXPECT_EQ(folder.error_of([&] { root.find("a")->table(); }),
            "t.toml:1:5: a = \"x?y" + repeated("é", 28) + "…\": expected a table");
}

TEST(ReadToml, RefusesWhatIsNotText) {
  EXPECT_EQ(error_in_toml("a = \xFF\n"),
            "t.toml:1:4: not valid TOML: Encountered invalid utf-8 sequence");
  EXPECT_NE(error_in_toml(std::string("a\0b = 1\n", 8)).find("t.toml:1:2: not valid TOML"),
            std::string::npos);
}

// A line of dots would send the parser down as many levels, and over the end of the stack.
TEST(ReadToml, RefusesEndlessLinesAndDepth) {
  EXPECT_EQ(error_in_toml("b = 1\n" + repeated("a.", 500000) + "a = 1\n"),
            "t.toml:2:1: the line has 1000005 characters: expected at most 4096");
  EXPECT_EQ(error_in_toml(repeated("a.", 2000) + "a = 1\n"),
            "t.toml:1:17: expected no tables or arrays as deep as this");
  EXPECT_EQ(error_in_toml("a = " + repeated("[", 9) + repeated("]", 9) + "\n"),
            "t.toml:1:13: expected no tables or arrays as deep as this");
}

TEST(TomlNodeFault, HasThePlaceTheKeyTheValueAndWhatWasExpected) {
  const TomlNode root = parse_toml("[tube]\nmu = \"smooth\"\nnu = 1\n", "t.toml");
  const TomlNode& tube = *root.find("tube");
  EXPECT_EQ(testing::input_fault([&] { tube.find("mu")->number_from_zero(); }),
            "t.toml:2:6 | tube.mu | \"smooth\" | a finite number, not negative");
  EXPECT_EQ(testing::input_fault([&] { tube.allow_only({"mu"}); }),
            "t.toml:3:1 | unknown key | tube.nu | one of mu");
  EXPECT_EQ(testing::input_fault([&] { tube.require("angle", "an angle"); }),
            "t.toml:1:2 | missing key 'angle' in 'tube' | - | an angle");
}

TEST(TomlNodeFault, IsOneLineInEachPart) {
  const TomlNode root = parse_toml("a = \"x\\ny\"\n", "t\n.toml");
  EXPECT_EQ(testing::input_fault([&] { root.find("a")->fail_expected("b\nc"); }),
            "t?.toml:1:5 | a | \"x?y\" | b?c");
}

}  // namespace
}  // namespace reeve
