#include "readings/row_order.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/diagnose.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/planting_dirt.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

TEST(NaturalLess, ReadsDigitsAsNumbers) {
  const std::vector<std::string> sorted{"",    "1",  "2",   "02x",  "10",     "a",      "a1b",
                                        "a1c", "a2", "a10", "a10b", "b 7 x2", "b 7 x10"};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      EXPECT_EQ(natural_less(sorted[i], sorted[j]), i < j) << sorted[i] << ", " << sorted[j];
    }
  }
  EXPECT_TRUE(natural_less("99999999999999999999999", "100000000000000000000000"));
}

// Other runs, in one order or the other.
TEST(NaturalLess, TellsNamesApartThatReadAlike) {
  EXPECT_TRUE(natural_less("07", "7"));
  EXPECT_FALSE(natural_less("7", "07"));
  EXPECT_TRUE(natural_less("a", "µ1"));
  EXPECT_FALSE(natural_less("µ1", "a"));
}

const std::string ordered_header = "run,routing,held,motor_tension_N,winch,T1_N,T2_N,T3_N\n";

std::vector<std::size_t> lines_of(const MeasuredData& data) {
  std::vector<std::size_t> lines;
  for (const Reading& reading : data.readings) lines.push_back(reading.line);
  return lines;
}

TEST(RunNumbers, AreThoseOfTheNamesWhereNothingElseDiffers) {
  EXPECT_EQ(run_numbers({"m3", "m12", "m013"}), (std::vector<double>{3, 12, 13}));
  EXPECT_EQ(run_numbers({"101", "102"}), (std::vector<double>{101, 102}));
  EXPECT_EQ(run_numbers({"2 kg", "10 kg"}), (std::vector<double>{2, 10}));
  EXPECT_EQ(run_numbers({"0", "3", "-2"}), (std::vector<double>{0, 3, -2}));
  EXPECT_EQ(run_numbers({"run-1", "run-2"}), (std::vector<double>{1, 2}));
}

TEST(RunNumbers, CountElsewhere) {
  const std::vector<double> counted{1, 2};
  EXPECT_EQ(run_numbers({"day1_3", "day2_1"}), counted);
  EXPECT_EQ(run_numbers({"m3", "new"}), counted);
  EXPECT_EQ(run_numbers({"new", "m3"}), counted);
  EXPECT_EQ(run_numbers({"1000000000000000", "1000000000000001"}), counted);
  EXPECT_EQ(run_numbers({"1.05", "1.1"}), counted);
  EXPECT_TRUE(run_numbers({}).empty());
}

TEST(InOrderOfContents, IsByRunThenByWhatRowsSay) {
  ReadingOptions options;
  options.group = "winch";
  const MeasuredData data = in_order_of_contents(read_data(ordered_header + "10,TR3,1,30,b,3,1,\n"
                                                                            "2,TR5,1,20,a,2,1,\n"
                                                                            "2,TR5,,20,a,2,1,\n"
                                                                            "10,TR3,1,10,b,1,1,\n"
                                                                            "2,TR3,1,20,a,2,1,\n"
                                                                            "10,TR3,1,10,b,1,,1\n",
                                                           options));
  EXPECT_EQ(lines_of(data), (std::vector<std::size_t>{6, 4, 3, 7, 5, 2}));
  EXPECT_EQ(data.runs, (std::vector<std::string>{"2", "10"}));
  EXPECT_EQ(data.groups, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(data.routings.size(), 2U);
  EXPECT_EQ(data.routings[0].word, "F-1-P-2-F");
  const std::vector<std::size_t> runs{0, 0, 0, 1, 1, 1};
  const std::vector<std::size_t> routings{0, 1, 1, 0, 0, 0};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(data.readings[i].run, runs[i]) << i;
    EXPECT_EQ(data.readings[i].group, runs[i]) << i;
    EXPECT_EQ(data.readings[i].routing, routings[i]) << i;
  }
}

TEST(InOrderOfContents, TakesNoiseAndSegmentsWithTheirChannels) {
  ReadingOptions options;
  options.noise = {{"Ta", {0.1, 0}}};
  const MeasuredData data = in_order_of_contents(
      read_data("run,routing,motor_tension_N,Ta_N,T2_N,T1_N\n1,TR5,20,9,2,1\n", options));
  ASSERT_EQ(data.channels.size(), 3U);
  EXPECT_EQ(data.channels[0].name, "T1");
  EXPECT_EQ(data.channels[1].name, "T2");
  EXPECT_EQ(data.channels[2].name, "a");
  EXPECT_EQ(data.readings[0].tension_N, (std::vector<std::optional<double>>{1, 2, 9}));
  EXPECT_FALSE(data.known_noise[0]);
  EXPECT_FALSE(data.known_noise[1]);
  EXPECT_TRUE(data.known_noise[2]);
  const MeasuredRouting& routing = data.routings[0];
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(routing.network.segments[*routing.segments[c]], data.channels[c].segment);
  }
}

TEST(InOrderOfContents, MakesRunsHeldOutAndNoiseThatIsDrawnTheSame) {
  SKIP_UNDER_SANITIZERS();
  PlantingPlan plan;
  plan.effects = {EffectKind::sensor_gain};
  plan.runs = 8;
  const std::string csv = plant(plan, 81).csv;
  DiagnoseOptions options;
  options.replicates = 100;
  const auto of = [&](const std::string& text) { return in_order_of_contents(read_data(text)); };
  const auto held_out = [&](const MeasuredData& data) {
    std::vector<std::string> runs;
    for (const std::size_t run : split_by_run(data, 0.3, 3).held_out_runs) {
      runs.push_back(data.runs[run]);
    }
    return runs;
  };
  const MeasuredData as_written = of(csv);
  const DiagnosisResult first = diagnose(as_written, Hardware{}, options);
  ASSERT_EQ(first.verdict, Verdict::cause);
  const MeasuredData shuffled = of(dirtied(csv, Dirt::unsorted, 1));
  EXPECT_EQ(held_out(shuffled), held_out(as_written));
  const DiagnosisResult result = diagnose(shuffled, Hardware{}, options);
  EXPECT_EQ(result.verdict, first.verdict);
  ASSERT_EQ(result.causes.size(), first.causes.size());
  for (std::size_t c = 0; c < result.causes.size(); ++c) {
    EXPECT_EQ(result.causes[c].name, first.causes[c].name);
  }
}

std::vector<std::size_t> places_taken(const std::string& rows,
                                      const std::string& clock = "time_s") {
  const MeasuredData data = read_data("run,routing,motor_tension_N,T1_N," + clock + "\n" + rows);
  std::vector<std::size_t> places;
  for (const Reading& reading : data.readings) places.push_back(reading.taken);
  return places;
}

using Places = std::vector<std::size_t>;

TEST(TakenOrder, IsThatOfTheFileWithoutAClock) {
  EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,8\n2,TR3,12,1,7\n", "humidity"),
            (Places{0, 1, 2}));
}

TEST(TakenOrder, IsThatOfTheClock) {
  for (const char* clock : {"time_s", "Time [s]", "Time (ms)"}) {
    EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,8\n2,TR3,12,1,7\n", clock), (Places{2, 1, 0}))
        << clock;
  }
}

// Rows without a time would stand anywhere.
TEST(TakenOrder, IsThatOfTheFileWhereTheClockHasGaps) {
  EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,\n2,TR3,12,1,7\n"), (Places{0, 1, 2}));
}

TEST(TakenOrder, HasRunsAsInTheFileWhereTheClockBeginsAgain) {
  EXPECT_EQ(places_taken("b,TR3,10,1,5\na,TR3,11,1,4\nb,TR3,12,1,2\na,TR3,13,1,1\n"),
            (Places{1, 3, 0, 2}));
}

TEST(TakenOrder, PutsADriftAlongTheClock) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,time_s\n1,TR3,10,1,30\n1,TR3,11,1,10\n1,TR3,12,1,20\n");
  const Dataset dataset = all_of(data);
  EXPECT_EQ(dataset.rows[0].conditions.order, 1);
  EXPECT_EQ(dataset.rows[1].conditions.order, 0);
  EXPECT_EQ(dataset.rows[2].conditions.order, 0.5);
}

}  // namespace
}  // namespace reeve::testing
