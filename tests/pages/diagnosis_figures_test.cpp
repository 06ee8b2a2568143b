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
  const PageFiles page = diagnosis_page({report, "", {}});
  for (const char* id : {"compared", "compared-logarithmic"}) {
    const std::vector<ReadPanel> panels = chart_of(page, id);
    ASSERT_EQ(panels.size(), 2U);
    for (const ReadPanel& panel : panels) EXPECT_EQ(panel.marks("points").size(), 20U);
  }
}

// Two readings of a law through 0 at x = 2, one of them of a sealed run.
TEST(DiagnosisPage, DrawsEachCauseOverWhatItFollowsWithItsCurveAndBand) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  PartialResiduals partial;
  partial.x = {"temperature", "°C"};
  partial.y = {"relative change of the friction exponent", "1"};
  partial.points = {{1, -0.5, 0.1, 0, false}, {3, 0.4, 0.1, 1, true}};
  partial.curve = {{1, -0.45, -0.5, -0.4}, {2, 0, 0, 0}, {3, 0.45, 0.4, 0.5}};
  partial.left_out = 3;
  report.result.causes[0].partial = partial;
  const PageFiles page = diagnosis_page({report, "", {}});
  const std::vector<ReadPanel> panels = chart_of(page, "partial-1");
  ASSERT_EQ(panels.size(), 1U);
  const std::vector<ReadMark> points = panels[0].marks("points");
  ASSERT_EQ(points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(panels[0].x_of(points[i]), partial.points[i].x, 0.01);
    EXPECT_NEAR(panels[0].y_of(points[i]), partial.points[i].y, 0.01);
    EXPECT_EQ(contains(points[i].title, "held out"), partial.points[i].held_out);
  }
  const std::string& svg = svg_of(page, "partial-1");
  for (const char* name : {"95 % band", "fitted to", "held out", "without it", "temperature, °C"}) {
    EXPECT_TRUE(contains(svg, name)) << name;
  }
  EXPECT_TRUE(contains(page.html, "Not drawn: 3 points that hardly depend on it."));
}

TEST(DiagnosisPage, BeginsWithASentenceAFigureAndATableOfAtMostSixRows) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  report.result.causes.assign(8, report.result.causes.front());
  const std::string html = diagnosis_html(report);
  const std::size_t lead = html.find("class=\"lead\"");
  const std::size_t figure = html.find("id=\"compared\"");
  const std::size_t table = html.find("id=\"findings\"");
  const std::size_t end = html.find("</table>", table);
  EXPECT_LT(lead, figure);
  EXPECT_LT(figure, table);
  ASSERT_NE(end, std::string::npos);
  const std::string rows = html.substr(table, end - table);
  std::size_t count = 0;
  for (std::size_t at = rows.find("<tr"); at != std::string::npos; at = rows.find("<tr", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, 1U + 6);
  EXPECT_TRUE(contains(html, "2 more below"));
}

TEST(DiagnosisPage, FillsTheHeldOutRunsAndDrawsEachModelInItsPanel) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const std::vector<ReadPanel> panels = chart_of(diagnosis_page({report, "", {}}), "compared");
  const double predicted[] = {2.0, 2.9};
  const char* const titles[] = {"before: the nominal model", "after: the extended model"};
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
  const PageFiles page = diagnosis_page(
      {report, "", {}, TensionDistributions{{distribution}, SharedData{"rig.csv", false, {}}, 0}});
  EXPECT_TRUE(contains(page.html, "(a) as diagnosed: μ of tubes 0.09, of sheaths 0.18"));
  EXPECT_TRUE(contains(page.html, "averaged over the routings, is of the model in (a) 2.0 %."));
  const ReadPanel panel = chart_of(page, "figure-9").front();
  EXPECT_EQ(panel.marks("bars", "measured").size(), 4U);
  EXPECT_EQ(panel.marks("points", "model").size(), 4U);
  EXPECT_TRUE(contains(page.html, "<td>16.0 %</td><td>2.0 %</td><td>2.5 %</td>"));
  EXPECT_FALSE(contains(diagnosis_html(plain_report()), "id=\"distribution\""));
}

TEST(DiagnosisPage, SaysOfADistributionInWhichGraspItIsWhereThereIsAChoice) {
  const DiagnosisReport report = plain_report();
  TensionDistribution distribution;
  distribution.routings = {{"M-1-F", "", "", 1, {{"T1", 0.6, {}, {}}, {"T2", 0.4, {}, {}}}}};
  const auto page = [&] {
    return diagnosis_page({report, "", {}, TensionDistributions{{distribution}, {}, 0}}).html;
  };
  EXPECT_TRUE(contains(page(), "Pulling; the strands of each routing"));
  EXPECT_FALSE(contains(page(), "Tension distributions, no finger held."));
  distribution.grasp = hold({1});
  EXPECT_TRUE(contains(page(), "With finger 1 held, pulling; the strands of each routing"));
  distribution.grasp = {};
  distribution.routings[0].strands.push_back({"T3", 0.1, {}, {}});
  EXPECT_TRUE(contains(page(), "Tension distributions, no finger held."));
}

TEST(DiagnosisPage, DrawsAPartOfManyValuesAndSaysSo) {
  DiagnosisReport report = plain_report(5000);
  const PageFiles page = diagnosis_page({report, "", {}});
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
  const PageFiles page = diagnosis_page({report, "", {}});
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

std::vector<std::string> texts(const std::vector<ReadTick>& ticks) {
  std::vector<std::string> result;
  for (const ReadTick& tick : ticks) result.push_back(tick.text);
  return result;
}

TEST(DiagnosisPage, WeighsTheNamedModelWhereverItStands) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.weighed.resize(1);
  for (int i = 1; i <= 20; ++i) {
    report.result.weighed.push_back({{"other" + std::to_string(i)}, 200.0 + i, gained});
  }
  report.result.weighed.push_back({{"tube_friction"}, 100, gained});
  const PageFiles page = diagnosis_page({report, "", {}});
  const ReadPanel weighed = chart_of(page, "weighed").front();
  const std::vector<std::string> names = texts(weighed.y);
  ASSERT_EQ(names.size(), 15U);
  EXPECT_EQ(names[0], "other20");
  EXPECT_EQ(names[13], "other7");
  EXPECT_EQ(names[14], "◆ tube_friction");
  ASSERT_EQ(weighed.marks("points", "named").size(), 1U);
  EXPECT_NEAR(weighed.marks("points", "named")[0].y, weighed.y[14].at, 0.02);
  const std::string some =
      "Drawn are the named model and the likeliest others, 15 of 22; the table has "
      "all.";
  EXPECT_TRUE(contains(page.html, some));
  report.result.noise_limit.reset();
  EXPECT_TRUE(contains(diagnosis_html(report), some));
}

// On the training runs it gains 20, which says nothing on an axis of held-out runs.
TEST(DiagnosisPage, PutsNoMarkWhereTheHeldOutRunsCouldNotBeForecast) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.weighed[0].held_out.reset();
  const PageFiles page = diagnosis_page({report, "", {}});
  const ReadPanel weighed = chart_of(page, "weighed").front();
  EXPECT_EQ(texts(weighed.y), (std::vector<std::string>{"◆ tube_friction", "wear"}));
  EXPECT_TRUE(weighed.marks("points", "weighed").empty());
  EXPECT_EQ(weighed.marks("points", "named").size(), 1U);
  EXPECT_TRUE(contains(page.html, "A row without a mark: that model has no tensions"));
  EXPECT_FALSE(contains(diagnosis_html(plain_report()), "A row without a mark"));
}

TEST(DiagnosisPage, WritesOutTheNamesOfThreeCauses) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const std::vector<std::string> longest{"load_dependent_friction", "speed_dependent_friction",
                                         "wrong_grasp[M-1-T-2-F]"};
  report.result.weighed.push_back({longest, 10, gained});
  const std::string svg = svg_of(diagnosis_page({report, "", {}}), "weighed");
  EXPECT_FALSE(contains(svg, "…"));
  EXPECT_TRUE(contains(svg, ">load_dependent_friction + "));
}

TEST(DiagnosisPage, RoundsInTheChartAsInTheTable) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.weighed = {
      {{"tube_friction"}, 357.96, HeldOut{1, 0.1, 0.9, 0.8, 0.95, 206.14, 63.24, 348.6, 48}}};
  const PageFiles page = diagnosis_page({report, "", {}});
  const ReadPanel weighed = chart_of(page, "weighed").front();
  EXPECT_EQ(weighed.marks("points", "named").at(0).title,
            "tube_friction: named\nall readings: 358\nheld-out runs: 206 (63.2 to 349)");
  EXPECT_TRUE(contains(page.html, "<td>358</td><td>206</td><td>63.2 to 349</td>"));
}

// The same readings of two routings without fingers.
TEST(DiagnosisPage, SpeaksOfNoGraspOnABench) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.structure = {{"grasp", 1, 0.2}};
  const std::string of_a_hand = diagnosis_html(report);
  EXPECT_TRUE(contains(of_a_hand, "held fingers: none; pull"));
  EXPECT_TRUE(contains(of_a_hand, "id=\"residuals-grasp\""));
  for (MeasuredRouting& measured : report.data.routings) {
    measured.routing = parse_routing("M-F");
    measured.network = expand(measured.routing);
  }
  std::string page = diagnosis_html(report);
  page.resize(page.find("</main>"));
  EXPECT_TRUE(contains(page, "\npull; motor"));
  EXPECT_TRUE(contains(page, "<td>direction</td>") || contains(page, ">direction<"));
  for (const char* word : {"held fingers", "grasp", "finger held", "jam"}) {
    EXPECT_FALSE(contains(page, word)) << word;
  }
}

}  // namespace
}  // namespace reeve::testing
