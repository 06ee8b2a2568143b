#include "core/error.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::input_error;
using testing::input_fault;

InputFault slow(InputForm form) {
  return {.where = "f:2", .what = "speed", .value = "0", .expected = "more", .form = form};
}

std::string parts(const InputError& error) {
  return input_fault([&] { throw error; });
}

TEST(InputError, SaysItsPartsInTheFormsThatInputHas) {
  EXPECT_EQ(sentence(slow(InputForm::option)), "f:2: speed '0': expected more");
  EXPECT_EQ(sentence(slow(InputForm::unknown)), "f:2: speed '0'; expected more");
  EXPECT_EQ(sentence(slow(InputForm::equals)), "f:2: speed = 0: expected more");
  EXPECT_EQ(sentence(slow(InputForm::cell)), "f:2: speed = '0': expected more");
  EXPECT_STREQ(InputError(slow(InputForm::cell)).what(), "f:2: speed = '0': expected more");
}

TEST(InputError, LeavesOutWhatIsMissingAndSaysWhatIsEmpty) {
  EXPECT_EQ(sentence({.where = "f", .what = "is empty", .expected = "a row"}),
            "f: is empty: expected a row");
  EXPECT_EQ(sentence({.where = "f", .value = "x", .expected = "a row"}), "f: 'x': expected a row");
  EXPECT_EQ(sentence({.where = "f", .expected = "a row"}), "f: expected a row");
  EXPECT_EQ(sentence({.where = "f", .what = "is empty"}), "f: is empty");
  EXPECT_EQ(sentence({.what = "--out", .value = "", .expected = "a folder"}),
            "--out '': expected a folder");
  EXPECT_EQ(sentence({.where = "", .what = "cannot be read"}), ": cannot be read");
  EXPECT_EQ(sentence({.expected = "a row"}), "expected a row");
}

TEST(InputError, KeepsProseAsWhatIsWrong) {
  const InputError error("speed is given twice");
  EXPECT_STREQ(error.what(), "speed is given twice");
  EXPECT_EQ(parts(error), "- | speed is given twice | - | ");
}

TEST(InputError, AtAPlaceKeepsItsPartsAndGrowsWhere) {
  const InputError twice = InputError(slow(InputForm::equals)).at("table").at("--model");
  EXPECT_STREQ(twice.what(), "--model: table: f:2: speed = 0: expected more");
  EXPECT_EQ(parts(twice), "--model: table: f:2 | speed | 0 | more");
  const InputError prose = InputError("speed is given twice").at("f:2").at("--model");
  EXPECT_STREQ(prose.what(), "--model: f:2: speed is given twice");
  EXPECT_EQ(parts(prose), "--model: f:2 | speed is given twice | - | ");
}

// Who reads the number does not know the cell; who knows the cell names what the number is.
TEST(InputError, TakesAnOuterThingAsSubjectOrAsPlace) {
  const InputFault cell{.where = "d:3", .what = "column", .value = "x", .form = InputForm::cell};
  const InputError number = InputError({.expected = "a number"}).at(cell);
  EXPECT_STREQ(number.what(), "d:3: column = 'x': expected a number");
  EXPECT_EQ(parts(number), "d:3 | column | x | a number");
  const InputError word = InputError({.value = "Q", .expected = "M or F"}).at(cell);
  EXPECT_STREQ(word.what(), "d:3: column = 'x': 'Q': expected M or F");
  EXPECT_EQ(parts(word), "d:3: column = 'x' |  | Q | M or F");
  EXPECT_EQ(parts(InputError("twice").at(cell)), "d:3: column = 'x' | twice | - | ");
  EXPECT_EQ(parts(InputError({.where = "w", .expected = "M"}).at(cell)),
            "d:3: column = 'x': w |  | - | M");
}

TEST(InputError, CanLengthenItsFirstName) {
  const InputFault shard{.what = "shard", .value = "9/8", .expected = "i/N"};
  const InputError option = InputError(shard).begun_with("--");
  EXPECT_STREQ(option.what(), "--shard '9/8': expected i/N");
  EXPECT_EQ(parts(option), "- | --shard | 9/8 | i/N");
  const InputError item = InputError(slow(InputForm::option)).begun_with("in ");
  EXPECT_EQ(parts(item), "in f:2 | speed | 0 | more");
}

TEST(InputError, IsChangedInEachPart) {
  const auto starred = [](std::string text) { return text + "*"; };
  EXPECT_EQ(parts(InputError(changed(slow(InputForm::option), starred))),
            "f:2* | speed* | 0* | more*");
  EXPECT_EQ(parts(InputError(changed({.what = "a"}, starred))), "- | a* | - | *");
}

}  // namespace
}  // namespace reeve
