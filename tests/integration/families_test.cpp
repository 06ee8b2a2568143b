// The families of the catalogue from end to end: check, rank and show, and what documents say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/edited_catalogue.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

Json json_of(Arguments arguments, const std::filesystem::path& catalogue = {}) {
  arguments.insert(arguments.end(), {"--format", "json"});
  ProcessOptions options;
  if (!catalogue.empty()) options.environment = {{"REEVE_CATALOG", catalogue.string()}};
  return Json::parse(reeve(arguments, options).out);
}

std::vector<std::string> names(const Json& designs) {
  std::vector<std::string> result;
  for (const Json& design : designs) result.push_back(design["name"]);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(CheckOfAFamily, IsThePartOfTheWholeCheck) {
  const Json all = json_of({"check"});
  const Json hauls = json_of({"check", "--family", "hauls"});
  Json part = Json::array();
  for (const Json& check : all["checks"]) {
    if (check["family"] == "hauls") part.push_back(check);
  }
  EXPECT_EQ(hauls["checks"], part);
  EXPECT_FALSE(part.empty());
  EXPECT_TRUE(hauls["misprints"].empty());
  ASSERT_EQ(hauls["families"].size(), 1U);
  EXPECT_EQ(hauls["families"][0]["open"], hauls["open"]);
}

TEST(CheckOfAFamily, EndsWithOneOnlyOfWhatIsNotListed) {
  const EditedCatalogue edited("families/benches/post_tensioned_beam.toml",
                               ", open = ", ", where = ");
  ProcessOptions options{.environment = {{"REEVE_CATALOG", edited.path().string()}}};
  EXPECT_EQ(reeve("check --family benches", options).exit_code, 1);
  EXPECT_EQ(reeve("check --family hauls", options).exit_code, 0);
  EXPECT_EQ(reeve("check --family benches").exit_code, 0);
}

TEST(RankOfAFamily, RanksItsMechanismsWithSoManyFingersByTheirNames) {
  EXPECT_EQ(
      names(json_of({"rank", "--catalogue", "--family", "hands", "--fingers", "4"})["designs"]),
      (std::vector<std::string>{"LavalSerial", "OpenHandModelQ", "OpenHandModelT",
                                "SeriesElasticDifferential", "SouthamptonHand"}));
  // PulleyTurn of the benches has the word of the single whip.
  const std::vector<std::string> tackles =
      names(json_of({"rank", "--catalogue", "--family", "tackles", "--fingers", "1"})["designs"]);
  EXPECT_EQ(tackles.size(), 13U);
  EXPECT_NE(std::find(tackles.begin(), tackles.end(), "SingleWhip"), tackles.end());
}

TEST(RankOfTheCatalogue, IsOfThePaperUnlessAFamilyIsGiven) {
  const Json paper = json_of({"rank", "--catalogue"});
  EXPECT_EQ(paper["designs"].size(), 7U);
  EXPECT_EQ(json_of({"rank", "--catalogue", "--family", "paper"}), paper);
}

TEST(ShowOfAMechanism, TakesItsOwnHardwareUnlessAnotherIsGiven) {
  const Json own = json_of({"show", "pulleyturn", "--held", "none"});
  EXPECT_EQ(own["name"], "PulleyTurn");
  EXPECT_NEAR(own["grasps"][0]["tensions"]["T1"], 0.842, 1e-12);
  EXPECT_NEAR(own["own_hardware"]["bearing"]["mu"], -std::log(0.842) / std::numbers::pi, 1e-12);
  const TemporaryFolder folder;
  const std::string file = folder.write("h.toml", "[sheath]\nmu = 0\n").string();
  const Json given = json_of({"show", "PulleyTurn", "--held", "none", "--hardware", file});
  EXPECT_NEAR(given["grasps"][0]["tensions"]["T1"], std::exp(-0.001 * std::numbers::pi), 1e-12);
  EXPECT_FALSE(given.contains("own_hardware"));
  // Its word is nobody's own.
  EXPECT_FALSE(json_of({"show", "M-B-1x"}).contains("own_hardware"));
}

// So that who compares two subcommands sees why their numbers differ.
TEST(ShowOfAMechanism, SaysWhoseHardwareItTakes) {
  const std::string owner =
      "Assumed, by the catalogue's PulleyTurn (show its word for the default)";
  EXPECT_TRUE(has(reeve("show PulleyTurn").out, owner + ": tubes mu "));
  const std::string rough = reeve("show PulleyTurn --sheath-mu 0.1").out;
  EXPECT_TRUE(has(rough, owner + " with --sheath-mu 0.1: tubes mu "));
  EXPECT_TRUE(json_of({"show", "PulleyTurn", "--sheath-mu", "0.1"}).contains("own_hardware"));
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  reeve({"show", "PulleyTurn", "--out", out});
  const std::string page = read_text(folder.path() / "index.html");
  EXPECT_TRUE(has(page, "id=\"assumed\">Assumed, by the catalogue"));
  for (const char* line : {"show M-B-1x", "rank PulleyTurn", "explore --fingers 1",
                           "size PulleyTurn --vary sheath_angle=1..2 --nominal --starts 1"}) {
    const ProcessResult result = reeve(line, {.directory = folder.path()});
    EXPECT_TRUE(has(result.out, "Assumed, by default: tubes mu ")) << line << result.err;
  }
}

TEST(ShowOfAMechanism, HasItsNameThoughAnotherHasItsWord) {
  EXPECT_EQ(json_of({"show", "SDMHand"})["name"], "SDMHand");
  EXPECT_EQ(json_of({"show", "OpenHandModelT"})["name"], "OpenHandModelT");
}

std::map<std::string, int> mechanisms_by_family() {
  std::map<std::string, int> count;
  const std::filesystem::path folder = std::filesystem::path(REEVE_CATALOG_DIR) / "families";
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.is_regular_file()) ++count[file.path().parent_path().filename().string()];
  }
  return count;
}

TEST(CountsInDocuments, AreThoseOfTheCheck) {
  const std::filesystem::path root = REEVE_SOURCE_DIR;
  const std::string document = read_text(root / "docs" / "catalogue.md");
  const std::string readme = read_text(root / "README.md");
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_TRUE(has(text, part)) << part;
  };
  const Json report = json_of({"check"});
  std::map<std::string, int> mechanisms = mechanisms_by_family();
  mechanisms["paper"] = 7;
  std::map<std::string, std::size_t> others;
  std::size_t files = 0;
  for (const Json& family : report["families"]) {
    std::size_t total = 0;
    std::string counts;
    for (const char* status : {"agrees", "used", "explained", "refuted", "open", "differs"}) {
      const auto count = family[status].get<std::size_t>();
      total += count;
      if (std::string(status) != "differs") counts += fmt::format(" {} |", count);
      if (family["family"] != "paper") others[status] += count;
    }
    const std::string name = family["family"];
    if (name != "paper") files += static_cast<std::size_t>(mechanisms.at(name));
    expect(document, fmt::format("| {} | {} | {} |{}\n", name, mechanisms.at(name), total, counts));
  }
  const std::size_t all = report["checks"].size();
  const std::string in_all = fmt::format("{} published and derived numbers", all);
  expect(readme, in_all);
  expect(readme, fmt::format("of {} other mechanisms", files));
  expect(document, in_all);
  expect(document, fmt::format("Of {} numbers of {} other mechanisms {} agree, {} are explained "
                               "likewise, {} gave a coefficient, {} are refuted, and {} are open",
                               all - 179, files, others["agrees"], others["explained"],
                               others["used"], others["refuted"], others["open"]));
}

}  // namespace
}  // namespace reeve::testing
