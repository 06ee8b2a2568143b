#include "catalog/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/canonical.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/catalog/entry_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::error_in_catalogue;
using testing::minimal;
using testing::published;
using testing::table;
using testing::TemporaryFolder;

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

// The sheaths are counted by the parts of the walk: one for each end M, and two for each P.
TEST(ShippedCatalogue, HasTheSevenForMoreFingersWithTheSheathsOfTheirKind) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  const auto sheaths = [](const Routing& routing) {
    const std::string word = to_word(routing);
    return std::count(word.begin(), word.end(), 'M') +
           2 * std::count(word.begin(), word.end(), 'P');
  };
  const std::vector<std::pair<std::string, std::function<int(int)>>> laws{
      {"TR1", [](int) { return 1; }},
      {"TR2", [](int) { return 2; }},
      {"TR3", [](int n) { return 2 * (n - 1); }},
      {"TR4", [](int n) { return 1 + 2 * (n - 1); }},
      {"TR5", [](int n) { return 2 + 2 * (n - 1); }},
      {"TR6", [](int n) { return n; }},
      {"TR7", [](int n) { return 2 * n; }}};
  for (const auto& [name, law] : laws) {
    const std::vector<Routing> sizes = catalogue.sizes_of(name);
    EXPECT_GT(sizes.size(), 1U) << name;
    for (const Routing& size : sizes) EXPECT_EQ(sheaths(size), law(finger_count(size))) << name;
  }
}

TEST(ShippedCatalogue, HasEachNumberOfFingersOfANameOnceAndInOrder) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    const std::vector<Routing> sizes = catalogue.sizes_of(mechanism.name);
    EXPECT_NE(std::find(sizes.begin(), sizes.end(), mechanism.routing), sizes.end());
    for (std::size_t i = 1; i < sizes.size(); ++i) {
      EXPECT_LT(finger_count(sizes[i - 1]), finger_count(sizes[i])) << mechanism.name;
    }
  }
  EXPECT_TRUE(catalogue.sizes_of("Nobody").empty());
}

// Each pulley halves its pull if there is no friction.
TEST(ShippedCatalogue, HasTreesOfPulleysThatHalveAtEachStage) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  Hardware ideal;
  ideal.tube.mu = ideal.bearing.mu = ideal.sheath.mu = 0;
  const std::map<int, std::vector<double>> shares{{2, {1. / 2, 1. / 2}},
                                                  {3, {1. / 4, 1. / 4, 1. / 2}},
                                                  {4, {1. / 4, 1. / 4, 1. / 4, 1. / 4}},
                                                  {5, {1. / 8, 1. / 8, 1. / 8, 1. / 8, 1. / 2}}};
  for (const char* name : {"OpenHandModelT", "SouthamptonHand"}) {
    const std::vector<Routing> sizes = catalogue.sizes_of(name);
    ASSERT_EQ(sizes.size(), shares.size());
    for (const Routing& size : sizes) {
      const Network network = expand(size);
      const TensionState state = tensions(network, mechanics(network, ideal), Grasp{});
      std::vector<double> pulls;
      for (std::size_t i = 0; i < network.segments.size(); ++i) {
        if (network.segments[i].kind == SegmentKind::strand) pulls.push_back(state.tension[i]);
      }
      std::sort(pulls.begin(), pulls.end());
      const std::vector<double>& expected = shares.at(finger_count(size));
      ASSERT_EQ(pulls.size(), expected.size());
      for (std::size_t i = 0; i < pulls.size(); ++i) EXPECT_NEAR(pulls[i], expected[i], 1e-4);
    }
  }
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
  EXPECT_EQ(catalogue.mechanisms.size(), 69U);
  EXPECT_EQ(numbers, 328U);
}

TEST(ShippedCatalogue, HasTheHandsAndGlovesOfSeveralMotors) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  const auto motors = [&](const std::string& name) {
    return carriage_count(catalogue.find_mechanism(name)->routing);
  };
  EXPECT_EQ(motors("OpenHandModelT42"), 2);
  EXPECT_EQ(motors("SoftHand2"), 2);
  EXPECT_EQ(motors("CyberHand"), 5);
  EXPECT_EQ(motors("SoftHand"), 1);
  const auto several = std::count_if(
      catalogue.mechanisms.begin(), catalogue.mechanisms.end(),
      [](const Mechanism& mechanism) { return carriage_count(mechanism.routing) > 1; });
  EXPECT_EQ(several, 15);
}

// With no finger held. If there are extensors on a second motor, it lets them out.
TEST(ShippedCatalogue, SolvesEachMechanismAndFindsItByItsNameAndWord) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    SCOPED_TRACE(mechanism.name);
    EXPECT_EQ(catalogue.find_routing(mechanism.name), &mechanism.routing);
    EXPECT_FALSE(name_of(catalogue, parse_routing(mechanism.word)).empty());
    for (const Routing& size : catalogue.sizes_of(mechanism.name)) {
      const Network network = expand(size);
      const auto solved = [&](const Grasp& grasp) {
        return tensions(network, mechanics(network, mechanism.hardware.value_or(Hardware{})),
                        grasp);
      };
      TensionState state = solved({});
      if (state.jams) state = solved({.carriages = {2, {1, -1}}});
      EXPECT_TRUE(state.in_range && !state.jams) << to_word(size);
      for (const double tension : state.tension) EXPECT_GE(tension, 0) << to_word(size);
    }
  }
}

// The words of the literature that no mechanics of rigid bodies determines.
TEST(ShippedCatalogue, RefusesADiskWithFourTendonsByItsStatics) {
  try {
    parse_routing("1x-W1-2x+3x-W1k+4x-W1k+W1-M");
    FAIL() << "four ties are not determined";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("leave the tensions of four ties undetermined"),
              std::string::npos)
        << error.what();
  }
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

}  // namespace
}  // namespace reeve
