#include "catalog/catalogue.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "catalog/entry_file.hpp"
#include "catalog/names.hpp"
#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Mistake;
using testing::TemporaryFolder;

const std::string minimal = "name = \"X\"\nword = \"M-1-F\"\n";
const std::string published = minimal + "held = [1]\n";
const std::string table =
    "[table]\nsource = \"Table I\"\ntension = [\"0.3\", \"0.2\"]\nshare_percent = [\"60\", \"40\"]\n";

std::string error_in_catalogue(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("x.toml", text);
  return folder.error_of([&] { read_catalogue(folder.path()); });
}

TEST(ShippedCatalogue, HoldsTheSevenRoutingsInOrderWithTheirCanonicalWords) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  std::vector<std::pair<std::string, std::string>> found;
  for (const CatalogueEntry& entry : catalogue.entries) {
    found.emplace_back(entry.name, entry.word);
    EXPECT_EQ(to_word(entry.routing), entry.word);
    EXPECT_EQ(entry.grasp, hold({1}));
    EXPECT_FALSE(entry.title.empty());
    EXPECT_FALSE(entry.source.empty());
    ASSERT_TRUE(entry.table && entry.closed_form);
    EXPECT_EQ(entry.table->tension.size(), 4U);
  }
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"TR1", "M-1-T-2-F"}, {"TR2", "M-1-T-2-M"}, {"TR3", "F-1-P-2-F"}, {"TR4", "M-1-P-2-F"},
      {"TR5", "M-1-P-2-M"}, {"TR6", "1-T-2-P-1"}, {"TR7", "1-P-2-P-1"}};
  EXPECT_EQ(found, expected);
}

TEST(ShippedCatalogue, KeepsTheDigitsAsPrinted) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  const PrintedNumber& t3 = catalogue.find_name("TR1")->table->tension[2];
  EXPECT_EQ(t3.digits, "0.10");
  EXPECT_DOUBLE_EQ(t3.value, 0.1);
  EXPECT_DOUBLE_EQ(t3.half_unit, 0.005);
}

TEST(ShippedCatalogue, HoldsMechanismsByFamilyBesideTheSeven) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  EXPECT_EQ(catalogue.families(),
            (std::vector<std::string>{"benches", "gloves", "hands", "hauls", "tackles"}));
  std::size_t numbers = 0;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    EXPECT_FALSE(mechanism.title.empty()) << mechanism.name;
    EXPECT_FALSE(mechanism.source.empty()) << mechanism.name;
    EXPECT_FALSE(mechanism.access.empty()) << mechanism.name;
    // What nobody read has no numbers that could be checked as if it had been.
    if (mechanism.access.starts_with("not read")) {
      EXPECT_TRUE(mechanism.from_secondary_source) << mechanism.name;
    }
    if (mechanism.from_secondary_source) {
      EXPECT_TRUE(mechanism.numbers.empty()) << mechanism.name;
    }
    numbers += mechanism.numbers.size();
  }
  EXPECT_EQ(catalogue.mechanisms.size(), 38U);
  EXPECT_EQ(numbers, 172U);
}

struct CatalogueWithFamily {
  TemporaryFolder folder;

  explicit CatalogueWithFamily(const std::string& name) {
    folder.write("x.toml", minimal);
    std::filesystem::create_directories(folder.path() / "families" / name);
  }
  void write(const std::string& path, const std::string& name, const std::string& word) const {
    folder.write("families/" + path,
                 "name = \"" + name + "\"\nword = \"" + word + "\"\naccess = \"read\"\n");
  }
};

TEST(CatalogueWithFamilies, FindsRoutingsAndMechanismsByName) {
  const CatalogueWithFamily given("winches");
  given.write("winches/b.toml", "Winch10", "M-B-1x");
  given.write("winches/a.toml", "Winch9", "M-B-1x");
  const Catalogue catalogue = read_catalogue(given.folder.path());
  ASSERT_EQ(catalogue.mechanisms.size(), 2U);
  EXPECT_EQ(catalogue.mechanisms[0].name, "Winch9");
  EXPECT_EQ(catalogue.find_mechanism("winch10"), &catalogue.mechanisms[1]);
  EXPECT_EQ(catalogue.find_mechanism("X"), nullptr);
  EXPECT_EQ(catalogue.find_routing("X"), &catalogue.entries[0].routing);
  EXPECT_EQ(catalogue.find_routing("Winch9"), &catalogue.mechanisms[0].routing);
  EXPECT_EQ(catalogue.find_routing("Winch"), nullptr);
  EXPECT_EQ(name_of(catalogue, parse_routing("1x-B-M")), "Winch9");
  EXPECT_EQ(name_of(catalogue, parse_routing("M-1-F")), "X");
}

TEST(CatalogueWithFamilies, TakesNoNameTwice) {
  const CatalogueWithFamily given("winches");
  given.write("winches/a.toml", "x", "M-B-1x");
  EXPECT_EQ(given.folder.error_of([&] { read_catalogue(given.folder.path()); }),
            "families/winches/a.toml:1:8: name = \"x\": expected a name that is not taken (x.toml "
            "has it)");
}

TEST(CatalogueWithFamilies, KeepsTheNameOfTheFamilyOfItsOwnRoutings) {
  const CatalogueWithFamily given("paper");
  EXPECT_EQ(given.folder.error_of([&] { read_catalogue(given.folder.path()); }),
            "catalogue families/paper: this name is taken; expected another, since the routings "
            "beside families/ are paper's");
}

TEST(Catalogue, FindsNamesWhateverTheirCase) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  ASSERT_NE(catalogue.find_name("tr4"), nullptr);
  EXPECT_EQ(catalogue.find_name("tr4")->name, "TR4");
  EXPECT_EQ(catalogue.find_name("TR"), nullptr);
  EXPECT_EQ(catalogue.find_name("TR44"), nullptr);
}

TEST(Catalogue, FindsARoutingByItsCanonicalForm) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  const Routing backwards = parse_routing("F-1-P-2-M");
  EXPECT_EQ(catalogue.find_word(backwards), nullptr);
  const CatalogueEntry* found =
      catalogue.find_word(canonical(backwards, FingerIdentity::identical));
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->name, "TR4");
}

TEST(Catalogue, SortsNumbersInNamesAsNumbers) {
  const TemporaryFolder folder;
  folder.write("1.toml", "name = \"R10\"\nword = \"M-1-F\"\n");
  folder.write("2.toml", "name = \"r9\"\nword = \"M-1-M\"\n");
  folder.write("3.toml", "name = \"R009b\"\nword = \"1-P-1\"\n");
  folder.write("4.toml", "name = \"A\"\nword = \"M-1b-F\"\n");
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : read_catalogue(folder.path()).entries) {
    names.push_back(entry.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"A", "r9", "R009b", "R10"}));
}

TEST(Catalogue, ReadsAnEntryWithoutPublishedNumbersAndLeavesOtherFilesAlone) {
  const TemporaryFolder folder;
  folder.write("x.toml", minimal);
  folder.write("README.md", "not TOML");
  std::filesystem::create_directory(folder.path() / "sub.toml");
  std::filesystem::create_directory(folder.path() / "hardware");
  folder.write("hardware/y.toml", "not an entry");
  const Catalogue catalogue = read_catalogue(folder.path());
  ASSERT_EQ(catalogue.entries.size(), 1U);
  EXPECT_FALSE(catalogue.entries[0].table);
  EXPECT_FALSE(catalogue.entries[0].closed_form);
}

TEST(Catalogue, RefusesAFolderWithoutEntries) {
  const TemporaryFolder folder;
  const std::string path = folder.path().string();
  EXPECT_EQ(folder.error_of([&] { read_catalogue(path); }),
            "catalogue " + path + ": has no file *.toml: expected one for each routing");
  EXPECT_EQ(folder.error_of([&] { read_catalogue(path + "/none"); }),
            "catalogue none: cannot be read: No such file or directory");
}

TEST(Catalogue, RefusesAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("nowhere", folder.path() / "x.toml");
  EXPECT_EQ(folder.error_of([&] { read_catalogue(folder.path()); }),
            "x.toml: cannot be read: No such file or directory");
}

TEST(Catalogue, RefusesNamesAndRoutingsThatAreTaken) {
  const TemporaryFolder folder;
  folder.write("a.toml", minimal);
  folder.write("b.toml", "name = \"x\"\nword = \"M-1-M\"\n");
  const auto read = [&] { read_catalogue(folder.path()); };
  EXPECT_EQ(folder.error_of(read),
            "b.toml:1:8: name = \"x\": expected a name that is not taken (a.toml has it)");
  folder.write("b.toml", "name = \"Y\"\nword = \"M-1-F\"\n");
  EXPECT_EQ(folder.error_of(read),
            "b.toml:2:8: word = \"M-1-F\": expected a routing that is not in the catalogue yet "
            "(a.toml has it as X)");
}

TEST(Catalogue, RefusesAFaultThatRefersToNoOtherTable) {
  for (const std::string other : {"Z", "X"}) {
    EXPECT_EQ(error_in_catalogue(published + table + "[[fault]]\nkind = \"repeats\"\nrouting = \"" +
                                 other + "\"\n"),
              "x.toml:8:1: fault.routing = \"" + other +
                  "\": expected another routing in the catalogue, with a [table] of as many "
                  "strands");
  }
}

TEST(CatalogueEntry, NamesThePlaceOfEveryMistakeInItsHead) {
  const std::vector<Mistake> mistakes = {
      {"", "x.toml:1:1: missing key 'name': expected the routing's name"},
      {"name = \"X\"\n",
       "x.toml:1:1: missing key 'word': expected the routing's word, such as \"M-1-T-2-F\""},
      {minimal + "wrod = 1\n",
       "x.toml:3:1: unknown key 'wrod': expected one of name, word, title, source, notes, held, "
       "table, lines, closed_form, fault, misprint"},
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
       "sheath"},
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
}  // namespace reeve
