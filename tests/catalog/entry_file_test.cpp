#include "catalog/entry_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/catalog/entry_text.hpp"
#include "tests/catalog/mistake.hpp"

namespace reeve::testing {
namespace {

TEST(CatalogueEntry, NamesThePlaceOfEveryMistakeInItsHead) {
  const std::vector<Mistake> mistakes = {
      {"", "x.toml:1:1: missing key 'name': expected the routing's name"},
      {"name = \"X\"\n",
       "x.toml:1:1: missing key 'word': expected the routing's word, such as \"M-1-T-2-F\""},
      {minimal + "wrod = 1\n",
       "x.toml:3:1: unknown key 'wrod': expected one of name, word, title, source, notes, like, held, "
       "table, lines, closed_form, fault, misprint; did you mean word?"},
      {"name = 7\n", "x.toml:1:8: name = 7: expected a text in quotes, not empty"},
      {"name = \"\"\n", "x.toml:1:8: name = \"\": expected a text in quotes, not empty"},
      {"name = \"a b\"\n",
       "x.toml:1:8: name = \"a b\": expected at most 60 letters, digits, '_', '-' and '.'"},
      {"name = \"M-1-F\"\n",
       "x.toml:1:8: name = \"M-1-F\": expected a name that is not the word of a routing"},
      {"name = \"X\"\nword = \"M-1-Q\"\n",
       "x.toml:2:8: routing 'M-1-Q', column 5: unknown token 'Q': expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1"},
      {"name = \"X\"\nword = \"F-1-M\"\n",
       "x.toml:2:8: word = \"F-1-M\": expected the canonical word of this routing, \"M-1-F\""},
      {"name = \"X\"\nword = \"F-1-F\"\n",
       "x.toml:2:8: word = \"F-1-F\": expected a routing whose tendons all hang on the motor"},
      {minimal + "title = [1]\n",
       "x.toml:3:9: title = (an array): expected a text in quotes, not empty"},
      {minimal + "held = [2]\n", "x.toml:3:9: held[1] = 2: expected a whole number from 1 to 1"},
      {minimal + "held = [1, 1]\n", "x.toml:3:12: held[2] = 1: expected each finger once"},
      {minimal + "held = 1979-05-27\n", "x.toml:3:8: held = (a date or time): expected an array"},
      {minimal + table,
       "x.toml:1:1: missing key 'held': expected the fingers held in the grasp of the published numbers"},
      {"name = \"X\"\nname = \"Y\"\n",
       "x.toml:2:8: not valid TOML: Error while parsing key-value pair: cannot redefine existing string 'name'"},
  };
  for (const Mistake& mistake : mistakes)
    EXPECT_EQ(error_in_catalogue(mistake.text), mistake.message);
}

TEST(CatalogueEntry, NamesThePlaceOfEveryMistakeInItsPublishedNumbers) {
  const std::vector<Mistake> mistakes = {
      {"[table]\ntension = []\n",
       "x.toml:4:2: missing key 'source' in 'table': expected where the table stands"},
      {"[table]\nsource = \"I\"\ntension = [0.3, \"0.2\"]\n",
       "x.toml:6:12: table.tension[1] = 0.3: expected a number in quotes, with the digits as "
       "printed, such as \"0.10\""},
      {"[table]\nsource = \"I\"\ntension = [\"nan\", \"0.2\"]\n",
       "x.toml:6:12: table.tension[1] = \"nan\": expected a number in quotes, with the digits as "
       "printed, such as \"0.10\""},
      {"[table]\nsource = \"I\"\ntension = [\"0.3\"]\n",
       "x.toml:6:11: table.tension has 1 items: expected 2, one for each strand"},
      {"[closed_form]\nsource = \"Eq. 1\"\nstrand = [{}, { tubes = 1 }]\n",
       "x.toml:6:17: unknown key 'closed_form.strand[2].tubes': expected one of tube, bearing, "
       "sheath; did you mean tube?"},
      {"[closed_form]\nsource = \"Eq. 1\"\nstrand = [{}, { tube = -1 }]\n",
       "x.toml:6:24: closed_form.strand[2].tube = -1: expected a whole number from 0 to 1000"},
      {"[closed_form]\nsource = \"Eq. 1\"\nstrand = [{}, {}]\ncarriage = [{}, {}]\n",
       "x.toml:7:12: closed_form.carriage has 2 items: expected 1, one for each motor-side segment"},
      {table + "[[fault]]\nkind = \"typo\"\n",
       "x.toml:9:8: fault[1].kind = \"typo\": expected factor, repeats, proportional or "
       "reversed_contact"},
      {table + "[[fault]]\nkind = \"factor\"\nstrands = [1]\ntimes = 0\n",
       "x.toml:11:9: fault[1].times = 0: expected a number above zero"},
      {table + "[[fault]]\nkind = \"factor\"\nstrands = [1]\ntimes = inf\n",
       "x.toml:11:9: fault[1].times = inf: expected a finite number, not negative"},
      {"[[fault]]\nkind = \"factor\"\n",
       "x.toml:4:1: this fault needs a [table] or [[lines]] that it is "
       "about"},
      {"[fault]\nkind = \"factor\"\n",
       "x.toml:4:1: fault = (a table): expected tables headed [[fault]]"},
      {"[[lines]]\nsource = \"Fig. 1\"\nmu = 2\n",
       "x.toml:6:6: lines[1].mu = 2: expected a number from 0 to 1"},
      {"[[lines]]\nsource = \"Fig. 1\"\nmu = 0.1\nshare_percent = [\"60\", \"40\"]\n",
       "x.toml:4:1: missing key 'read_to_percent' in 'lines[1]': expected how closely the figure can "
       "be read"},
      {"[[misprint]]\nsource = \"Eq. 1\"\n",
       "x.toml:4:1: missing key 'text' in 'misprint[1]': expected what is misprinted"},
  };
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(error_in_catalogue(published + mistake.text), mistake.message);
  }
}

TEST(CatalogueEntry, NamesThePlaceOfAMistakeInAReversedContact) {
  const std::string form =
      published + "[closed_form]\nsource = \"Eq. 1\"\nstrand = [{}, {}]\ncarriage = [{}]\n";
  const std::string fault =
      "[[fault]]\nkind = \"reversed_contact\"\nsource = \"Eq. 1\"\nstrand = 1\n";
  EXPECT_EQ(error_in_catalogue(published + fault),
            "x.toml:4:1: a reversed contact needs a [closed_form] beside it");
  EXPECT_EQ(error_in_catalogue(form + fault + "segment = \"b\"\n"),
            "x.toml:12:11: fault[1].segment = \"b\": expected a motor-side segment, a to a");
  EXPECT_EQ(error_in_catalogue(form + fault + "segment = \"a\"\nprinted_higher = \"T1\"\n"),
            "x.toml:13:18: fault[1].printed_higher = \"T1\": expected \"strand\" or \"segment\"");
}

TEST(PrintedNumber, IsDigitsWithAtMostOnePoint) {
  ASSERT_TRUE(parse_printed_number("0.060"));
  EXPECT_DOUBLE_EQ(parse_printed_number("0.060")->half_unit, 0.0005);
  EXPECT_DOUBLE_EQ(parse_printed_number("48")->half_unit, 0.5);
  for (const char* bad : {"", ".", ".5", "5.", "1.2.3", "-1", "1e3", " 1", "0,1", "inf"}) {
    EXPECT_FALSE(parse_printed_number(bad)) << bad;
  }
}

std::string drawn(const std::string& source) {
  return "[[lines]]\nsource = \"" + source +
         "\"\nmu = 0.09\nshare_percent = [\"50\", \"50\"]\nread_to_percent = 0.3\n";
}

std::string error_of_lines_with_a_fault(const std::string& kind, const std::string& of_the_other) {
  const TemporaryFolder folder;
  folder.write("a.toml", "name = \"A\"\nword = \"M-1-M\"\nheld = [1]\n" + of_the_other);
  folder.write("x.toml", published + drawn("Fig. 1") + "[[fault]]\nkind = \"" + kind +
                             "\"\nrouting = \"A\"\n");
  return folder.error_of([&] { read_catalogue(folder.path()); });
}

// A fault may be about lines alone; what they repeat then are lines of the same figure.
TEST(Catalogue, TakesAFaultOfLinesWithoutATable) {
  EXPECT_EQ(error_of_lines_with_a_fault("repeats", drawn("Fig. 1")), "(no error)");
  const std::string refused =
      "x.toml:9:1: fault.routing = \"A\": expected another routing in the catalogue, with [[lines]] "
      "of as many strands in the same figure";
  EXPECT_EQ(error_of_lines_with_a_fault("repeats", drawn("Fig. 2")), refused);
  EXPECT_EQ(error_of_lines_with_a_fault("repeats", table), refused);
  EXPECT_EQ(error_of_lines_with_a_fault("proportional", table),
            "x.toml:9:1: a proportional fault needs a [table] that it is about");
}

}  // namespace
}  // namespace reeve::testing
