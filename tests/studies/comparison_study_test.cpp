#include "studies/comparison_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "causes/term.hpp"
#include "core/notation.hpp"

namespace reeve {
namespace {

MeasuredData of_humidities(const std::string& rows) {
  return parse_measured_data("run,routing,motor_tension_N,humidity_pct,Th1_N\n" + rows, "d.csv",
                             [](const std::string& word) { return parse_routing(word); });
}

Model with_humid_sheath() {
  Term term;
  term.site.kind = ContactKind::sheath;
  term.form = Form::linear;
  term.x = covariate_named("humidity_pct");
  term.x.middle = 50;
  term.x.seen = {20, 80};
  Model model;
  add_effect(model, {&law(term), {}, {0.01}});
  return model;
}

std::vector<DataNote> notes_of_laws(const CompareReport& report) {
  std::vector<DataNote> notes = report.comparison.notes;
  std::erase_if(notes, [](const DataNote& note) { return note.kind != NoteKind::outside_law; });
  return notes;
}

TEST(ComparisonUnderALaw, ForecastsWhatTheLawSaysAtEachReadingsColumn) {
  const CompareReport report = comparison_study(
      of_humidities("A,M-F,10,40,3\nA,M-F,20,70,5\nA,M-F,30,,9\n"), with_humid_sheath(), {});
  const double phi = 0.36 * std::acos(-1);
  ASSERT_EQ(report.comparison.values.size(), 3U);
  EXPECT_NEAR(report.comparison.values[0].predicted, 10 * std::exp(-0.9 * phi), 1e-9);
  EXPECT_NEAR(report.comparison.values[1].predicted, 20 * std::exp(-1.2 * phi), 1e-9);
  EXPECT_NEAR(report.comparison.values[2].predicted, 30 * std::exp(-phi), 1e-9);
  EXPECT_TRUE(notes_of_laws(report).empty());
}

TEST(ComparisonUnderALaw, NotesReadingsOutsideTheRangeInWhichItWasSeen) {
  const CompareReport report = comparison_study(
      of_humidities("A,M-F,10,40,3\nA,M-F,20,90,5\nA,M-F,30,10,9\n"), with_humid_sheath(), {});
  const double phi = 0.36 * std::acos(-1);
  EXPECT_NEAR(report.comparison.values[1].predicted, 20 * std::exp(-1.3 * phi), 1e-9);
  ASSERT_EQ(notes_of_laws(report).size(), 1U);
  const DataNote note = notes_of_laws(report)[0];
  EXPECT_EQ(
      note.text,
      "humidity_pct lies outside 20 to 80, where law[exponent of sheath, humidity_pct, linear] "
      "was seen, in 2 of 3 readings: the law is held constant there");
  EXPECT_EQ(note.lines, (std::vector<std::size_t>{3, 4}));
}

}  // namespace
}  // namespace reeve
