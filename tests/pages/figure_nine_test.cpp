// The figure of tension distributions of `rank --out`, against the paper's closed forms and tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "pages/distribution_figure.hpp"
#include "tests/pages/ranked.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

// What is drawn of a source in one row of the figure: panel, strand -> share.
using Shares = std::map<std::string, std::map<std::string, double>>;

constexpr double hair = 1e-4;  // of a share: a hundredth of a pixel

// Rows are of as many panels as there are routings.
Shares shares(const std::vector<ReadPanel>& panels, std::size_t row, std::size_t routings,
              const std::string& kind, const std::string& source) {
  Shares result;
  for (std::size_t i = row * routings; i < (row + 1) * routings; ++i) {
    const ReadPanel& panel = panels[i];
    for (const ReadMark& mark : panel.marks(kind, source)) {
      result[panel.texts.front()][panel.category_of(mark)] = panel.y_of(mark);
    }
  }
  return result;
}

Shares model_shares(const std::vector<ReadPanel>& panels, std::size_t row,
                    std::size_t routings = 7) {
  return shares(panels, row, routings, "points", "model");
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

// Of TR1 with finger 1 held, twice.
TensionDistributions of_three_readings() {
  TensionDistribution one;
  one.kind = FrictionKind::coefficient;
  one.tube_mu = 0.18;
  one.grasp = hold({1});
  RoutingShares& tr1 = one.routings.emplace_back();
  tr1.word = "M-1-T-2-F";
  tr1.name = "TR1";
  tr1.published_source = "Table I";
  tr1.readings = 3;
  for (const char* strand : {"T1", "T2", "T3", "T4"}) {
    tr1.strands.push_back({strand, 0.25, PublishedShare{0.3, "a slip"}, MeasuredShare{0.2, 0.1}});
  }
  return {{one, one}, SharedData{"d.csv", false, {}}, 0};
}

TEST(FigureNine, SaysWhatItsBarsAreMeansOf) {
  TensionDistributions distributions = of_three_readings();
  const auto first_bar = [&] {
    return read_chart(distribution_figures(distributions).at(0).svg)
        .front()
        .marks("bars")
        .at(0)
        .title;
  };
  EXPECT_EQ(first_bar(), "T1, measured: 20.0 %, mean of 3 readings");
  distributions.list[0].routings[0].readings = 1;
  EXPECT_EQ(first_bar(), "T1, measured: 20.0 %");
}

TEST(FigureNine, ReadsItsNumbersOutInWords) {
  TensionDistributions distributions = of_three_readings();
  const Figure figure = distribution_figures(distributions).at(0);
  EXPECT_NE(figure.svg.find("sheaths 0.18, model: TR1 25 25 25 25 %;"), std::string::npos);
  EXPECT_EQ(figure.caption.find("sensors"), std::string::npos);
  distributions.list[1].sensors_differ = true;
  EXPECT_NE(
      distribution_figures(distributions)
          .at(0)
          .caption.find("What is wrong with the sensors is in the bars and not in the lines."),
      std::string::npos);
}

// However many rows draw it.
TEST(FigureNine, NamesEachSourceAndEachFaultOnce) {
  const std::string notes = distribution_notes(of_three_readings());
  EXPECT_EQ(count(notes, "TR1: Table I"), 1U);
  EXPECT_EQ(count(notes, "a slip"), 4U);
}

TEST(FigureNine, DrawsTheClosedFormsAsTheModel) {
  const std::vector<ReadPanel> panels = catalogue().chart("figure-9");
  ASSERT_EQ(panels.size(), 2U * 7);
  const std::vector<double> coefficients{0.18, 0.09};
  for (std::size_t row = 0; row < 2; ++row) {
    const Shares model = model_shares(panels, row);
    EXPECT_EQ(model.size(), 7U);
    for (const char* name : {"TR1", "TR3", "TR7"}) {
      const std::vector<double> expected = closed_form(name, coefficients[row]);
      ASSERT_EQ(model.at(name).size(), 4U);
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(model.at(name).at("T" + std::to_string(i + 1)), expected[i], hair)
            << name << " T" << i + 1 << " at " << coefficients[row];
      }
    }
  }
}

// The sheaths' exponent counts too: TR4 loses two sheaths between its fingers (Eq. 14).
TEST(FigureNine, VariesTubesAndSheathsAlike) {
  const double pi = std::numbers::pi;
  const double ratio = std::exp(-2 * 0.09 * 2 * pi - 0.001 * pi);
  const auto model = model_shares(catalogue().chart("figure-9"), 1).at("TR4");
  EXPECT_NEAR(model.at("T3") / model.at("T2"), ratio, 10 * hair);
}

TEST(FigureNine, DrawsWhatIsPrintedAndMarksWhatTheCheckDoesNotFind) {
  const std::vector<ReadPanel> panels = catalogue().chart("figure-9");
  // Tables I to VII, and the lines of Fig. 9 (b), which are read from the figure.
  const std::map<std::string, std::vector<double>> printed[] = {
      {{"TR1", {0.48, 0.27, 0.16, 0.09}},
       {"TR2", {0.41, 0.23, 0.13, 0.23}},
       {"TR3", {0.18, 0.32, 0.32, 0.18}},
       {"TR4", {0.54, 0.31, 0.10, 0.06}},
       {"TR5", {0.54, 0.31, 0.10, 0.06}},
       {"TR6", {0.32, 0.18, 0.18, 0.32}},
       {"TR7", {0.25, 0.25, 0.25, 0.25}}},
      {{"TR4", {0.40, 0.30, 0.17, 0.128}}, {"TR7", {0.25, 0.25, 0.25, 0.25}}}};
  for (std::size_t row = 0; row < 2; ++row) {
    const Shares found = shares(panels, row, 7, "points", "published");
    const Shares faulty = shares(panels, row, 7, "points", "published, not found by the check");
    EXPECT_EQ(found.size(), 5U);
    EXPECT_EQ(faulty.size(), 2U);
    for (const auto& [name, values] : printed[row]) {
      const Shares& drawn = name == "TR4" || name == "TR5" ? faulty : found;
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(drawn.at(name).at("T" + std::to_string(i + 1)), values[i], hair) << name;
      }
    }
  }
}

TEST(FigureNine, DashesTheLinesOfWhatIsPublishedAlone) {
  for (const ReadPanel& panel : catalogue().chart("figure-9")) {
    std::size_t dashed = 0;
    for (const ReadGroup& group : panel.groups) {
      if (group.kind != "paths") continue;
      const bool is_dashed = group.attributes.find("stroke-dasharray") != std::string::npos;
      EXPECT_EQ(is_dashed, group.series != "model");
      dashed += is_dashed ? 1 : 0;
    }
    EXPECT_EQ(dashed, 1U);
  }
}

TEST(FigureNine, HasAMarkForEachValue) {
  std::size_t bars = 0;
  std::size_t symbols = 0;
  for (const ReadPanel& panel : catalogue().chart("figure-9")) {
    bars += panel.marks("bars").size();
    symbols += panel.marks("points").size();
  }
  EXPECT_EQ(bars, 0U);
  EXPECT_EQ(symbols, 2U * 2U * 7 * 4);  // of the model, and published
}

TEST(FigureNine, TakesOtherRoutingsAndCoefficients) {
  const Ranked ranked({"M-1-P-2-P-3-M", "1-P-2-P-3-P-1", "--distribution-mu", "0.05"});
  const std::vector<ReadPanel> panels = ranked.chart("figure-9");
  ASSERT_EQ(panels.size(), 2U);
  const Shares model = model_shares(panels, 0, 2);
  ASSERT_EQ(model.size(), 2U);
  for (const auto& [panel, strands] : model) {
    double sum = 0;
    for (const auto& [strand, share] : strands) sum += share;
    EXPECT_EQ(strands.size(), 6U);
    EXPECT_NEAR(sum, 1, 6 * hair);
  }
  EXPECT_TRUE(shares(panels, 0, 2, "points", "published").empty());
}

TEST(FigureNine, DrawsTheModelAsItIsToo) {
  const TemporaryFolder folder;
  const std::string hardware =
      folder.write("rough.toml", "[tube]\nmu = 0.05\n[sheath]\nmu = 0.3\n").string();
  const Ranked ranked({"TR1", "TR4", "--hardware", hardware, "--distribution-mu", "0.18,model"});
  const std::vector<ReadPanel> panels = ranked.chart("figure-9");
  ASSERT_EQ(panels.size(), 4U);
  const auto tr1 = model_shares(panels, 1, 2).at("TR1");
  EXPECT_NEAR(tr1.at("T2") / tr1.at("T1"), std::exp(-0.05 * std::numbers::pi), 10 * hair);
  const auto tr4 = model_shares(panels, 1, 2).at("TR4");
  EXPECT_NEAR(tr4.at("T3") / tr4.at("T2"), std::exp(-(2 * 0.3 * 2 + 0.001) * std::numbers::pi),
              20 * hair);
  EXPECT_TRUE(shares(panels, 1, 2, "points", "published").empty());
  EXPECT_NE(ranked.html.find("(b) the nominal model: μ of tubes 0.05, of sheaths 0.3"),
            std::string::npos);
  const Json& row = ranked.json["tension_distributions"][1];
  EXPECT_TRUE(row["mu"].is_null());
  EXPECT_EQ(row["friction"], "model");
  EXPECT_EQ(row["sheath_mu"], 0.3);
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
  const std::vector<ReadPanel> panels = ranked.chart("figure-9");
  const auto means = shares(panels, 0, 2, "bars", "measured").at("TR1");
  EXPECT_NEAR(means.at("T1"), 0.45, hair);
  EXPECT_NEAR(means.at("T3"), 0.15, hair);
  // ± the standard deviation of 0.4 and 0.5: from end to end 2 sqrt(0.005).
  const ReadMark deviation = panels.front().marks("spans").front();
  ReadMark end = deviation;
  end.y = deviation.bottom;
  const double half = panels.front().y_of(deviation) - panels.front().y_of(end);
  EXPECT_NEAR(half, std::sqrt(0.005), hair);
  EXPECT_NE(ranked.html.find("id=\"figure-9-held-2\""), std::string::npos);
  const Json& notes = ranked.json["measured_data"]["notes"];
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0]["lines"].dump(), "[5]");
  EXPECT_EQ(notes[1]["lines"].dump(), "[6]");
  EXPECT_NE(notes[2]["text"].get<std::string>().find("M-1-T-2-M"), std::string::npos);
  EXPECT_EQ(ranked.html.find("simulated"), std::string::npos);

  const std::string simulated = data.write("simulated.csv", "# simulated\n" + rows).string();
  const Ranked labelled({"TR1", "TR7", "--data", simulated});
  const std::vector<ReadPanel> drawn = labelled.chart("figure-9");
  EXPECT_TRUE(shares(drawn, 0, 2, "bars", "measured").empty());
  EXPECT_EQ(shares(drawn, 0, 2, "bars", "simulated data").size(), 1U);
  EXPECT_NE(labelled.html.find("The data are simulated"), std::string::npos);
}

}  // namespace
}  // namespace reeve::testing
