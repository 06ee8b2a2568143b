// The sentences below the tables of a diagnosis; tests/golden has no text of one.
#include "reports/diagnosis/diagnosis_evidence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "causes/library.hpp"
#include "core/notation.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/document/document.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

using Sentences = std::vector<std::string>;

Effect tube_mu(double mu) { return {find_cause("tube_friction"), {}, {mu}}; }

NamedCause other_tubes() {
  NamedCause cause;
  cause.effect = tube_mu(0.09);
  cause.name = "tube_friction";
  cause.parameters = {{"mu", "1", 0.09, 0.08, 0.1, 0.18, Range{0.05, 0.2}}};
  return cause;
}

Loss stretch(const char* high, const char* low, double left) {
  Loss loss;
  loss.high = parse_segment(high);
  loss.low = parse_segment(low);
  loss.over = {ContactKind::tube};
  loss.measured = -std::log(left);
  loss.after = -std::log(0.75);
  return loss;
}

// M-1-T-2-F, which the catalogue calls TR1: one stretch stands apart from two others.
DiagnosisReport report_of_stretches() {
  DiagnosisReport report;
  const Routing routing = parse_routing("M-1-T-2-F");
  report.data.routings = {{"M-1-T-2-F", routing, expand(routing), {}}};
  report.names = {{"M-1-T-2-F", "TR1"}};
  report.data.runs = {"Monday", "Tuesday", "Friday"};
  report.data.channels = {{"T1", parse_segment("T1")}, {"T4", parse_segment("T4")}};
  report.data.readings.resize(1);
  report.data.readings[0].line = 9;
  report.result.losses = {stretch("T1", "T2", 0.5), stretch("T2", "T3", 1.1),
                          stretch("T3", "T4", 1.3)};
  report.result.losses[0].stands_apart = true;
  return report;
}

void name_tubes(DiagnosisReport& report) {
  report.result.causes = {other_tubes()};
  report.result.model.effects = {tube_mu(0.09)};
}

void fit_without_one(DiagnosisReport& report) {
  WithoutApart without;
  without.left_out = {{0, 1, 0, 3.0}};
  without.model.effects = {tube_mu(0.085)};
  without.intervals = {{{0.08, 0.09}}};
  report.result.without_apart = without;
}

CalibratedCoefficient tubes(double low, double high, double p_value, bool differs) {
  return {"tube_friction", {"mu", "1", 0.15, low, high, 0.18, Range{0.05, 0.2}}, p_value, differs};
}

// An interval that leaves the hardware's value out does not agree with it.
TEST(Coefficients, AreWhatTheHardwareSaysOnlyWhereTheIntervalHasIt) {
  DiagnosisResult result;
  result.calibration = {tubes(0.14, 0.18, 0.3, false), tubes(0.12, 0.17, 0.034, false),
                        tubes(0.12, 0.17, 0.001, true)};
  EXPECT_EQ(coefficient_sentences(result),
            (Sentences{
                "tube_friction: mu = 0.150 (0.140 to 0.180), agrees with the nominal value (0.180)",
                "tube_friction: mu = 0.150 (0.120 to 0.170), perhaps differs from the "
                "nominal value (0.180), too little to name it (p = 0.034)",
                "tube_friction: mu = 0.150 (0.120 to 0.170), differs from the nominal "
                "value (0.180)"}));
}

TEST(DiagnosisEvidence, SaysHowMuchIsLeftOverAStretchThatStandsApartAndOverOthers) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  EXPECT_EQ(
      loss_sentences(report),
      Sentences{"TR1, T1 to T2: 0.500 of the tension is left, where the extended model has "
                "0.750 and other stretches over tube read 1.10 to 1.30: this contact, or this "
                "reading, is not like the others."});
}

TEST(DiagnosisEvidence, ComparesAStretchWithTheModelAsItStandsWhereNothingExtendsIt) {
  DiagnosisReport report = report_of_stretches();
  report.result.losses.resize(1);
  EXPECT_EQ(loss_sentences(report),
            Sentences{"TR1, T1 to T2: 0.500 of the tension is left, where the nominal model "
                      "has 0.750: this contact, or this reading, is not like the others."});
}

TEST(DiagnosisEvidence, SaysWhatTheCausesAreWithoutTheReadingsThatStandApart) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  EXPECT_EQ(without_apart_sentences(report), Sentences{});
  fit_without_one(report);
  report.result.without_apart->share_error = 0.034;
  EXPECT_EQ(without_apart_sentences(report),
            Sentences{"Fitted to all readings but T4 of TR1 (line 9): tube_friction, mu = 0.085 "
                      "(0.080 to 0.090); the tension distribution is then off by 3.4 % on "
                      "average."});
}

TEST(DiagnosisEvidence, CountsReadingsThatAreAlikeWhereManyStandApart) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  fit_without_one(report);
  std::vector<Cell>& left_out = report.result.without_apart->left_out;
  for (std::size_t reading = 1; reading < 8; ++reading) {
    report.data.readings.push_back(report.data.readings[0]);
    left_out.push_back({reading, 1, 0, 3.0});
  }
  report.data.readings[3].direction = Direction::release;
  report.data.readings[4].grasp = Grasp{0b1};
  report.data.readings[5].grasp = Grasp{0b1};
  report.data.readings[6].grasp = Grasp{0b10};
  report.data.readings[7].grasp = Grasp{0b11};
  EXPECT_THAT(without_apart_sentences(report).front(),
              ::testing::StartsWith(
                  "Fitted to all readings but T4 of TR1, held none (3 readings), T4 of TR1 "
                  "(line 9), T4 of TR1, held 1 (2 readings), T4 of TR1 (line 9) and 1 more: "
                  "tube_friction"));
}

TEST(DiagnosisEvidence, SaysNothingOfADistributionThatNoReadingHas) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  fit_without_one(report);
  EXPECT_EQ(without_apart_sentences(report),
            Sentences{"Fitted to all readings but T4 of TR1 (line 9): tube_friction, mu = 0.085 "
                      "(0.080 to 0.090)."});
  EXPECT_EQ(Json::parse(diagnosis_json(report))["without_apart"]["share_error"], nullptr);
}

TEST(DiagnosisEvidence, HasNoColumnOfGraspsOnABench) {
  DiagnosisReport report = report_of_stretches();
  report.result.share_errors.groups.resize(2);
  const auto first_heads = [&] {
    return std::pair(share_error_table(report).columns[1].heading,
                     loss_table(report).columns[1].heading);
  };
  EXPECT_EQ(first_heads(), std::pair(std::string("held"), std::string("held")));
  const Routing bench = parse_routing("M-F");
  report.data.routings = {{"M-F", bench, expand(bench), {}}};
  EXPECT_EQ(first_heads(), std::pair(std::string("readings"), std::string("direction")));
  for (const Table& table : {share_error_table(report), loss_table(report)}) {
    for (const TableRow& row : table.rows) EXPECT_EQ(row.cells.size(), table.columns.size());
  }
  EXPECT_EQ(loss_table(report).rows[0].cells[1], "pull");
  report.data.readings[0].grasp = hold({1});
  EXPECT_EQ(first_heads(), std::pair(std::string("held"), std::string("held")));
}

// A reader looks for the number of the answer in the tables below it.
TEST(DiagnosisEvidence, HasTheNumbersOfTheAnswerInItsTablesToTheDigit) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  report.result.verdict = Verdict::cause;
  report.result.p_value = report.result.causes[0].p_value = 1.0 / 1001;
  const HeldOut held_out{8.449, 0.8449, 0.9001, 0.8849, 0.9049, 206.14, 63.2, 348.6, 333.4};
  report.result.held_out = report.result.causes[0].held_out = held_out;
  report.result.held_out_runs = 2;
  report.result.residual_before_N = 8.449;
  report.result.causes[0].explained.rms_N = 7.5;
  report.result.weighed = {{{"tube_friction"}, 357.96, held_out}};
  const std::string text = reports::text(diagnosis_document(report));
  EXPECT_TRUE(testing::has(text, "fall by 90 % (88 % to 90 %): from 8.4 N to 0.84 N"));
  EXPECT_TRUE(testing::has(text, "The gain in likelihood is significant (p < 0.001).\n"));
  const auto line_with = [&](const std::string& beginning) {
    const std::size_t at = text.find(beginning);
    return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_TRUE(testing::has(line_with("tube_friction  7.5 N of 8.4 N  mu"), " < 0.001 ")) << text;
  EXPECT_TRUE(testing::has(line_with("tube_friction           8.4 N       0.84 N       90 %"),
                           "206    63.2 to 349"))
      << text;
  EXPECT_TRUE(testing::has(line_with("tube_friction           358"), "206")) << text;
}

TEST(DiagnosisEvidence, SaysHowRunsWereForecast) {
  DiagnosisReport report;
  report.result.rows = 12;
  report.result.runs = 3;
  EXPECT_EQ(reports::used_text(report), "12 readings in 3 runs");
  report.result.held_out_runs = 3;
  EXPECT_EQ(reports::used_text(report),
            "12 readings in 3 runs, each run forecast once by a model fitted without it");
  report.settings.hold_out = 0.3;
  report.result.held_out_runs = 1;
  EXPECT_EQ(reports::used_text(report), "12 readings in 3 runs, 1 of them held out");
}

// Of 1000 replicates. Chances of coefficients do not come from them and may lie just above.
TEST(DiagnosisEvidence, GivesAChanceAsABoundOnlyWhereReplicatesShowNoSmallerOne) {
  EXPECT_EQ(reports::p_number(1.0 / 1001, 1000), "< 0.001");
  EXPECT_EQ(p_text(1.0 / 1001, 1000), "p < 0.001");
  EXPECT_EQ(reports::p_number(0.0011, 1000), "0.0011");
  EXPECT_EQ(p_text(0.0011, 1000), "p = 0.0011");
}

TEST(DiagnosisEvidence, SaysHowSingleRunsMoveTheSizes) {
  DiagnosisReport report = report_of_stretches();
  name_tubes(report);
  EXPECT_EQ(influence_sentences(report), Sentences{});
  for (const double mu : {0.095, 0.06, 0.08}) {
    LeftOutRun run;
    run.run = report.result.left_out.size();
    run.model.effects = {tube_mu(mu)};
    report.result.left_out.push_back(run);
  }
  EXPECT_EQ(influence_sentences(report),
            Sentences{"With any one run left out and the others fitted, mu of tube_friction lies "
                      "between 0.060 and 0.095; run Tuesday moves it farthest."});
  // Below the causes, whether any reading has all strands or not.
  const std::string document = text(diagnosis_document(report));
  const std::size_t causes =
      document.find("Causes, by the share of the residuals that they explain");
  ASSERT_NE(causes, std::string::npos);
  EXPECT_LT(document.find("With any one run left out", causes),
            document.find("from sensor to sensor"));
}

TEST(DiagnosisEvidence, SaysWherePublishedLinesLoseOtherwiseThanTheirEquations) {
  DiagnosisReport report = report_of_stretches();
  report.result.causes = {other_tubes()};
  report.result.causes[0].name = "sheath_friction";
  PublishedModel model;
  model.name = "Fig. 9";
  model.mu = 0.18;
  model.error = 0.136;
  model.equations = 0.081;
  PublishedLoss other;
  other.loss = 0;
  other.printed = 0.57;
  other.equations = 2.26;
  other.sheaths = 2;
  other.sheaths_drawn = 1;
  PublishedLoss same = other;
  same.sheaths_drawn = same.sheaths;
  model.losses = {other, same};
  report.published = {model};
  const Sentences sentences = published_sentences(report);
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_EQ(sentences[0],
            "The published lines (Fig. 9, mu = 0.18) have a mean error of 13.6 %, the "
            "equations with that coefficient one of 8.1 %.");
  EXPECT_EQ(sentences[1],
            "TR1, T1 to T2, ln of the ratio: printed line 0.57 (1 sheath), equations 2.26 "
            "(2 sheaths), measured 0.69; 2 sheaths of mu = 0.090 add up to 0.180, and 1 of 0.18 "
            "to 0.18.");
}

}  // namespace
}  // namespace reeve
