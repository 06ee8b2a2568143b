// The first lines of a diagnosis, by its verdict; tests/golden has whole ones.
#include <gtest/gtest.h>

#include <algorithm>

#include "causes/library.hpp"
#include "causes/term.hpp"
#include "core/notation.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"

namespace reeve {
namespace {

NamedCause tubes() {
  NamedCause cause;
  cause.effect = {find_cause("tube_friction"), {}, {0.09}};
  cause.name = "tube_friction";
  cause.meaning = "the friction of the tubes differs";
  cause.parameters = {{"mu", "1", 0.09, 0.087, 0.093, 0.18, Range{0.05, 0.2}}};
  return cause;
}

DiagnosisReport report_of(Verdict verdict) {
  DiagnosisReport report;
  report.result.verdict = verdict;
  report.result.p_value = 0.4;
  report.result.structure_p_value = 0.7;
  report.result.cells = {{{}, false, 1, 0, 0.1, 10, 0, std::nullopt}};
  const Routing routing = parse_routing("M-1-T-2-F");
  report.data.routings = {{"M-1-T-2-F", routing, expand(routing), {}}};
  return report;
}

bool says(const DiagnosisReport& report, const std::string& text) {
  return diagnosis_answer(report).find(text) != std::string::npos;
}

TEST(DiagnosisAnswer, OfNoCauseSaysWhetherOneWasNotConfirmed) {
  DiagnosisReport report = report_of(Verdict::none);
  EXPECT_TRUE(says(report, "No cause is named: none raises the evidence by 3."));
  EXPECT_FALSE(says(report, "not confirmed"));
  report.result.not_confirmed = {"wear", "temperature"};
  EXPECT_TRUE(says(report,
                   "wear is not named: it is found in all readings, but not confirmed by models "
                   "that have not seen some of the runs.\ntemperature is not named"));
  EXPECT_FALSE(says(report, "none raises"));
}

TEST(DiagnosisAnswer, OfNoCauseSpeaksOfTheTrainingRunsWhereHeldOutOnesAreFar) {
  DiagnosisReport report = report_of(Verdict::none);
  EXPECT_TRUE(says(report, "explains the data as well as their noise allows.\nNo cause"));
  report.result.notes.push_back({NoteKind::outlier_forecast, "line 58", {58}});
  EXPECT_TRUE(says(report,
                   "explains the other runs as well as their noise allows.\nIt is far from some "
                   "readings of held-out runs: see the notes.\n"));
}

// Of a file whose routing column is wrong, say.
TEST(DiagnosisAnswer, SaysWhatMountingsItWouldTake) {
  DiagnosisReport report = report_of(Verdict::none);
  MountingScatter& scatter = report.result.mounting;
  scatter.present = {true, false, true, false};
  scatter.told_by = {5, 0, 0.5, 0};
  scatter.relative = {0.12, 0.04, 0.3, 0.005};
  EXPECT_FALSE(says(report, "believed"));
  scatter.relative = {0.59, 0.04, 2, 0.005};
  EXPECT_TRUE(says(report,
                   "The nominal model explains the data only if mountings differ by more than "
                   "can be believed.\nCheck this first: it takes mountings that differ by 59 % in "
                   "the sheaths' exponents, 200 % in the bearings' exponents, more than"));
  scatter.given = true;
  EXPECT_FALSE(says(report, "believed"));
}

// Of a file whose directions are blank, say, with half of its rows released.
TEST(DiagnosisAnswer, SaysWhatReadingsItWouldTake) {
  DiagnosisReport report = report_of(Verdict::none);
  report.result.noise.source = NoiseSource::smoothing;
  report.result.noise.relative = 0.3;
  EXPECT_FALSE(says(report, "believed"));
  report.result.noise.relative = 2;
  EXPECT_TRUE(says(report,
                   "The nominal model explains the data only if readings scatter by more than "
                   "can be believed.\nCheck this first: it takes readings that scatter by 200 %, "
                   "more than those of any force sensor."));
  report.result.noise.source = NoiseSource::known;
  EXPECT_FALSE(says(report, "believed"));
}

TEST(DiagnosisAnswer, AdvisesNoNoiseOfTheMotorThatNoMotorHas) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  report.result.unexplained = Unexplained{};
  report.result.row_scatter = RowScatter{0.017, 20};
  EXPECT_TRUE(says(report,
                   "off by 1.7 % from row to row: if it is a motor current or a coarse "
                   "sensor, say so with --noise motor=1.7%."));
  report.result.row_scatter = RowScatter{1.04, 20};
  EXPECT_TRUE(says(report, "off by 104 % from row to row: more than any motor's;"));
  EXPECT_FALSE(says(report, "--noise"));
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
                   "The friction of the tubes differs: tube_friction, mu = 0.090 (95 % CI 0.087 to"
                   " 0.093; nominal 0.180, literature 0.05 to 0.2)."));
  EXPECT_TRUE(says(report, "Nothing was held out"));
  report.result.held_out = HeldOut{1, 0.2, 0.8, 0.7, 0.9, 50, 40, 60, 50};
  report.result.held_out_runs = 2;
  EXPECT_TRUE(says(report, "on 2 held-out runs fall by 80 % (70 % to 90 %)"));
}

NamedCause other_sensor() {
  NamedCause cause;
  cause.effect = {find_cause("sensor_gain"), {}, {1.1}};
  cause.name = "sensor_gain[T4]";
  cause.meaning = "one sensor reads too much";
  cause.parameters = {{"gain", "1", 1.1, 1.05, 1.15, 1, std::nullopt}};
  return cause;
}

TEST(DiagnosisAnswer, SaysWhatOneRunAloneShows) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.data.runs = {"1", "2"};
  report.data.readings.resize(2);
  report.data.readings[1].run = 1;
  report.result.causes = {other_sensor()};
  report.result.causes[0].only_run = "2";
  ComparedCell of_run_1, of_run_2;
  of_run_1.cell.reading = 0;
  of_run_1.cell.measured_N = of_run_1.before_N = of_run_1.after_N = 9;
  of_run_2.cell.reading = 1;
  of_run_2.cell.measured_N = 5;
  of_run_2.before_N = 1;
  of_run_2.after_N = 4.5;
  report.result.cells = {of_run_1, of_run_2};
  EXPECT_TRUE(says(report,
                   "Run 2 alone shows sensor_gain[T4], so a gain on runs that the model has not "
                   "seen is not known; on run 2 residuals go from 4 N to 0.5 N.\n"))
      << diagnosis_answer(report);
  report.result.held_out = HeldOut{1, 0.2, 0.8, 0.7, 0.9, 50, 40, 60, 50};
  EXPECT_TRUE(says(report, "Residuals on"));
  EXPECT_TRUE(says(report, "Run 2 alone shows"));
}

// In log-likelihood, what each cause should gain on the held-out runs if it is right: 0 where they
// have no reading in which it shows.
// A few great readings of a mounting that is off outweigh all others in newton.
TEST(DiagnosisAnswer, OfResidualsThatRiseInNewtonAloneSaysBoth) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes = {tubes()};
  report.result.held_out_runs = 3;
  report.result.held_out = HeldOut{131, 140, -0.07, -0.16, -0.02, 50, 40, 60, 50};
  EXPECT_TRUE(
      says(report,
           "Residuals on 3 held-out runs rise by 7 % (2 % to 16 %): from 130 N to 140 N; but "
           "weighed by what noise and mountings do to each, the readings are likelier by "
           "50.0 (40.0 to 60.0) in log-likelihood."))
      << diagnosis_answer(report);
  report.result.held_out->gain_low = -1;
  EXPECT_FALSE(says(report, "likelier"));
}

TEST(DiagnosisAnswer, ClaimsNoGainOfACauseThatNoHeldOutRunCouldShow) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes = {tubes(), other_sensor()};
  const HeldOut tested{1, 0.2, 0.8, 0.7, 0.9, 50, 40, 60, 50};
  const HeldOut untested{1, 1, 0, 0, 0, 0, 0, 0, 0};
  report.result.held_out = tested;
  report.result.held_out_runs = 2;
  report.result.causes[0].held_out = report.result.causes[1].held_out = tested;
  EXPECT_TRUE(says(report, "Residuals on 2 held-out runs fall by 80 %"));
  EXPECT_FALSE(says(report, "say nothing of"));
  report.result.causes[1].held_out = untested;
  EXPECT_TRUE(says(report, "Residuals on 2 held-out runs fall by 80 %"));
  EXPECT_TRUE(says(report, "Held-out runs say nothing of sensor_gain[T4]:"));
  report.result.causes = {report.result.causes[1]};
  report.result.held_out = untested;
  EXPECT_FALSE(says(report, "Residuals on"));
}

TEST(DiagnosisAnswer, NamesTheGroupThatStandsOut) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  report.result.unexplained = Unexplained{"group", "T2 of M-1-F (reads more)", 0.001};
  report.data.groups = {"old winch", "new winch"};
  EstimatesByGroup sheaths;
  sheaths.cause = "sheath_friction";
  sheaths.parameter = "mu";
  sheaths.unit = "1";
  sheaths.groups = {{0, 0.18, {0.17, 0.19, 0.005, 30}}, {1, 0.12, {0.11, 0.13, 0.005, 30}}};
  sheaths.farthest = 1;
  sheaths.p_value = 0.002;
  sheaths.differs = true;
  report.result.by_group = {sheaths};
  EXPECT_TRUE(
      says(report,
           "By group, each fitted by itself, sheath_friction differs: mu = 0.180 (0.170 to "
           "0.190) in old winch, 0.120 (0.110 to 0.130) in new winch; new winch stands out"));
  const Table table = group_table(report);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].cells[1], "old winch");
  EXPECT_EQ(table.rows[0].cells[4], "");
  EXPECT_EQ(table.rows[1].cells[2], "0.120");
  EXPECT_EQ(table.rows[1].cells[4], "stands out (p = 0.002)");
  // No digits of a chance that no replicate could tell.
  report.result.by_group[0].p_value = 1e-38;
  EXPECT_TRUE(says(report, "new winch stands out (p < 0.001)"));
  report.result.by_group[0].differs = false;
  EXPECT_FALSE(says(report, "By group"));
}

TEST(DiagnosisAnswer, OfCausesThatCannotBeToldApartNamesThemAll) {
  DiagnosisReport report = report_of(Verdict::indistinguishable);
  report.result.causes = {tubes()};
  report.result.indistinguishable = {{"tube_friction", "wear", "temperature"}};
  EXPECT_TRUE(says(report, "Ambiguous: tube_friction, wear or temperature explains the data"));
  EXPECT_TRUE(
      says(report,
           "None of the candidate measurements separates tube_friction from wear or temperature."));
  report.result.separating_measurement.emplace().between = {"tube_friction", "temperature"};
  EXPECT_TRUE(says(report, "To tell tube_friction from temperature, measure "));
}

TEST(DiagnosisAnswer, OfWhatIsUnexplainedSaysWhere) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  report.result.unexplained = Unexplained{"grasp", "T2 of M-1-F, held 1 (reads more)", 0.001};
  EXPECT_TRUE(says(report, "no cause in the library explains: grasp, most of all T2 of M-1-F"));
  EXPECT_TRUE(says(report, "No cause is named."));
  report.result.causes = {tubes()};
  EXPECT_TRUE(says(report, "Part of it is explained"));
}

// Alpha is 0.02, of which the test of what is left takes a quarter.
TEST(DiagnosisAnswer, SaysThatNothingIsLeftOnlyWhereChanceGivesAsMuchOftenerThanAlpha) {
  const std::string nothing = "No further structure in the residuals";
  const std::string weak =
      "\nWeak structure remains by strand: 0.003 N of 3.1 N, negligible (p = 0.011), "
      "which does not reach this test's threshold of 0.005.\n";
  for (const Verdict verdict : {Verdict::none, Verdict::cause, Verdict::indistinguishable}) {
    SCOPED_TRACE(verdict_name(verdict));
    DiagnosisReport report = report_of(verdict);
    if (verdict != Verdict::none) report.result.causes = {tubes()};
    if (verdict == Verdict::indistinguishable) {
      report.result.indistinguishable = {{"tube_friction", "wear"}};
    }
    // The structure is √0.0009 of 0.1 N.
    report.result.structure = {{"strand", 3.21, 0.004, 0.0009}, {"load", 1, 0.2, 0}};
    report.result.residual_before_N = 3.1;
    report.result.residual_after_N = 0.1;
    report.result.cells.front().cell.measured_N = 20;
    report.result.structure_p_value = 0.011;
    EXPECT_TRUE(says(report, weak)) << diagnosis_answer(report);
    EXPECT_FALSE(says(report, nothing));
    EXPECT_FALSE(says(report, "as well as their noise allows"));
    report.result.structure_p_value = 0.021;
    EXPECT_FALSE(says(report, "Weak structure"));
    EXPECT_EQ(says(report, nothing), verdict != Verdict::indistinguishable);
  }
}

TEST(DiagnosisAnswer, AsksForTheUnitsRightBelowTheHeadline) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes = {tubes()};
  report.result.notes = {{NoteKind::covariate, "a column", {}},
                         {NoteKind::units, "the median of T1_N is 4e+03 N: newton?", {}}};
  const auto second_line = [&] {
    const std::string answer = diagnosis_answer(report);
    const std::size_t begin = answer.find('\n') + 1;
    return answer.substr(begin, answer.find('\n', begin) - begin);
  };
  EXPECT_EQ(second_line(), "Check the units first: the median of T1_N is 4e+03 N: newton?");
  report.result.notes.push_back({NoteKind::units, "of T2_N too", {}});
  report.result.notes.push_back({NoteKind::units, "of T3_N too", {}});
  EXPECT_EQ(
      second_line(),
      "Check the units first: the median of T1_N is 4e+03 N: newton? 2 more notes of the kind "
      "below.");
  report.result.notes = {{NoteKind::not_as_pulled, "in 3 rows", {3, 5, 8}}};
  EXPECT_EQ(second_line(), "Check this first: in 3 rows");
  report.result.notes = {{NoteKind::outlier_groups, "T4 in runs a and b", {3}},
                         {NoteKind::other_direction, "8 of 16 rows of run a", {3, 5, 8}}};
  EXPECT_EQ(second_line(), "Check this first: 8 of 16 rows of run a");
  report.result.notes.pop_back();
  EXPECT_EQ(second_line(), "Check this first: T4 in runs a and b");
  report.result.notes.clear();
  EXPECT_FALSE(says(report, "first"));
}

// On a bench the groups of a grasp differ in the direction alone.
TEST(DiagnosisAnswer, SpeaksOfNoGraspOnABench) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  for (const auto& [about, on_a_bench] :
       {std::pair("grasp", "direction"),
        std::pair("routing, grasp and strand", "routing, direction and strand"),
        std::pair("load", "load")}) {
    for (const char* word : {"M-1-T-2-F", "M-F", "M-1-F"}) {
      const Routing routing = parse_routing(word);
      report.data.routings = {{word, routing, expand(routing), {}}};
      report.result.unexplained = Unexplained{about, "T1", 0.001};
      const bool is_hand = finger_count(routing) > 1;
      EXPECT_TRUE(says(report, std::string("explains: ") + (is_hand ? about : on_a_bench) + ", "))
          << word;
    }
  }
}

// A thousandth of readings of 20 N hardly shows, and a hundredth does.
TEST(DiagnosisAnswer, SaysHowMuchEachCauseExplainsAndWhetherItMatters) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes = {tubes(), other_sensor()};
  report.result.cells.front().cell.measured_N = 20;
  report.result.residual_before_N = 3.1;
  report.result.causes[0].explained = {3.1, 0.99};
  report.result.causes[1].explained = {0.03, 0.0001};
  EXPECT_TRUE(says(report,
                   "literature 0.05 to 0.2). It explains 3.1 N rms of 3.1 N (99 % of the mean "
                   "square).\nBesides, one "));
  EXPECT_TRUE(
      says(report, "It explains 0.03 N rms of 3.1 N (0.01 % of the mean square, negligible).\n"));
  report.result.causes[1].explained.rms_N = 0.2;
  EXPECT_TRUE(says(report, "It explains 0.2 N rms of 3.1 N (0.01 % of the mean square).\n"));
}

TEST(DiagnosisAnswer, HasAtMostSixLinesAndKeepsTheRest) {
  DiagnosisReport report = report_of(Verdict::cause);
  report.result.causes.assign(5, tubes());
  EXPECT_TRUE(says(report, "2 further causes explain less: see the table.\n"));
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines(diagnosis_answer(report)), 6);
  EXPECT_EQ(further_answer(report), "");
  const Effect effect{&causes::law(causes::Term{}), {}, {0.1}};
  report.result.leads = {{effect, 12.3, std::nullopt}};
  EXPECT_EQ(lines(diagnosis_answer(report)), 6);
  EXPECT_EQ(further_answer(report),
            "Strongest lead, not confirmed: exponent of tube (12.3 nats).\n");
}

TEST(DiagnosisAnswer, OfRunsApartSaysHowFarTheyAreOff) {
  DiagnosisReport report = report_of(Verdict::unexplained);
  causes::Term term;
  term.site.runs = {"m2", "m5"};
  const Effect effect{&causes::law(term), {}, {0.1}};
  report.result.apart = {{{"m2", "m5"}, effect, 30, effect.cause->meaning()}};
  report.result.unexplained = Unexplained{"run", effect.cause->meaning(), 0.001};
  EXPECT_TRUE(says(report, "most of all exponent of tube in runs m2, m5 (phi' = phi (1 + 0.1); p"));
}

}  // namespace
}  // namespace reeve
