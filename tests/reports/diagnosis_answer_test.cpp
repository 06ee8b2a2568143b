// The first lines of a diagnosis, by its verdict; tests/golden has whole ones.
#include <gtest/gtest.h>

#include "causes/library.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"

namespace reeve {
namespace {

NamedCause tubes() {
  NamedCause cause;
  cause.effect = {find_cause("tube_friction"), {}, {0.09}};
  cause.name = "tube_friction";
  cause.meaning = "the tubes' friction is another one";
  cause.parameters = {{"mu", "1", 0.09, 0.087, 0.093, 0.18, Range{0.05, 0.2}}};
  return cause;
}

DiagnosisReport report_of(Verdict verdict) {
  DiagnosisReport report;
  report.result.verdict = verdict;
  report.result.p_value = 0.4;
  report.result.structure_p_value = 0.7;
  report.result.cells = {{{}, false, 1, 0, 0.1, 10, 0, std::nullopt}};
  return report;
}

bool says(const DiagnosisReport& report, const std::string& text) {
  return diagnosis_answer(report).find(text) != std::string::npos;
}

TEST(DiagnosisAnswer, OfNoCauseSaysWhetherOneWasNotConfirmed) {
  DiagnosisReport report = report_of(Verdict::none);
  EXPECT_TRUE(says(report, "No cause is named: chance alone would give"));
  EXPECT_FALSE(says(report, "do not confirm"));
  report.result.not_confirmed = {"wear", "temperature"};
  EXPECT_TRUE(says(report,
                   "No cause is named: wear or temperature looked likely, but the training runs do "
                   "not confirm it when each is forecast from the others."));
  EXPECT_FALSE(says(report, "chance alone"));
}

TEST(DiagnosisAnswer, OfTooFewReadingsClaimsNothing) {
  const DiagnosisReport report = report_of(Verdict::too_few);
  EXPECT_TRUE(says(report, "cannot be said: the readings are too few"));
  EXPECT_FALSE(says(report, "explains the data"));
}

TEST(DiagnosisAnswer, NamesACauseWithItsIntervalAndItsGain) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes = {tubes()};
  EXPECT_TRUE(says(report,
                   "The tubes' friction is another one: tube_friction, mu = 0.090 (0.087 to"
                   " 0.093; the hardware says 0.180, literature 0.05 to 0.2)."));
  EXPECT_TRUE(says(report, "Nothing was held out"));
  report.result.held_out = HeldOut{1, 0.2, 0.8, 0.7, 0.9, 50, 40, 60, 50};
  report.result.held_out_runs = 2;
  EXPECT_TRUE(says(report, "on 2 held-out runs fall by 80 % (70 % to 90 %)"));
}

TEST(DiagnosisAnswer, OfCausesThatCannotBeToldApartNamesThemAll) {
  DiagnosisReport report = report_of(Verdict::indistinguishable);
  report.result.causes = {tubes()};
  report.result.indistinguishable = {{"tube_friction", "wear", "temperature"}};
  EXPECT_TRUE(says(report, "tube_friction, wear or temperature explains the data"));
  EXPECT_TRUE(says(report, "No measurement that was looked at tells tube_friction from wear."));
}

TEST(DiagnosisAnswer, OfWhatIsUnexplainedSaysWhere) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  report.result.unexplained = Unexplained{"grasp", "T2 of M-1-F, held 1 (reads more)", 0.001};
  EXPECT_TRUE(says(report, "no cause in the library explains: grasp, most of all T2 of M-1-F"));
  EXPECT_TRUE(says(report, "No cause is named."));
  report.result.causes = {tubes()};
  EXPECT_TRUE(says(report, "Part of it is explained"));
}

}  // namespace
}  // namespace reeve
