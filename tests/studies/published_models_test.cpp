#include "studies/published_models.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "diagnosis/verdict/losses.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/studies/shipped_catalogue.hpp"

namespace reeve {
namespace {

constexpr double tube = 0.18 * std::numbers::pi;
constexpr double sheath = 2 * tube;
constexpr double bearing = 0.001 * std::numbers::pi;

const std::string strands = "run,routing,held,T1_N,T2_N,T3_N,T4_N\n";

std::vector<PublishedModel> published(const std::string& rows, const std::string& above = strands) {
  const MeasuredData data = parse_measured_data(above + rows, "d.csv", testing::routing_of);
  DiagnosisResult result;
  result.cells = testing::cells_as_measured(data);
  result.share_errors = share_errors(data, result.cells);
  result.losses = losses(data, result.model, result.cells);
  return published_models(testing::shipped_catalogue(), data, result);
}

// The readings of TR4 and TR7, and a mounting of TR4 in a grasp of which nothing is published.
const std::string readings =
    "4,TR4,1,36.11,30.84,18.35,14.54\n7,TR7,1,24.56,25.61,25.07,24.63\n8,TR4,2,30,28,22,20\n";

TEST(PublishedModels, AreTablesAndFiguresOfTheRoutingsInTheirGrasp) {
  const auto models = published(readings);
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[0].name, "Table IV, Table VII");
  EXPECT_EQ(models[0].mu, 0.18);
  EXPECT_EQ(models[1].name, "Fig. 9 (b)");
  EXPECT_EQ(models[1].mu, 0.09);
  for (const PublishedModel& model : models) ASSERT_EQ(model.lines.size(), 2U);
  EXPECT_EQ(models[0].lines[0].shares, (std::vector<double>{0.54, 0.31, 0.10, 0.06}));
  EXPECT_EQ(models[0].lines[1].group, 1U);
}

TEST(PublishedModels, AreOffByTheSharesAsPrintedAndByThoseOfTheEquations) {
  const PublishedLine line = published(readings)[0].lines[0];
  const double read[] = {36.11 / 99.84, 30.84 / 99.84, 18.35 / 99.84, 14.54 / 99.84};
  const double t = std::exp(-tube), two = std::exp(-2 * sheath - bearing);
  const double whole = 1 + t + t * two + t * t * two;
  const double equations[] = {1 / whole, t / whole, t * two / whole, t * t * two / whole};
  double printed_squares = 0, squares = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    printed_squares += std::pow(read[i] - line.shares[i], 2);
    squares += std::pow(read[i] - equations[i], 2);
  }
  EXPECT_NEAR(line.error, std::sqrt(printed_squares), 1e-12);
  EXPECT_NEAR(line.equations, std::sqrt(squares), 1e-12);
  const PublishedModel model = published(readings)[0];
  EXPECT_NEAR(model.error, (model.lines[0].error + model.lines[1].error) / 2, 1e-12);
  EXPECT_NEAR(model.equations, (model.lines[0].equations + model.lines[1].equations) / 2, 1e-12);
}

// From T2 to T3 of TR4 one of two sheaths is drawn; from T3 to T4, both behind it, the shares of
// 10 and 6 % are rounded; from T1 to T2 nothing differs.
TEST(PublishedModels, NameTheLossesThatTheirLinesHaveOtherwise) {
  const std::vector<PublishedLoss> losses = published(readings)[0].losses;
  ASSERT_EQ(losses.size(), 2U);
  EXPECT_NEAR(losses[0].printed, std::log(31.0 / 10), 1e-12);
  EXPECT_NEAR(losses[0].equations, 2 * sheath + bearing, 1e-9);
  EXPECT_EQ(losses[0].sheaths, 2);
  EXPECT_EQ(losses[0].sheaths_drawn, 1);
  EXPECT_NEAR(losses[1].equations, tube, 1e-9);
  EXPECT_EQ(losses[1].sheaths, 0);
  EXPECT_EQ(losses[1].sheaths_drawn, 0);
}

// Of what the tendon loses when it is let out nothing is published.
TEST(PublishedModels, NameNoLossOfReleasing) {
  const auto models =
      published("4,TR4,1,pull,36.11,30.84,18.35,14.54\n4,TR4,1,release,14.54,18.35,30.84,36.11\n",
                "run,routing,held,direction,T1_N,T2_N,T3_N,T4_N\n");
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[0].losses.size(), 2U);
}

// Shares are printed of strands alone: nothing is of the two stretches from T2 to T3 by way of a
// sensor beside the motor.
TEST(PublishedModels, NameNoLossToOrFromASensorBesideTheMotor) {
  for (const char* between : {"Tb", "Tc"}) {
    const auto models =
        published("4,TR4,1,36.11,30.84,24,18.35,14.54\n",
                  fmt::format("run,routing,held,T1_N,T2_N,{}_N,T3_N,T4_N\n", between));
    ASSERT_EQ(models.size(), 2U);
    ASSERT_EQ(models[0].losses.size(), 1U) << between;
    EXPECT_EQ(models[0].losses[0].sheaths, 0);
  }
}

// The same routing, but its T1 is the catalogue's T3.
TEST(PublishedModels, OfAWordThatIsWrittenOtherwiseAreNone) {
  EXPECT_TRUE(published("4,M-2-P-1-F,1,36.11,30.84,18.35,14.54\n").empty());
}

TEST(PublishedModels, OfSimulatedReadingsAreNone) {
  EXPECT_TRUE(published(readings, "# simulated\n" + strands).empty());
}

TEST(PublishedModels, OfReadingsInAnotherGraspAreNone) {
  EXPECT_TRUE(published("8,TR4,2,30,28,22,20\n").empty());
}

// Their distances, as the diagnosis has them of its own errors, not that of their mean.
TEST(PublishedModels, AreOffByTheMeanOverTheRowsOfAGroup) {
  const std::string low = "1,TR4,1,20,30,30,20\n";
  const std::string high = "2,TR4,1,70,10,10,10\n";
  const PublishedLine both = published(low + high)[0].lines[0];
  const PublishedLine first = published(low)[0].lines[0];
  const PublishedLine second = published(high)[0].lines[0];
  EXPECT_NEAR(both.error, (first.error + second.error) / 2, 1e-12);
  EXPECT_NEAR(both.equations, (first.equations + second.equations) / 2, 1e-12);
}

std::string name_of_tables(const std::vector<std::string>& routings) {
  std::string rows;
  for (const std::string& routing : routings) rows += "r," + routing + ",1,4,3,2,1\n";
  return published(rows)[0].name;
}

TEST(PublishedModels, AreNamedByTheTablesThatAreUsed) {
  EXPECT_EQ(name_of_tables({"TR4"}), "Table IV");
  EXPECT_EQ(name_of_tables({"TR4", "TR1"}), "Table I, Table IV");
  EXPECT_EQ(name_of_tables({"TR1", "TR2", "TR4", "TR5"}), "Table I, Table II, Table IV, Table V");
  EXPECT_EQ(name_of_tables({"TR4", "TR3", "TR2"}), "Table II to Table IV");
  EXPECT_EQ(name_of_tables({"TR1", "TR2", "TR3", "TR4", "TR5", "TR6", "TR7"}),
            "Table I to Table VII");
}

}  // namespace
}  // namespace reeve
