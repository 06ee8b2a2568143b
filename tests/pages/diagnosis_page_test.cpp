#include "pages/diagnosis/diagnosis_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "core/notation.hpp"
#include "tests/support/read_chart.hpp"
#include "tests/support/svg.hpp"

namespace reeve {
namespace {

using testing::count;
using testing::read_chart;
using testing::ReadGroup;
using testing::ReadMark;
using testing::ReadPanel;
using testing::ReadTick;

const std::string hostile_name = "x\"y.a[0]</script><img src=x onerror=alert(1)>{{file}}";

// Two routings, readings in two runs of which one is held out.
DiagnosisReport plain_report(std::size_t readings = 12) {
  DiagnosisReport report;
  report.data.file = "rig.csv";
  report.data.runs = {"first", "second"};
  for (const char* word : {"M-1-T-2-F", "M-1-P-2-M"}) {
    const Routing routing = parse_routing(word);
    report.data.routings.push_back({word, routing, expand(routing), {}});
  }
  report.data.channels = {{"T1", parse_segment("T1")}, {"T2", parse_segment("T2")}};
  for (std::size_t i = 0; i < readings; ++i) {
    Reading reading;
    reading.line = i + 2;
    reading.run = i % 2;
    reading.routing = i / 2 % 2;
    reading.motor_tension_N = 10 + static_cast<double>(i);
    report.data.readings.push_back(reading);
    for (std::size_t channel = 0; channel < 2; ++channel) {
      report.result.cells.push_back({{i, channel, 0, 3.0}, i % 2 == 1, 2.0, 2.9, 0.1, 0, 0, {}});
    }
  }
  report.result.rows = readings;
  report.result.runs = 2;
  report.result.held_out_runs = 1;
  report.result.noise_limit = NoiseLimit{50, 45, 55, 0.1};
  report.result.run_gains = {{1, readings, 1, 0.1, 0.1}};
  return report;
}

const HeldOut gained{1, 0.1, 0.9, 0.8, 0.95, 49, 40, 60, 48};

void name_tube_friction(DiagnosisReport& report) {
  NamedCause cause;
  cause.name = "tube_friction";
  cause.meaning = "the friction coefficient of the tubes is another one";
  cause.effect = {find_cause("tube_friction"), {}, {0.09}};
  cause.parameters = {{"mu", "1", 0.09, 0.08, 0.1, 0.18, Range{0.05, 0.2}}};
  cause.held_out = gained;
  report.result.causes = {cause};
  report.result.held_out = gained;
  report.result.weighed = {{"wear", 20, HeldOut{}}, {"tube_friction", 100, gained}};
  report.result.verdict = Verdict::cause;
}

std::string html(const DiagnosisReport& report) {
  return diagnosis_page({report, "reeve diagnose rig.csv --out out", {}}).html;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The page without its scripts.
std::string body(const std::string& page) { return page.substr(0, page.find("</main>")); }

const std::string& svg(const DiagnosisPage& page, const std::string& id) {
  const auto found = std::find_if(page.figures.begin(), page.figures.end(),
                                  [&](const FigureFile& file) { return file.id == id; });
  EXPECT_NE(found, page.figures.end()) << id;
  return found->svg;
}

std::vector<ReadPanel> chart(const DiagnosisPage& page, const std::string& id) {
  return read_chart(svg(page, id));
}

// The three sentences of the answer, escaped as in HTML but for what they do not have.
TEST(DiagnosisPage, BeginsWithTheAnswerAndTheVerdictInWordsAndShape) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const std::string page = body(html(report));
  EXPECT_TRUE(has(page, "data-verdict=\"cause\"")) << page.substr(0, 300);
  EXPECT_TRUE(has(page, "One cause is named"));
  EXPECT_TRUE(has(page, "<path d=\"M16 2l14 14-14 14L2 16z\"/>"));
  const std::string answer = diagnosis_answer(report);
  EXPECT_TRUE(has(page, answer.substr(0, answer.find('\n'))));
  EXPECT_LT(page.find("id=\"answer\""), page.find("id=\"compared\""));
}

TEST(DiagnosisPage, TellsEveryVerdictApart) {
  std::vector<std::string> shapes;
  for (int i = 0; i < 5; ++i) {
    DiagnosisReport report = plain_report();
    if (i == 1) name_tube_friction(report);
    if (i == 2) {
      report.result.verdict = Verdict::unexplained;
      report.result.unexplained = Unexplained{"order of the rows", "T1 of M-1-T-2-F", 0.001};
    }
    if (i == 3) {
      name_tube_friction(report);
      report.result.verdict = Verdict::indistinguishable;
      report.result.indistinguishable = {{"tube_friction", "wear"}};
    }
    if (i == 4) report.result.too_few_readings = true;
    const std::string page = body(html(report));
    const std::size_t begin = page.find("<h2 class=\"verdict\"");
    shapes.push_back(page.substr(begin, page.find("</h2>", begin) - begin));
    EXPECT_TRUE(has(shapes.back(), "<svg")) << i;
  }
  std::sort(shapes.begin(), shapes.end());
  EXPECT_EQ(std::unique(shapes.begin(), shapes.end()), shapes.end());
}

TEST(DiagnosisPage, DrawsOneMarkForEachValueBeforeAndAfter) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  for (const char* id : {"compared", "compared-logarithmic"}) {
    const std::vector<ReadPanel> panels = chart(page, id);
    ASSERT_EQ(panels.size(), 2U);
    for (const ReadPanel& panel : panels) EXPECT_EQ(panel.marks("points").size(), 20U);
  }
}

// As the caption says: hollow what was fitted to, filled what no fit has seen.
TEST(DiagnosisPage, FillsTheHeldOutRunsAndDrawsEachModelInItsPanel) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const std::vector<ReadPanel> panels = chart(diagnosis_page({report, "", {}}), "compared");
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
      chart(diagnosis_page({report, "", {}}), "residuals-routing");
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

// Two routings with residuals 1, 3 and -2, -4: means 2 and -3, standard deviations sqrt(2).
TEST(DiagnosisPage, DrawsMeanAndSpreadOfEachCategory) {
  DiagnosisReport report = plain_report(4);
  for (std::size_t i = 0; i < report.result.cells.size(); ++i) {
    const bool first = report.data.readings[report.result.cells[i].cell.reading].routing == 0;
    const double by = i % 2 == 0 ? -1 : 1;
    report.result.cells[i].residual_before = first ? 2 + by : -3 + by;
  }
  const ReadPanel panel = chart(diagnosis_page({report, "", {}}), "residuals-routing").front();
  const std::vector<ReadMark> spreads = panel.marks("spans");
  ASSERT_EQ(spreads.size(), 2U);
  EXPECT_EQ(spreads[0].title, "mean +2 sd, standard deviation 1.15 sd, of 4");
  EXPECT_EQ(spreads[1].title, "mean -3 sd, standard deviation 1.15 sd, of 4");
}

TEST(DiagnosisPage, SaysWhereTheNoiseIsEstimatedTooHigh) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(has(html(report), "the noise is estimated too high"));
  report.result.noise_limit = NoiseLimit{30, 25, 35, 0.1};
  EXPECT_TRUE(has(html(report), "the noise is estimated too high"));
}

TEST(DiagnosisPage, HasOnePanelWhereNothingExtendsTheModel) {
  EXPECT_EQ(chart(diagnosis_page({plain_report(), "", {}}), "compared").size(), 1U);
}

TEST(DiagnosisPage, DrawsResidualsOfNoColumnThatTheDataDoNotHave) {
  DiagnosisReport report = plain_report();
  for (Reading& reading : report.data.readings) reading.temperature_C = 20;
  const std::string page = html(report);
  for (const char* id : {"routing", "strand", "grasp", "load", "order"}) {
    EXPECT_TRUE(has(page, std::string("id=\"residuals-") + id + "\"")) << id;
  }
  for (const char* id : {"speed", "cycle", "temperature", "sheath-angle", "column-1"}) {
    EXPECT_FALSE(has(page, std::string("id=\"residuals-") + id + "\"")) << id;
  }
  EXPECT_TRUE(has(page, "The data have no speed, cycle, sheath angle:"));
  EXPECT_TRUE(has(page, "temperature, °C (20)"));
}

TEST(DiagnosisPage, TakesAnyNameOfTheUsers) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.data.file = report.data.runs[1] = hostile_name;
  report.data.covariates = {hostile_name, "a.b[0]"};
  for (Reading& reading : report.data.readings) {
    reading.covariates = {static_cast<double>(reading.line), -static_cast<double>(reading.line)};
  }
  report.result.notes = {{NoteKind::covariate, hostile_name, {2, 3}}};
  const DiagnosisPage page = diagnosis_page({report, hostile_name, {}});
  EXPECT_FALSE(has(page.html, "<img"));
  EXPECT_TRUE(has(page.html, "&lt;img"));
  const ReadPanel drawn = chart(page, "residuals-column-1").front();
  EXPECT_NEAR(drawn.x_of(drawn.marks("points").front()), 2, 0.01);
  EXPECT_FALSE(has(svg(page, "residuals-column-1"), "<img"));
  EXPECT_TRUE(has(svg(page, "residuals-column-2"), "a.b[0]"));
}

TEST(DiagnosisPage, LabelsSimulatedDataAtTheTopAndUnderEveryFigure) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(has(body(html(report)), "imulated data."));
  report.data.simulated = true;
  const std::string page = body(html(report));
  EXPECT_LT(page.find("id=\"simulated\""), page.find("id=\"answer\""));
  EXPECT_TRUE(has(page, "<title>Diagnosis of rig.csv (simulated)</title>"));
  EXPECT_EQ(count(page, "</strong> Simulated data."), count(page, "<figcaption>"));
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
  EXPECT_TRUE(has(page.html, "(a) as diagnosed: μ of tubes 0.09, of sheaths 0.18"));
  EXPECT_TRUE(has(page.html, "averaged over the routings, is of the model in (a) 2.0 %."));
  const ReadPanel panel = chart(page, "figure-9").front();
  EXPECT_EQ(panel.marks("bars", "measured").size(), 4U);
  EXPECT_EQ(panel.marks("points", "model").size(), 4U);
  EXPECT_TRUE(has(page.html, "<td>16.0 %</td><td>2.0 %</td><td>2.5 %</td>"));
  EXPECT_FALSE(has(html(plain_report()), "id=\"distribution\""));
}

TEST(DiagnosisPage, SaysWhichStretchStandsApart) {
  DiagnosisReport report = plain_report();
  Loss loss;
  loss.high = parse_segment("T1");
  loss.low = parse_segment("T2");
  loss.over = {ContactKind::tube};
  loss.rows = 3;
  loss.measured = std::log(2);
  loss.before = loss.after = std::log(1.25);
  report.result.losses = {loss};
  EXPECT_TRUE(has(html(report), "<td>0.500</td><td>0.800</td>"));
  EXPECT_FALSE(has(html(report), "note apart"));
  report.result.losses[0].stands_apart = true;
  EXPECT_TRUE(has(html(report), "<p class=\"note apart\">M-1-T-2-F, T1 to T2: 0.500"));
  EXPECT_TRUE(has(html(report), "<tr class=\"notable\">"));
}

TEST(DiagnosisPage, DrawsAPartOfManyValuesAndSaysSo) {
  DiagnosisReport report = plain_report(5000);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  const std::vector<ReadMark> drawn = chart(page, "compared").front().marks("points");
  EXPECT_EQ(drawn.size(), 1500U);
  EXPECT_TRUE(has(page.html, "Drawn are 1500 of 10000 values"));
  const auto of_first = std::count_if(drawn.begin(), drawn.end(), [](const ReadMark& mark) {
    return mark.title.find(" T1, run") != std::string::npos;
  });
  EXPECT_NEAR(static_cast<double>(of_first), 750, 100);
}

TEST(DiagnosisPage, WeighsTheBestFirstBesideWhatNoiseAllows) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const DiagnosisPage page = diagnosis_page({report, "", {}});
  const ReadPanel weighed = chart(page, "weighed").front();
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
  EXPECT_TRUE(has(page.html, "would gain 50.0 (45.0 to 55.0)"));
}

TEST(DiagnosisPage, SaysWhereNothingWasHeldOutOrConfirmed) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.held_out_runs = 0;
  report.result.held_out.reset();
  report.result.noise_limit.reset();
  report.result.run_gains.clear();
  report.result.causes[0].held_out.reset();
  for (WeighedCause& cause : report.result.weighed) cause.held_out.reset();
  report.result.not_confirmed = {"wear"};
  const std::string page = html(report);
  EXPECT_TRUE(has(page, "Nothing was held out, so how much better"));
  EXPECT_TRUE(has(page, "Not confirmed: wear."));
  EXPECT_TRUE(has(page, "gain in log-likelihood on training runs</text>"));
  EXPECT_FALSE(has(page, "id=\"held-out-runs\""));
}

TEST(DiagnosisPage, GivesTheRowsThatTheNextMeasurementFills) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  PlannedMeasurement planned;
  planned.measurement.routing = "M-1-T-2-F";
  planned.measurement.direction = Direction::release;
  planned.measurement.conditions.motor_tension_N = 25;
  planned.measurement.conditions.speed_mm_s = 40;
  planned.measurement.uses_speed = true;
  planned.why = "it says most";
  planned.parameter = "mu";
  planned.expected = {{"T1", 12.5, 12.5, 0.2}, {"a", 25, 25, 0.3}};
  report.result.next_measurement = planned;
  EXPECT_TRUE(has(html(report),
                  "run,routing,held,direction,motor_tension_N,speed_mm_s,T1_N,Ta_N\n"
                  "NEW,M-1-T-2-F,,release,25,40,,"));
}

}  // namespace
}  // namespace reeve
