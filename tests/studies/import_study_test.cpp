#include "studies/import_study.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

// One run of a log that says neither routing nor grasp.
std::string import_error(const std::optional<std::string>& routing) {
  LoggedSeries series;
  series.labels.resize(1);
  series.label = {0};
  series.lines = {2};
  ImportLabels given;
  given.routing = routing;
  return testing::input_error([&] {
    import_study(series, given, {}, [](const std::string& word) { return parse_routing(word); });
  });
}

TEST(ImportStudy, NeedsARoutingFromTheLogOrGiven) {
  EXPECT_NE(import_error({}).find("a routing such as M-1-T-2-F, in a column of the log or given"),
            std::string::npos)
      << import_error({});
}

TEST(ImportStudy, NeedsARoutingThatAMotorPulls) {
  EXPECT_NE(import_error("F-1-F").find("F-1-F"), std::string::npos) << import_error("F-1-F");
}

std::vector<DataNote> import_notes(const std::string& routing,
                                   const std::optional<std::string>& held) {
  std::string log = "time_s,motor_tension_N,T1_N\n";
  for (int i = 0; i < 40; ++i) log += std::to_string(0.1 * i) + ",20,4\n";
  ImportLabels given;
  given.routing = routing;
  given.held = held;
  return import_study(parse_logged_series(log, "log.csv"), given, {},
                      [](const std::string& word) { return parse_routing(word); })
      .series.notes;
}

TEST(ImportStudy, NotesThatNoHeldFingerIsGiven) {
  const auto notes = import_notes("M-1-P-2-M", {});
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].text,
            "the held finger is not given in 40 of 40 samples: none is assumed to be held");
  EXPECT_TRUE(import_notes("M-1-P-2-M", "none").empty());
  EXPECT_TRUE(import_notes("M-1-F", {}).empty());
}

TEST(ImportStudy, NotesThatAllTensionsAreBelowZero) {
  std::string log = "time_s,motor_tension_N,T1_N\n";
  for (int i = 0; i < 40; ++i) log += std::to_string(0.1 * i) + ",-20,-4\n";
  ImportLabels given;
  given.routing = "M-1-F";
  const auto report = import_study(parse_logged_series(log, "log.csv"), given, {},
                                   [](const std::string& word) { return parse_routing(word); });
  std::string text;
  for (const DataNote& note : report.steady.notes) {
    if (note.kind == NoteKind::inverted) text = note.text;
  }
  EXPECT_TRUE(text.starts_with("all tensions are below zero")) << text;
}

}  // namespace
}  // namespace reeve
