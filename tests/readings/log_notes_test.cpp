// What is said of a log that contradicts itself, or has less than it seems.
#include "readings/log/log_notes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "readings/inverted.hpp"
#include "tests/readings/read_data.hpp"
#include "tests/readings/rig_readings.hpp"

namespace reeve::testing {
namespace {

void invert(LoggedSignal& signal) {
  for (double& tension : signal.values) tension = -tension;
}

std::string text_of(const std::optional<DataNote>& note) { return note ? note->text : ""; }

// Else a log of which nothing can be read would have no word on why.
TEST(InvertedSignals, AreNamedThoughNoReadingIsMadeOfThem) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  EXPECT_FALSE(inverted_signals(series));
  invert(series.motor_tension_N);
  const SteadyReadings found = steady_readings(series, {});
  EXPECT_TRUE(found.readings.empty());
  EXPECT_EQ(note_text(found.notes, NoteKind::inverted),
            "motor_tension_N reads below zero, the more so the more is pulled, which no tendon "
            "does: exchange the sign in the file if the sensor is mounted or wired the other way "
            "round");
}

TEST(InvertedSignals, MayBeOneTensionOrAll) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  invert(series.tensions_N[2]);
  EXPECT_EQ(text_of(inverted_signals(series)).substr(0, 15), "T3_N reads belo");
  invert(series.tensions_N[2]);
  for (LoggedSignal& tension : series.tensions_N) invert(tension);
  invert(series.motor_tension_N);
  EXPECT_EQ(text_of(inverted_signals(series)).substr(0, 46),
            "motor_tension_N, T1_N, T2_N, T3_N, T4_N read b");
}

TEST(InvertedSignals, AreNoSlackStrandWhoseZeroHasDrifted) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  series.tensions_N[2].values = correlated_noise(series.size(), 0.5, 3, 9);
  for (double& tension : series.tensions_N[2].values) tension = 0.02 * tension - 0.3;
  EXPECT_FALSE(inverted_signals(series));
}

// The runs and directions that a log's labels say, by sample.
std::vector<DataNote> notes_where_said(
    const std::function<std::string(const RigSample&)>& direction) {
  const std::vector<RigSample> samples = rig_log({}, one_run);
  LoggedSeries series = series_of(samples);
  series.labels = {{"1", "", "", "pull"}, {"1", "", "", "release"}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    series.label[i] = direction(samples[i]) == "pull" ? 0 : 1;
  }
  return steady_readings(series, {}).notes;
}

TEST(SaidDirections, AreNotedWhereOneIsSaidOfBothMotions) {
  const auto notes = notes_where_said([](const RigSample&) { return "pull"; });
  EXPECT_EQ(note_text(notes, NoteKind::against_motion).substr(0, 62),
            "the column 'direction' says one direction while the carriage m");
  EXPECT_EQ(noted_lines(notes, NoteKind::against_motion).size(), 4U);  // four strokes back
}

TEST(SaidDirections, MayAgreeWithTheMotionOrBeItsOppositeThroughout) {
  const auto right = [](const RigSample& sample) {
    return sample.speed_mm_s >= 0 ? "pull" : "release";
  };
  EXPECT_EQ(count_notes(notes_where_said(right), NoteKind::against_motion), 0U);
  const auto otherwise = [](const RigSample& sample) {
    return sample.speed_mm_s >= 0 ? "release" : "pull";
  };
  EXPECT_EQ(count_notes(notes_where_said(otherwise), NoteKind::against_motion), 0U);
}

TEST(SaidDirections, AreThoseOfOneRun) {
  SaidDirections said;
  said.add("A", Direction::pull, Direction::pull, 2);
  said.add("B", Direction::pull, Direction::release, 3);
  said.add("B", Direction::pull, std::nullopt, 4);
  EXPECT_FALSE(said.note());
  said.add("B", Direction::pull, Direction::pull, 5);
  const std::optional<DataNote> note = said.note();
  ASSERT_TRUE(note);
  EXPECT_EQ(note->lines, std::vector<std::size_t>{3});
}

TEST(SparseChannels, AreNamedWithTheShareThatIsMissing) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (i % 4 != 0) {
      series.motor_tension_N.values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  const SteadyReadings found = steady_readings(series, {});
  ASSERT_FALSE(found.readings.empty());
  EXPECT_FALSE(found.readings[0].motor_tension_N);
  EXPECT_EQ(count_notes(found.notes, NoteKind::sparse), 1U);
  EXPECT_EQ(note_text(found.notes, NoteKind::sparse),
            fmt::format("motor_tension_N is missing in 75 % of the samples of {} of the readings, "
                        "which therefore do not have it: of a sensor that is logged more seldom "
                        "than the others keep the rows that have it",
                        found.readings.size()));
  EXPECT_EQ(noted_lines(found.notes, NoteKind::sparse).size(), found.readings.size());
}

// Rows of another routing need not have it.
TEST(SparseChannels, AreNoneThatAreOff) {
  LoggedSeries series = series_of(rig_log({}, one_run));
  std::fill(series.tensions_N[2].values.begin(), series.tensions_N[2].values.end(),
            std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(steady_readings(series, {}).notes.empty());
}

}  // namespace
}  // namespace reeve::testing
