#include "pages/diagnosis/diagnosis_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pages/diagnosis/diagnosis_labels.hpp"
#include "tests/pages/diagnosed.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

const std::string hostile_name = "x\"y.a[0]</script><img src=x onerror=alert(1)>{{file}}";

// The page without its scripts.
std::string body(const std::string& page) { return page.substr(0, page.find("</main>")); }

// The three sentences of the answer, escaped as in HTML but for what they do not have.
TEST(DiagnosisPage, BeginsWithTheAnswerAndTheVerdictInWordsAndShape) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  const std::string page = body(diagnosis_html(report));
  EXPECT_TRUE(contains(page, "data-verdict=\"cause\"")) << page.substr(0, 300);
  EXPECT_TRUE(contains(page, "One cause is named"));
  EXPECT_TRUE(contains(page, "<path d=\"M16 2l14 14-14 14L2 16z\"/>"));
  const std::string answer = diagnosis_answer(report);
  EXPECT_TRUE(contains(page, answer.substr(0, answer.find('\n'))));
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
    if (i == 4) report.result.verdict = Verdict::too_few;
    const std::string page = body(diagnosis_html(report));
    const std::size_t begin = page.find("<h2 class=\"verdict\"");
    shapes.push_back(page.substr(begin, page.find("</h2>", begin) - begin));
    EXPECT_TRUE(contains(shapes.back(), "<svg")) << i;
  }
  std::sort(shapes.begin(), shapes.end());
  EXPECT_EQ(std::unique(shapes.begin(), shapes.end()), shapes.end());
}

TEST(DiagnosisPage, DoesNotSayThatNothingIsWrongWhereWeakStructureRemains) {
  DiagnosisReport report = plain_report();
  report.result.structure = {{"strand", 3.2, 0.004}};
  report.result.structure_p_value = 0.021;
  EXPECT_TRUE(contains(diagnosis_html(report), "Nothing is wrong that the readings could show"));
  report.result.structure_p_value = 0.011;
  const std::string page = diagnosis_html(report);
  EXPECT_FALSE(contains(page, "Nothing is wrong"));
  EXPECT_TRUE(contains(page, "No cause is named, and weak structure remains</h2>"));
}

TEST(DiagnosisPage, AsksForALookAtRowsThatReadOtherwise) {
  for (const NoteKind kind : {NoteKind::other_direction, NoteKind::outlier_groups}) {
    DiagnosisReport report = plain_report();
    report.result.notes.push_back({kind, "", {}});
    EXPECT_EQ(pages::verdict_label(report).words,
              "No cause is named, but some readings are to be looked at first");
  }
}

TEST(WeighedModels, StandAsTheAnswerSays) {
  DiagnosisResult result;
  for (const char* name : {"tube_friction", "wear"}) {
    result.causes.emplace_back().name = name;
  }
  result.indistinguishable = {{"tube_friction", "temperature"}};
  result.not_confirmed = {"pretension"};
  for (const auto& [model, standing] :
       {std::pair<std::vector<std::string>, std::string>{{"tube_friction", "wear"}, "named"},
        {{"temperature", "wear"}, "cannot be told from it"},
        {{"temperature", "tube_friction", "wear"}, "weighed"},
        {{"pretension"}, "not confirmed"},
        {{"pretension", "wear"}, "weighed"}}) {
    EXPECT_EQ(pages::standing(result, model), standing);
  }
}

TEST(DiagnosisPage, SaysWhereTheNoiseIsEstimatedTooHigh) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(contains(diagnosis_html(report), "the noise is estimated too high"));
  report.result.noise_limit = NoiseLimit{30, 25, 35, 0.1};
  EXPECT_TRUE(contains(diagnosis_html(report), "the noise is estimated too high"));
}

// As the printed text has them, whether or not one of them is a cause.
TEST(DiagnosisPage, HasTheCalibratedFrictionWithItsIntervals) {
  DiagnosisReport report = plain_report();
  EXPECT_FALSE(contains(diagnosis_html(report), "id=\"calibrated\""));
  report.result.calibration = {
      {"tube_friction", {"mu", "1", 0.09, 0.08, 0.1, 0.18, Range{0.05, 0.2}}, 0.001, true},
      {"sheath_friction", {"mu", "1", 0.178, 0.17, 0.186, 0.18, Range{0.05, 0.2}}, 0.6, false}};
  const std::string page = body(diagnosis_html(report));
  const std::size_t begin = page.find("id=\"calibrated\"");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_GT(begin, page.find("id=\"causes\""));
  EXPECT_LT(begin, page.find("id=\"gain\""));
  const std::string table = page.substr(begin, page.find("</table>", begin) - begin);
  for (const char* cell :
       {"sheath_friction", "0.080 to 0.100", "0.170 to 0.186", "0.178",
        "Differs from the nominal value (0.180)", "Agrees with the nominal value (0.180)"}) {
    EXPECT_TRUE(contains(table, cell)) << cell << "\n" << table;
  }
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
  const PageFiles page = diagnosis_page({report, hostile_name, {}});
  EXPECT_FALSE(contains(page.html, "<img"));
  EXPECT_TRUE(contains(page.html, "&lt;img"));
  const ReadPanel drawn = chart_of(page, "residuals-column-1").front();
  EXPECT_NEAR(drawn.x_of(drawn.marks("points").front()), 2, 0.01);
  EXPECT_FALSE(contains(svg_of(page, "residuals-column-1"), "<img"));
  EXPECT_TRUE(contains(svg_of(page, "residuals-column-2"), "a.b[0]"));
}

TEST(DiagnosisPage, LabelsSimulatedDataAtTheTopAndUnderEveryFigure) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(contains(body(diagnosis_html(report)), "imulated data."));
  report.data.simulated = true;
  const std::string page = body(diagnosis_html(report));
  EXPECT_LT(page.find("id=\"simulated\""), page.find("id=\"answer\""));
  EXPECT_TRUE(contains(page, "<title>Diagnosis of rig.csv (simulated)</title>"));
  EXPECT_EQ(count(page, "</strong> Simulated data."), count(page, "<figcaption>"));
}

TEST(DiagnosisPage, SaysWhichStretchStandsApart) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.model.effects = {report.result.causes[0].effect};
  Loss loss;
  loss.high = parse_segment("T1");
  loss.low = parse_segment("T2");
  loss.over = {ContactKind::tube};
  loss.rows = 3;
  loss.measured = std::log(2);
  loss.before = std::log(1.25);
  loss.after = std::log(1.6);
  report.result.losses = {loss};
  std::string page = diagnosis_html(report);
  EXPECT_TRUE(contains(page, "<td>0.500</td><td>0.800</td><td>0.625</td>"));
  EXPECT_FALSE(contains(page, "note apart"));
  EXPECT_FALSE(contains(page, "class=\"notable\""));
  report.result.losses[0].stands_apart = true;
  page = diagnosis_html(report);
  EXPECT_TRUE(contains(page,
                       "<p class=\"note apart\">M-1-T-2-F, T1 to T2: 0.500 of the tension is left, "
                       "where the extended model has 0.625: this contact, or this reading, is not "
                       "like the others.</p>"));
  EXPECT_TRUE(contains(page, "<tr class=\"notable\">"));
}

TEST(DiagnosisPage, SaysOnceWhatTheCausesAreWithoutWhatStandsApart) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  Loss loss;
  loss.high = parse_segment("T1");
  loss.low = parse_segment("T2");
  loss.stands_apart = true;
  report.result.losses = {loss};
  WithoutApart without;
  without.left_out = {{0, 1, 0, 3.0}};
  report.result.without_apart = without;
  EXPECT_EQ(count(diagnosis_html(report), "Fitted to all readings but"), 1U);
}

TEST(DiagnosisPage, SaysHowSingleRunsMoveTheSizesThoughNoReadingHasAllStrands) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  EXPECT_FALSE(contains(diagnosis_html(report), "class=\"influence\""));
  LeftOutRun run;
  run.run = 1;
  report.result.left_out = {run};
  const std::string page = diagnosis_html(report);
  const std::size_t at = page.find("<p class=\"influence\">With any one run left out");
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(at, page.find("id=\"causes\""));
  EXPECT_LT(at, page.find("id=\"gain\""));
}

// One routing in so many grasps.
TensionDistributions distributions(int grasps) {
  TensionDistributions all;
  for (int i = 0; i < grasps; ++i) {
    TensionDistribution one;
    if (i > 0) one.grasp = hold({i});
    for (const FrictionKind kind : {FrictionKind::model, FrictionKind::diagnosed}) {
      one.kind = kind;
      one.routings = {{"M-1-T-2-F", "TR1", "Table IV", 1, {{"T1", 0.6, {}, {}}}}};
      all.list.push_back(one);
    }
  }
  all.data = SharedData{"rig.csv", false, {}};
  return all;
}

TEST(DiagnosisPage, NamesTheFaultsOfWhatIsPublishedBelowTheFigure) {
  DiagnosisReport report = plain_report();
  report.result.notes = {{NoteKind::comment, "rows may be switched off", {4}}};
  TensionDistributions all = distributions(1);
  all.list[0].routings[0].strands[0].published = PublishedShare{0.7, "T1 of another routing"};
  all.data->notes = report.result.notes;
  all.data->notes.push_back({NoteKind::not_compared, "line 8 is in no share", {}});
  const std::string page = diagnosis_page({report, "", {}, all}).html;
  const std::size_t figure = page.find("id=\"figure-9\"");
  const std::size_t fault = page.find("<li>TR1, Table IV, T1: T1 of another routing</li>");
  ASSERT_NE(fault, std::string::npos);
  EXPECT_LT(figure, fault);
  EXPECT_LT(fault, page.find("id=\"fit\""));
  EXPECT_TRUE(contains(page, "line 8 is in no share"));
  EXPECT_EQ(count(page, "rows may be switched off"), 1U);
  EXPECT_EQ(count(page, "id=\"data\""), 1U);
}

TEST(DiagnosisPage, DrawsTheDistributionsOfFourGraspsAtMost) {
  const DiagnosisReport report = plain_report();
  const PageFiles all = diagnosis_page({report, "", {}, distributions(4)});
  EXPECT_TRUE(contains(all.html, "id=\"figure-9-held-3\""));
  EXPECT_FALSE(contains(all.html, "not drawn; diagnosis.json"));
  const PageFiles some = diagnosis_page({report, "", {}, distributions(6)});
  EXPECT_TRUE(contains(some.html, "id=\"figure-9-held-3\""));
  EXPECT_FALSE(contains(some.html, "id=\"figure-9-held-4\""));
  EXPECT_TRUE(contains(some.html, "2 more grasps not drawn; diagnosis.json has the errors in all"));
}

TEST(DiagnosisPage, SaysWhereNothingWasHeldOutOrConfirmed) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  report.result.held_out_runs = 0;
  report.result.held_out.reset();
  report.result.noise_limit.reset();
  report.result.run_gains.clear();
  report.result.causes[0].held_out.reset();
  for (WeighedCauses& cause : report.result.weighed) cause.held_out.reset();
  report.result.not_confirmed = {"wear"};
  const std::string page = diagnosis_html(report);
  EXPECT_TRUE(contains(page, "Nothing was held out, so how much better"));
  EXPECT_TRUE(contains(page, "Not confirmed: wear."));
  EXPECT_TRUE(contains(page, "gain in log-likelihood on training runs</text>"));
  EXPECT_FALSE(contains(page, "id=\"held-out-runs\""));
}

TEST(DiagnosisPage, GivesTheRowsThatTheNextMeasurementFills) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  PlannedMeasurement planned;
  planned.measurement.routing = {"M-1-T-2-F", parse_routing("M-1-T-2-F")};
  planned.measurement.direction = Direction::release;
  planned.measurement.conditions.motor_tension_N = 25.125;
  planned.measurement.conditions.speed_mm_s = 40;
  planned.measurement.uses_speed = true;
  planned.why = "it says most";
  planned.parameter = "mu";
  planned.expected = {{"T1", 12.5, 12.5, 0.2}, {"a", 25, 25, 0.3}};
  report.result.next_measurement = planned;
  const std::string page = diagnosis_html(report);
  EXPECT_TRUE(contains(page,
                       "run,routing,held,direction,motor_tension_N,speed_mm_s,T1_N,Ta_N\n"
                       "NEW,M-1-T-2-F,,release,25.125,40,,"));
  EXPECT_TRUE(contains(page, "released with 25.125 N at the motor, at 40 mm/s."));
}

}  // namespace
}  // namespace reeve::testing
