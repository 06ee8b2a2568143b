#include "readings/recognise_series.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "numerics/random.hpp"
#include "tests/readings/read_data.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

struct Rows {
  std::size_t count = 6000;
  double correlation = 0.9;
  double noise = 0.01;
  std::string clock = {};  // its column; none: ""
  double step_s = 0.01;
  double jitter = 0;                                           // of the step
  double (*load)(double share) = [](double) { return 20.0; };  // N
  double (*part)(double share) = [](double) { return 0.3; };   // of the load, in T1
};

std::string rows(const Rows& plan) {
  const std::vector<double> first = correlated_noise(plan.count, plan.correlation, 9, 0);
  const std::vector<double> second = correlated_noise(plan.count, plan.correlation, 9, 1);
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N";
  text += (plan.clock.empty() ? "" : "," + plan.clock) + "\n";
  for (std::size_t i = 0; i < plan.count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(plan.count);
    const double load_N = plan.load(share);
    const double part = plan.part(share);
    text += fmt::format("A,TR5,{:.4f},{:.4f},{:.4f}", load_N,
                        part * load_N * (1 + plan.noise * first[i]),
                        0.5 * part * load_N * (1 + plan.noise * second[i]));
    const double late = plan.jitter * (uniform(4, 0, i) - 0.5);
    if (!plan.clock.empty()) {
      text += fmt::format(",{:.4f}", plan.step_s * (static_cast<double>(i) + late));
    }
    text += "\n";
  }
  return text;
}

bool is_series(const Rows& plan) { return recognise_series(read_data(rows(plan))).has_value(); }

TEST(RecogniseSeries, KnowsALogByItsClock) {
  EXPECT_TRUE(is_series({.clock = "time_s"}));
  EXPECT_TRUE(is_series({.correlation = 0, .clock = "time_ms", .step_s = 10}));
  EXPECT_TRUE(is_series({.correlation = 0, .clock = "Time (ms)", .step_s = 10}));
  EXPECT_TRUE(is_series({.count = 600, .clock = "t", .step_s = 1}));
  EXPECT_TRUE(is_series({.count = 150, .clock = "timestamp", .jitter = 0.9}));
}

TEST(RecogniseSeries, KnowsALogWithoutAClockByItsNoise) {
  EXPECT_TRUE(is_series({}));
  EXPECT_TRUE(is_series({.load = [](double share) { return 20 + 10 * std::sin(100 * share); }}));
}

TEST(RecogniseSeries, IsTheFirstNoteAndSaysWhatToDo) {
  const MeasuredData data = read_data(rows({.clock = "time_s"}));
  ASSERT_FALSE(data.notes.empty());
  EXPECT_EQ(data.notes[0].kind, NoteKind::time_series);
  EXPECT_EQ(data.notes[0].text,
            "6000 rows with a clock (column 'time_s', every 0.01 s) are a logger's time series, "
            "whose neighbouring rows are no readings of their own: make readings of it (reeve "
            "import)");
}

TEST(RecogniseSeries, TakesReadingsForReadingsHoweverManyThereAre) {
  EXPECT_FALSE(is_series({.correlation = 0}));
  // In the order of their load, of which the shares depend.
  EXPECT_FALSE(is_series({.correlation = 0,
                          .load = [](double share) { return 5 + 50 * share; },
                          .part = [](double share) { return 0.2 + 0.2 * share; }}));
  // By hand, a minute each, and not for hours.
  EXPECT_FALSE(is_series({.count = 90, .correlation = 0, .clock = "time_s", .step_s = 60}));
  EXPECT_FALSE(
      is_series({.count = 400, .correlation = 0, .clock = "time_s", .step_s = 60, .jitter = 0.9}));
  EXPECT_FALSE(is_series({.count = 500}));
  // By a machine, every 40 s, with loads in a random order.
  EXPECT_FALSE(is_series(
      {.count = 400, .correlation = 0, .clock = "time_s", .step_s = 40, .load = [](double share) {
         return 20 + 10 * std::sin(1e5 * share);
       }}));
}

// Five readings of each sweep, evenly, and then a rest: what an import writes.
TEST(RecogniseSeries, TakesImportedReadingsForReadings) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N,readings,T1_sd_N,time_s\n";
  for (int i = 0; i < 1500; ++i) {
    text += fmt::format("A,TR5,{},{},{},30,0.1,{}\n", 10 + 5 * (i % 5), 3 + 1.5 * (i % 5), 2,
                        0.8 * i + 4 * (i / 5));
  }
  EXPECT_FALSE(recognise_series(read_data(text)));
}

TEST(RecogniseSeries, TakesEveryFileOfReadingsHereForReadings) {
  const Catalogue catalogue = read_catalogue(CatalogueFiles::shipped());
  const auto resolve = [&](const std::string& text) {
    const Routing* named = catalogue.find_routing(text);
    return named != nullptr ? *named : parse_routing(text);
  };
  int files = 0;
  const std::filesystem::path root = REEVE_SOURCE_DIR;
  for (const std::filesystem::path& folder :
       {root / "tests" / "golden", root / "catalog" / "measured"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".csv" || entry.path().filename() == "log.csv") continue;
      EXPECT_FALSE(recognise_series(read_measured_data(entry.path(), resolve))) << entry.path();
      ++files;
    }
  }
  EXPECT_GE(files, 8);
}

TEST(RecogniseSeries, SaysOfARawLogThatItIsOne) {
  EXPECT_EQ(data_error("time_s,motor_tension_N,T1_N\n0,20,6\n"),
            "d.csv:1: the header has a clock ('time_s'), and neither 'run' nor 'routing': expected "
            "steady readings; of a logger's time series, reeve import makes them");
  EXPECT_EQ(data_error("time_s,routing,T1_N\n0,TR5,6\n"),
            "d.csv:1: the header has no column 'run': expected a name or number for each run");
}

}  // namespace
}  // namespace reeve::testing
