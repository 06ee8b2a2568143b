// The page of `rank --out`: what its figure of tension distributions shows, against the paper's
// closed forms and tables; escaping; the files beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "reports/json.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

struct Ranked {
  explicit Ranked(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "rank");
    arguments.insert(arguments.end(), {"--out", (folder.path() / "page").string()});
    result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    html = read_text(folder.path() / "page" / "index.html");
    json = Json::parse(read_text(folder.path() / "page" / "ranking.json"));
  }

  Json spec(const std::string& figure) const {
    const std::string opening = R"(<script type="application/json" class="spec">)";
    const std::size_t begin =
        html.find(opening, html.find("<figure class=\"chart\" id=\"" + figure + "\">")) +
        opening.size();
    return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  }

  TemporaryFolder folder;
  ProcessResult result;
  std::string html;
  Json json;
};

// The values of one row of the figure: panel, strand -> share.
using Shares = std::map<std::string, std::map<std::string, double>>;

Shares shares(const Json& spec, std::size_t row, const std::string& source) {
  Shares result;
  for (const Json& value : spec["vconcat"][row]["data"]["values"]) {
    if (value["source"] == source) result[value["panel"]][value["strand"]] = value["share"];
  }
  return result;
}

// Eqs. 5, 11 and 23 of the supplement, normalised to a sum of 1; both exponents from one mu.
std::vector<double> closed_form(const std::string& name, double mu) {
  const double tube = std::exp(-mu * std::numbers::pi);
  const double bearing = std::exp(-0.001 * std::numbers::pi);
  std::vector<double> t;
  if (name == "TR1") t = {1, tube, tube * tube, tube * tube * tube};
  if (name == "TR3") t = {tube, 1, bearing, bearing * tube};
  if (name == "TR7") t = {1, 1, bearing, bearing};
  double sum = 0;
  for (const double tension : t) sum += tension;
  for (double& tension : t) tension /= sum;
  return t;
}

const Ranked& catalogue() {
  static const Ranked ranked({"--catalog"});
  return ranked;
}

TEST(FigureNine, DrawsTheClosedFormsAsTheModel) {
  const Json spec = catalogue().spec("figure-9");
  ASSERT_EQ(spec["vconcat"].size(), 2U);
  const std::vector<double> coefficients{0.18, 0.09};
  for (std::size_t row = 0; row < 2; ++row) {
    const Shares model = shares(spec, row, "model");
    EXPECT_EQ(model.size(), 7U);
    for (const char* name : {"TR1", "TR3", "TR7"}) {
      const std::vector<double> expected = closed_form(name, coefficients[row]);
      ASSERT_EQ(model.at(name).size(), 4U);
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(model.at(name).at("T" + std::to_string(i + 1)), expected[i], 1e-9)
            << name << " T" << i + 1 << " at " << coefficients[row];
      }
    }
  }
}

// The sheaths' exponent counts too: TR4 loses two sheaths between its fingers (Eq. 14).
TEST(FigureNine, VariesTubesAndSheathsAlike) {
  const Json spec = catalogue().spec("figure-9");
  const double pi = std::numbers::pi;
  const double ratio = std::exp(-2 * 0.09 * 2 * pi - 0.001 * pi);
  const auto model = shares(spec, 1, "model").at("TR4");
  EXPECT_NEAR(model.at("T3") / model.at("T2"), ratio, 1e-9);
}

TEST(FigureNine, DrawsWhatIsPrintedAndMarksWhatTheCheckDoesNotFind) {
  const Json spec = catalogue().spec("figure-9");
  const std::map<std::string, std::vector<double>> printed{
      {"TR1", {0.48, 0.27, 0.16, 0.09}}, {"TR2", {0.41, 0.23, 0.13, 0.23}},
      {"TR3", {0.18, 0.32, 0.32, 0.18}}, {"TR4", {0.54, 0.31, 0.10, 0.06}},
      {"TR5", {0.54, 0.31, 0.10, 0.06}}, {"TR6", {0.32, 0.18, 0.18, 0.32}},
      {"TR7", {0.25, 0.25, 0.25, 0.25}}};
  for (std::size_t row = 0; row < 2; ++row) {
    const Shares bars = shares(spec, row, "published");
    ASSERT_EQ(bars.size(), 7U);
    for (const auto& [name, values] : printed) {
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(bars.at(name).at("T" + std::to_string(i + 1)), values[i], 1e-12) << name;
      }
    }
    std::size_t faulty = 0;
    for (const Json& value : spec["vconcat"][row]["data"]["values"]) {
      if (value.value("at fault", false)) {
        ++faulty;
        EXPECT_TRUE(value["panel"] == "TR4" || value["panel"] == "TR5") << value;
      }
    }
    EXPECT_EQ(faulty, 8U);
  }
}

TEST(FigureNine, HasAMarkForEachValue) {
  const std::string svg =
      read_text(catalogue().folder.path() / "page" / "figures" / "figure-9.svg");
  std::size_t bars = 0;
  std::size_t symbols = 0;
  const auto paths_of = [&](const std::string& kind) {
    std::size_t paths = 0;
    for (std::size_t at = svg.find(kind); at != std::string::npos; at = svg.find(kind, at + 1)) {
      paths += count(svg.substr(at, svg.find("</g>", at) - at), "<path ");
    }
    return paths;
  };
  bars = paths_of("class=\"mark-rect role-mark ");
  symbols = paths_of("class=\"mark-symbol role-mark ");
  EXPECT_EQ(bars, 2U * 7 * 4);
  EXPECT_EQ(symbols, 2U * 7 * 4);
}

TEST(FigureNine, TakesOtherRoutingsAndCoefficients) {
  const Ranked ranked({"M-1-P-2-P-3-M", "1-P-2-P-3-P-1", "--mu", "0.05"});
  const Json spec = ranked.spec("figure-9");
  ASSERT_EQ(spec["vconcat"].size(), 1U);
  const Shares model = shares(spec, 0, "model");
  ASSERT_EQ(model.size(), 2U);
  for (const auto& [panel, strands] : model) {
    double sum = 0;
    for (const auto& [strand, share] : strands) sum += share;
    EXPECT_EQ(strands.size(), 6U);
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  EXPECT_TRUE(shares(spec, 0, "published").empty());
}

TEST(FigureNine, DrawsTheMeansOfTheDataAndLabelsSimulatedOnes) {
  const TemporaryFolder data;
  const std::string rows =
      "run,routing,held,direction,T1_N,T2_N,T3_N,T4_N\n"
      "A,TR1,1,pull,4,3,2,1\n"
      "A,TR1,1,pull,5,3,1,1\n"
      "B,TR1,2,pull,1,1,1,1\n"
      "B,TR1,1,release,1,1,1,1\n"
      "B,TR1,1,pull,1,1,1,\n"
      "B,TR2,1,pull,1,1,1,1\n";
  const std::string measured = data.write("measured.csv", rows).string();
  const Ranked ranked({"TR1", "TR7", "--data", measured});
  const Json spec = ranked.spec("figure-9");
  const auto means = shares(spec, 0, "measured").at("TR1");
  EXPECT_NEAR(means.at("T1"), 0.45, 1e-12);
  EXPECT_NEAR(means.at("T3"), 0.15, 1e-12);
  for (const Json& value : spec["vconcat"][0]["data"]["values"]) {
    if (value["source"] != "measured" || value["strand"] != "T1") continue;
    EXPECT_NEAR(value["high"].get<double>() - value["low"].get<double>(), 2 * std::sqrt(0.005),
                1e-12);
  }
  EXPECT_NE(ranked.html.find("id=\"figure-9-held-2\""), std::string::npos);
  const Json& notes = ranked.json["measured_data"]["notes"];
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0]["lines"].dump(), "[5]");
  EXPECT_EQ(notes[1]["lines"].dump(), "[6]");
  EXPECT_NE(notes[2]["text"].get<std::string>().find("M-1-T-2-M"), std::string::npos);
  EXPECT_EQ(ranked.html.find("simulated"), std::string::npos);

  const std::string simulated = data.write("simulated.csv", "# simulated\n" + rows).string();
  const Ranked labelled({"TR1", "TR7", "--data", simulated});
  EXPECT_TRUE(shares(labelled.spec("figure-9"), 0, "measured").empty());
  EXPECT_EQ(shares(labelled.spec("figure-9"), 0, "simulated data").size(), 1U);
  EXPECT_NE(labelled.html.find("The data are simulated"), std::string::npos);
}

TEST(RankingPage, LiesBesideTheUsualResult) {
  EXPECT_TRUE(catalogue().result.out.starts_with(reeve({"rank", "--catalog"}).out));
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const ProcessResult printed = reeve({"rank", "--catalog", "--format", "json", "--out", out});
  EXPECT_EQ(read_text(folder.path() / "ranking.json"), printed.out);
}

TEST(RankingPage, SaysWhoIsFirstAndByWhatOthersAre) {
  const std::string& html = catalogue().html;
  EXPECT_NE(html.find("TR7 comes first, with mean uniformity 0.998"), std::string::npos);
  EXPECT_NE(html.find("<li>force transmission ("), std::string::npos);
  for (const Json& best : catalogue().json["best"]) {
    if (best["objective"] == "force_transmission") {
      EXPECT_EQ(best["routings"].dump(), R"(["M-1-T-2-F"])");
    }
  }
}

TEST(RankingPage, DrawsEachRoutingInEachGrasp) {
  EXPECT_EQ(count(catalogue().html, "<figure class=\"schematic\""), 7U * 3);
  EXPECT_EQ(catalogue().json["routings"].size(), 7U);
  for (const char* file :
       {"pareto", "figure-9", "tensions-held-none", "schematic-1-held-1", "schematic-7-held-2"}) {
    const std::filesystem::path figures = catalogue().folder.path() / "page" / "figures";
    EXPECT_TRUE(std::filesystem::exists(figures / (std::string(file) + ".svg"))) << file;
  }
}

TEST(RankingPage, SaysWhatUncertaintyAndMarginsFind) {
  const Ranked ranked({"TR3", "TR7", "--uncertainty", "--draws", "20", "--margin"});
  for (const char* part : {"id=\"ranks\"", "id=\"margins-table\"", "id=\"ranges-table\"",
                           "first in 100.0 % of the draws", "20 draws, seed 1"}) {
    EXPECT_NE(ranked.html.find(part), std::string::npos) << part;
  }
}

TEST(RankingPage, HasTheSameBytesEachTime) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = folder.path();
  reeve({"rank", "TR1", "TR7", "--out", "a"}, options);
  const std::string first = read_text(folder.path() / "a" / "index.html");
  reeve({"rank", "TR1", "TR7", "--out", "a", "--threads", "1"}, options);
  EXPECT_TRUE(read_text(folder.path() / "a" / "index.html") == first);
}

// Names of routings are plain; those of files, of runs and of columns are anything.
TEST(RankingPage, EscapesWhatUsersWrite) {
  const TemporaryFolder folder;
  const std::string data = folder
                               .write("<b>&.csv",
                                      "run,routing,held,</script><img>,T1_N,T2_N,T3_N,T4_N\n"
                                      "A,TR1,1,5,4,3,2,1\n")
                               .string();
  const Ranked ranked({"TR1", "TR3", "--data", data});
  const std::string page = ranked.html.substr(0, ranked.html.find("</main>"));
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&amp;.csv"), std::string::npos);
  EXPECT_NE(page.find("&lt;/script&gt;&lt;img&gt;"), std::string::npos);
}

}  // namespace
}  // namespace reeve::testing
