// The cells of a diagnosis' tables, of results made by hand.
#include <gtest/gtest.h>

#include "causes/term.hpp"
#include "pages/diagnosis/diagnosis_marks.hpp"
#include "pages/diagnosis/diagnosis_values.hpp"
#include "tests/pages/diagnosed.hpp"

namespace reeve::testing {
namespace {

using namespace reeve::pages;

// The cells of each row, with | between them.
std::vector<std::string> rows_of(const std::string& html) {
  std::vector<std::string> rows;
  bool is_text = true;
  for (std::size_t at = html.find("<tbody>"); at < html.find("</tbody>"); ++at) {
    if (html.substr(at, 3) == "<tr") rows.emplace_back();
    if (html.substr(at, 4) == "</td" || html.substr(at, 4) == "</th") rows.back() += '|';
    if (html[at] == '<') is_text = false;
    if (is_text && html[at] != '\n') rows.back() += html[at];
    if (html[at] == '>') is_text = true;
  }
  return rows;
}

using Rows = std::vector<std::string>;

NamedCause named(const std::string& name, const HeldOut& held_out) {
  NamedCause cause;
  cause.name = name;
  cause.held_out = held_out;
  return cause;
}

TEST(GainsTable, HasARowForAllTogetherWhereThereAreSeveral) {
  DiagnosisResult result;
  result.held_out = gained;
  result.causes = {named("tube_friction", gained)};
  EXPECT_EQ(rows_of(gains_table(result)).size(), 1U);
  result.causes.push_back(named("wear", gained));
  const Rows rows = rows_of(gains_table(result));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2], "all together|1 N|0.1 N|90 %|80 % to 95 %|49.0|40.0 to 60.0|48.0|");
}

TEST(WeighedTable, HasTheErrorAfterAModelOnTheHeldOutRuns) {
  DiagnosisResult result;
  result.weighed = {{{"wear"}, 20, gained}, {{"drift"}, 30, std::nullopt}};
  EXPECT_EQ(rows_of(weighed_table(result)),
            (Rows{"drift|weighed|30.0|–|–|–|", "wear|weighed|20.0|49.0|40.0 to 60.0|0.1 N|"}));
}

TEST(CalibrationTable, SaysWhereTheSearchEnded) {
  DiagnosisResult result;
  CalibratedCoefficient& tube = result.calibration.emplace_back();
  tube.name = "tube_friction";
  tube.parameter = {"mu", "1", 0.1, 0.05, 0.15, 0.18, std::nullopt, true};
  EXPECT_NE(calibration_table(result).find(", at the limit of the search"), std::string::npos);
  tube.parameter.at_bound = false;
  EXPECT_EQ(calibration_table(result).find(", at the limit of the search"), std::string::npos);
}

TEST(ExpectedTable, HasAColumnForEachOfTwoCausesThatAreToBeSeparated) {
  DiagnosisResult result;
  result.next_measurement.emplace().expected = {{"T1", 5, 6, 0.1}};
  EXPECT_EQ(rows_of(expected_table(result)), Rows{"T1|5|0.1|"});
  result.next_measurement->between = {"wear", "drift"};
  EXPECT_EQ(rows_of(expected_table(result)), Rows{"T1|5|6|0.1|"});
}

TEST(RankingTable, SaysWhereARoutingWas) {
  EXPECT_EQ(rows_of(ranking_table({{"TR1", "TR2", "TR3"}, {"TR2", "TR1", "TR3"}})),
            (Rows{"1|TR1|TR2 (was 2)|", "2|TR2|TR1 (was 1)|", "3|TR3|TR3|"}));
}

TEST(NotesTable, NamesTwelveLinesAtMost) {
  DiagnosisResult result;
  DataNote& note = result.notes.emplace_back(DataNote{NoteKind::not_compared, "why", {}});
  EXPECT_EQ(rows_of(notes_table(result)), Rows{"not compared|why|–|the whole file|"});
  for (std::size_t line = 1; line <= 12; ++line) note.lines.push_back(line);
  const std::string twelve = "1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12";
  EXPECT_EQ(rows_of(notes_table(result)), Rows{"not compared|why|12|" + twelve + "|"});
  note.lines.push_back(13);
  EXPECT_EQ(rows_of(notes_table(result)), Rows{"not compared|why|13|" + twelve + ", …|"});
}

TEST(FrictionTable, HasBlocksWhereTheyHaveALawOfTheirOwn) {
  Hardware hardware;
  EXPECT_EQ(rows_of(friction_table(hardware)).size(), 3U);
  hardware.block = ContactLaw{0.25, 3};
  EXPECT_EQ(rows_of(friction_table(hardware))[2], "floating block|0.25|3|");
}

TEST(CauseValues, SayThatARunnerUpExplainsAsWellWhereItDoesToOneDecimal) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  for (const auto& [less, as_well] : {std::pair{0.04, true}, {0.06, false}}) {
    report.result.causes[0].runner_up = RunnerUp{"wear", less};
    EXPECT_EQ(cause_values(report)["named"][0]["runner_up"]["as_well"], as_well);
  }
}

TEST(CauseValues, SayALawInWordsAndAsAFormula) {
  DiagnosisReport report = plain_report();
  name_tube_friction(report);
  Term term;
  term.site.kind = ContactKind::sheath;
  term.form = Form::linear;
  term.x = covariate_named("humidity_pct");
  term.x.middle = 50;
  term.x.seen = {20, 80};
  NamedCause& cause = report.result.causes[0];
  cause.effect = {&law(term), {}, {0.0083}};
  cause.name = effect_name(cause.effect);
  cause.parameters = {{"a", "1", 0.0083, 0.0079, 0.0087, 0, {}, false}};
  const Json named = cause_values(report)["named"][0];
  EXPECT_EQ(named["meaning"], "Sheath friction grows with humidity_pct");
  EXPECT_EQ(named["detail"], "phi' = phi (1 + 0.0083 (humidity_pct - 50))");
  const std::string page = diagnosis_html(report);
  EXPECT_TRUE(contains(page, "95 % interval of a 0.0079 to 0.0087"));
  EXPECT_TRUE(contains(page, "1/humidity_pct"));
}

// Beyond nine columns of the user's own that vary.
TEST(MarkColumns, DrawNineUnknownColumnsAtMost) {
  DiagnosisReport report = plain_report();
  const std::size_t known = mark_columns(report).shown.size();
  for (std::size_t columns : {9U, 10U}) {
    report.data.covariates.assign(columns, "x");
    for (Reading& reading : report.data.readings) {
      reading.covariates.assign(columns, static_cast<double>(reading.line));
    }
    EXPECT_EQ(mark_columns(report).shown.size(), known + 9);
    EXPECT_EQ(mark_columns(report).not_drawn, columns - 9);
  }
}

TEST(NextMeasurement, HasAColumnForEachConditionThatIsUsed) {
  DiagnosisReport report = plain_report();
  Measurement& at = report.result.next_measurement.emplace().measurement;
  at.routing.word = "M-1-T-2-F";
  at.conditions = {20, 5, 7, 30};
  const auto rows = [&] { return next_values(report)["rows"].get<std::string>(); };
  EXPECT_EQ(rows(), "run,routing,held,direction,motor_tension_N\nNEW,M-1-T-2-F,,pull,20\n");
  at.uses_speed = at.uses_cycle = at.uses_temperature = true;
  EXPECT_EQ(rows(),
            "run,routing,held,direction,motor_tension_N,speed_mm_s,cycle,temperature_C\n"
            "NEW,M-1-T-2-F,,pull,20,5,7,30\n");
}

}  // namespace
}  // namespace reeve::testing
