#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pages/diagnosis/diagnosis_page.hpp"
#include "tests/pages/diagnosed.hpp"

namespace reeve::testing {
namespace {

TEST(DiagnosisPage, DrawsOneMarkForEachValueBeforeAndAfter) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  for (const char* id : {"compared", "compared-logarithmic"}) {
    const std::vector<ReadPanel> panels = chart_of(page, id);
    ASSERT_EQ(panels.size(), 2U);
    for (const ReadPanel& panel : panels) EXPECT_EQ(panel.marks("points").size(), 20U);
  }
}

TEST(DiagnosisPage, FillsTheHeldOutRunsAndDrawsEachModelInItsPanel) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const std::vector<ReadPanel> panels = chart_of(diagnosis_page({report, "", {}}), "compared");
  const double predicted[] = {2.0, 2.9};
  const char* const titles[] = {"before: the model as it stands", "after: the extended model"};
  for (const std::size_t panel : {0U, 1U}) {
    EXPECT_EQ(panels[panel].texts.front(), titles[panel]);
    std::size_t held_out = 0;
    for (const ReadGroup& group : panels[panel].groups) {
      const bool hollow = group.attributes.find("fill-opacity=0;") != std::string::npos;
      for (const ReadMark& mark : group.marks) {
        if (group.kind != "points") continue;
        EXPECT_NEAR(panels[panel].x_of(mark), predicted[panel], 0.001);
        EXPECT_NEAR(panels[panel].y_of(mark), 3, 0.001);
        const bool trained = mark.title.find("training") != std::string::npos;
        EXPECT_EQ(hollow, trained) << mark.title;
        held_out += trained ? 0U : 1U;
      }
    }
    EXPECT_EQ(held_out, 10U);
  }
}

TEST(DiagnosisPage, DrawsTheResidualsThatTheDiagnosisJudges) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  for (ComparedCell& cell : report.result.cells) {
    cell.residual_before = 7;
    cell.residual_after = 0.5;
  }
  const std::vector<ReadPanel> panels =
      chart_of(diagnosis_page({report, "", {}}), "residuals-routing");
  ASSERT_EQ(panels.size(), 2U);
  // Where 7 and 0.5 lie on the scale sign(v) ln(1 + |v| / 2), from the ticks +3 and −3.
  const auto bent = [](double v) { return std::copysign(std::log1p(std::abs(v) / 2), v); };
  const ReadTick low = panels[0].y.front();
  const ReadTick high = panels[0].y.back();
  ASSERT_EQ(low.text, "−3");
  ASSERT_EQ(high.text, "+3");
  const double residual[] = {7, 0.5};
  for (const std::size_t panel : {0U, 1U}) {
    const double share = (bent(residual[panel]) - bent(-3)) / (bent(3) - bent(-3));
    const std::vector<ReadMark> marks = panels[panel].marks("points");
    ASSERT_EQ(marks.size(), 20U + 2);  // and the means of two routings
    for (const ReadMark& mark : marks) {
      EXPECT_NEAR(mark.y, low.at + share * (high.at - low.at), 0.03);
    }
  }
}

TEST(DiagnosisPage, DrawsMeanAndSpreadOfEachCategory) {
  DiagnosisReport report = plain_report(4);
  for (std::size_t i = 0; i < report.result.cells.size(); ++i) {
    const bool first = report.data.readings[report.result.cells[i].cell.reading].routing == 0;
    const double by = i % 2 == 0 ? -1 : 1;
    report.result.cells[i].residual_before = first ? 2 + by : -3 + by;
  }
  const ReadPanel panel = chart_of(diagnosis_page({report, "", {}}), "residuals-routing").front();
  const std::vector<ReadMark> spreads = panel.marks("spans");
  ASSERT_EQ(spreads.size(), 2U);
  EXPECT_EQ(spreads[0].title, "mean +2 sd, standard deviation 1.15 sd, of 4");
  EXPECT_EQ(spreads[1].title, "mean -3 sd, standard deviation 1.15 sd, of 4");
}

TEST(DiagnosisPage, HasOnePanelWhereNothingExtendsTheModel) {
  EXPECT_EQ(chart_of(diagnosis_page({plain_report(), "", {}}), "compared").size(), 1U);
}

TEST(DiagnosisPage, DrawsResidualsOfNoColumnThatTheDataDoNotHave) {
  DiagnosisReport report = plain_report();
  for (Reading& reading : report.data.readings) reading.temperature_C = 20;
  const std::string page = diagnosis_html(report);
  for (const char* id : {"routing", "strand", "grasp", "load", "order"}) {
    EXPECT_TRUE(contains(page, std::string("id=\"residuals-") + id + "\"")) << id;
  }
  for (const char* id : {"speed", "cycle", "temperature", "sheath-angle", "column-1"}) {
    EXPECT_FALSE(contains(page, std::string("id=\"residuals-") + id + "\"")) << id;
  }
  EXPECT_TRUE(contains(page, "The data have no speed, cycle, sheath angle:"));
  EXPECT_TRUE(contains(page, "temperature, °C (20)"));
}

TEST(DiagnosisPage, DrawsTheTensionDistributionAndHasItsErrors) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  add_effect(report.result.model, report.result.causes[0].effect);
  report.result.share_errors = {{{0, {}, 3, 1, 0.16, 0.02, 0.025}}, 0.16, 0.02, 0.025};
  TensionDistribution distribution;
  distribution.kind = FrictionKind::diagnosed;
  distribution.tube_mu = 0.09;
  distribution.sheath_mu = 0.18;
  distribution.share_errors.model = 0.02;
  distribution.routings = {{"M-1-T-2-F", "", "", 3, {}}};
  for (const double share : {0.4, 0.3, 0.2, 0.1}) {
    distribution.routings[0].strands.push_back(
        {"T", share, std::nullopt, MeasuredShare{share + 0.01, 0.002}});
  }
  const DiagnosisPage page = diagnosis_page(
      {report, "", {}, TensionDistributions{{distribution}, SharedData{"rig.csv", false, {}}, 0}});
  EXPECT_TRUE(contains(page.html, "(a) as diagnosed: μ of tubes 0.09, of sheaths 0.18"));
  EXPECT_TRUE(contains(page.html, "averaged over the routings, is of the model in (a) 2.0 %."));
  const ReadPanel panel = chart_of(page, "figure-9").front();
  EXPECT_EQ(panel.marks("bars", "measured").size(), 4U);
  EXPECT_EQ(panel.marks("points", "model").size(), 4U);
  EXPECT_TRUE(contains(page.html, "<td>16.0 %</td><td>2.0 %</td><td>2.5 %</td>"));
  EXPECT_FALSE(contains(diagnosis_html(plain_report()), "id=\"distribution\""));
}

TEST(DiagnosisPage, DrawsAPartOfManyValuesAndSaysSo) {
  DiagnosisReport report = plain_report(5000);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  const std::vector<ReadMark> drawn = chart_of(page, "compared").front().marks("points");
  EXPECT_EQ(drawn.size(), 1500U);
  EXPECT_TRUE(contains(page.html, "Drawn are 1500 of 10000 values"));
  const auto of_first = std::count_if(drawn.begin(), drawn.end(), [](const ReadMark& mark) {
    return mark.title.find(" T1, run") != std::string::npos;
  });
  EXPECT_NEAR(static_cast<double>(of_first), 750, 100);
}

TEST(DiagnosisPage, WeighsTheBestFirstBesideWhatNoiseAllows) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  const ReadPanel weighed = chart_of(page, "weighed").front();
  const ReadMark named = weighed.marks("points", "named").at(0);
  const ReadMark other = weighed.marks("points", "weighed").at(0);
  ASSERT_EQ(weighed.y.size(), 2U);
  EXPECT_EQ(weighed.y[0].text, "◆ tube_friction");
  EXPECT_NEAR(weighed.y[0].at, named.y, 0.02);
  EXPECT_NEAR(weighed.y[1].at, other.y, 0.02);
  EXPECT_NEAR(weighed.x_of(named), 49, 0.01);
  EXPECT_NEAR(weighed.x_of(other), 0, 0.01);
  const ReadMark limit = weighed.marks("rules", "as good as noise allows").at(0);
  EXPECT_NEAR(weighed.x_of(limit), 50, 0.01);
  EXPECT_TRUE(contains(page.html, "would gain 50.0 (45.0 to 55.0)"));
}

}  // namespace
}  // namespace reeve::testing
