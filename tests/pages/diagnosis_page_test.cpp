#include "pages/diagnosis_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "core/notation.hpp"

namespace reeve {
namespace {

const std::string hostile = "x\"y.a[0]</script><img src=x onerror=alert(1)>{{file}}";

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

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

// The page without the library, which is full of everything.
std::string body(const std::string& page) {
  return page.substr(0, page.find("id=\"chart-theme\""));
}

Json spec(const std::string& page, const std::string& id) {
  const std::size_t figure = page.find("<figure class=\"chart\" id=\"" + id + "\"");
  EXPECT_NE(figure, std::string::npos) << id;
  const std::string open = "class=\"spec\">";
  const std::size_t begin = page.find(open, figure) + open.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

const std::string& svg(const DiagnosisPage& page, const std::string& id) {
  const auto found = std::find_if(page.figures.begin(), page.figures.end(),
                                  [&](const FigureFile& file) { return file.id == id; });
  EXPECT_NE(found, page.figures.end()) << id;
  return found->svg;
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
  const Json compared = spec(page.html, "compared");
  EXPECT_EQ(compared["data"]["values"].size(), 20U);
  EXPECT_EQ(compared["concat"].size(), 2U);
  EXPECT_EQ(count(svg(page, "compared"), "aria-label=\"line"), 0U);  // no text of its own
  const std::string drawn = svg(page, "compared");
  std::size_t marks = 0;
  for (std::size_t at = drawn.find("mark-symbol role-mark"); at != std::string::npos;
       at = drawn.find("mark-symbol role-mark", at + 1)) {
    marks += count(drawn.substr(at, drawn.find("</g>", at) - at), "<path ");
  }
  EXPECT_EQ(marks, 40U);
}

// As the caption says: hollow what was fitted to, filled what no fit has seen.
TEST(DiagnosisPage, FillsTheHeldOutRunsAndDrawsEachModelInItsPanel) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  const Json compared = spec(html(report), "compared");
  for (const Json& value : compared["data"]["values"]) {
    const bool odd = value["line"].get<std::size_t>() % 2 == 1;  // of the second run
    EXPECT_EQ(value["held_out"], odd ? "held out" : "training");
    EXPECT_EQ(value["before"], 2.0);
    EXPECT_EQ(value["after"], 2.9);
  }
  const char* const fields[] = {"before", "after"};
  for (const std::size_t panel : {0U, 1U}) {
    const Json& encoding = compared["concat"][panel]["layer"][1]["encoding"];
    EXPECT_EQ(encoding["x"]["field"], fields[panel]);
    EXPECT_EQ(encoding["fillOpacity"]["scale"]["domain"], Json({"training", "held out"}));
    EXPECT_EQ(encoding["fillOpacity"]["scale"]["range"], Json({0, 0.9}));
    EXPECT_EQ(compared["concat"][panel]["title"].get<std::string>().find(fields[panel]), 0U);
  }
}

TEST(DiagnosisPage, DrawsTheResidualsThatTheDiagnosisJudges) {
  DiagnosisReport report = plain_report(10);
  name_tube_friction(report);
  for (ComparedCell& cell : report.result.cells) {
    cell.residual_before = 7;
    cell.residual_after = 0.5;
  }
  const Json values = spec(html(report), "residuals-routing")["data"]["values"];
  ASSERT_EQ(values.size(), 20U);
  for (const Json& value : values) {
    EXPECT_EQ(value["residual_before"], 7);
    EXPECT_EQ(value["residual_after"], 0.5);
  }
}

TEST(DiagnosisPage, SaysWhereTheNoiseIsEstimatedTooHigh) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(has(html(report), "the noise is estimated too high"));
  report.result.noise_limit = NoiseLimit{30, 25, 35, 0.1};
  EXPECT_TRUE(has(html(report), "the noise is estimated too high"));
}

TEST(DiagnosisPage, HasOnePanelWhereNothingExtendsTheModel) {
  EXPECT_EQ(spec(html(plain_report()), "compared")["concat"].size(), 1U);
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
  report.data.file = report.data.runs[1] = hostile;
  report.data.covariates = {hostile, "a.b[0]"};
  for (Reading& reading : report.data.readings) {
    reading.covariates = {static_cast<double>(reading.line), -static_cast<double>(reading.line)};
  }
  report.result.notes = {{NoteKind::covariate, hostile, {2, 3}}};
  const DiagnosisPage page = diagnosis_page({report, hostile, {}});
  EXPECT_FALSE(has(page.html, "<img"));
  EXPECT_TRUE(has(page.html, "&lt;img"));
  const Json chart = spec(page.html, "residuals-column-1");
  EXPECT_EQ(chart["data"]["values"][0]["c0"], 2);
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

TEST(DiagnosisPage, DrawsAPartOfManyValuesAndSaysSo) {
  DiagnosisReport report = plain_report(5000);
  const std::string page = html(report);
  const Json drawn = spec(page, "compared")["data"]["values"];
  EXPECT_EQ(drawn.size(), 1500U);
  EXPECT_TRUE(has(page, "Drawn are 1500 of 10000 values"));
  const auto of_first = std::count_if(drawn.begin(), drawn.end(),
                                      [](const Json& mark) { return mark["strand"] == "T1"; });
  EXPECT_NEAR(static_cast<double>(of_first), 750, 100);
}

TEST(DiagnosisPage, WeighsTheBestFirstBesideWhatNoiseAllows) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const std::string page = html(report);
  const Json weighed = spec(page, "weighed");
  EXPECT_EQ(weighed["data"]["values"][0]["name"], "◆ tube_friction");
  EXPECT_EQ(weighed["data"]["values"][0]["standing"], "named");
  EXPECT_EQ(weighed["data"]["values"][1]["standing"], "weighed");
  EXPECT_TRUE(has(weighed.dump(), "as good as noise allows"));
  EXPECT_TRUE(has(page, "would gain 50.0 (45.0 to 55.0)"));
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
  EXPECT_TRUE(has(spec(page, "weighed").dump(), "on training runs"));
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
