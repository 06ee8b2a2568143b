#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "diagnosis/chosen_readings.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

// Three runs on TR3, three on TR5, one on TR1, four rows each.
std::string seven_runs() {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  int value = 100;
  for (const char* run : {"a TR3", "b TR3", "c TR3", "d TR5", "e TR5", "f TR5", "g M-1-T-2-F"}) {
    const std::string name(run, 1);
    for (int row = 0; row < 4; ++row) {
      text += name + "," + std::string(run + 2) + ",10," + std::to_string(value++) + "e-2\n";
    }
  }
  return text;
}

TEST(SplitByRun, NeverTearsARunApart) {
  const MeasuredData data = read_data(seven_runs());
  const RunSplit split = split_by_run(data, 0.3, 1);
  std::set<std::size_t> training, held_out;
  for (const std::size_t i : split.training) training.insert(data.readings[i].run);
  for (const std::size_t i : split.held_out) held_out.insert(data.readings[i].run);
  for (const std::size_t run : held_out) EXPECT_EQ(training.count(run), 0U);
  EXPECT_EQ(split.training.size() + split.held_out.size(), data.readings.size());
  EXPECT_EQ(held_out.size(), 2U);
}

TEST(SplitByRun, KeepsARunOfEveryRoutingInTraining) {
  const MeasuredData data = read_data(seven_runs());
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RunSplit split = split_by_run(data, 0.5, seed);
    std::set<std::size_t> routings;
    for (const std::size_t i : split.training) routings.insert(data.readings[i].routing);
    EXPECT_EQ(routings.size(), 3U) << seed;
  }
}

TEST(SplitByRun, IsDrawnByTheSeed) {
  const MeasuredData data = read_data(seven_runs());
  EXPECT_EQ(split_by_run(data, 0.3, 5).held_out, split_by_run(data, 0.3, 5).held_out);
  std::set<std::vector<std::size_t>> drawn;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    drawn.insert(split_by_run(data, 0.3, seed).held_out_runs);
  }
  EXPECT_GT(drawn.size(), 3U);
}

// As where every routing was mounted once: no routing is held out oftener than others.
TEST(SplitByRun, DrawsAmongRoutingsThatHaveOneRunEach) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N\n1,TR3,10,1\n2,TR5,10,2\n3,M-1-F,10,3\n"
      "4,M-1-T-2-F,10,4\n5,M-1-T-2-M,10,5\n");
  std::vector<int> held(5);
  constexpr int seeds = 300;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    for (const std::size_t run : split_by_run(data, 0.2, seed).held_out_runs) ++held[run];
  }
  for (const int count : held) EXPECT_NEAR(count, seeds / 5, 4 * std::sqrt(seeds * 0.2 * 0.8));
}

TEST(SplitByRun, DropsRepeatedRowsOfAnyRun) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,T2_N\n1,TR3,10,1.0013,2.1178\n1,TR3,10,1.0013,2.1178\n"
      "2,TR3,10,1.0013,2.1178\n2,TR3,10,1.0013,2.1242\n");
  const RunSplit split = split_by_run(data, 0, 1);
  EXPECT_EQ(split.dropped, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(split.training, (std::vector<std::size_t>{0, 3}));
}

TEST(SplitByRun, HoldsNothingOutOfOneRun) {
  const MeasuredData data = read_data("run,routing,motor_tension_N,T1_N\n1,TR3,10,1\n1,TR3,10,2\n");
  EXPECT_TRUE(split_by_run(data, 0.3, 1).held_out.empty());
}

TEST(Thinned, TakesFromEveryRunAlike) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < 100; ++i) {
    text += (i < 80 ? "long" : "short") + std::string(",TR3,10,") + std::to_string(i) + "\n";
  }
  const MeasuredData data = read_data(text);
  const RunSplit split = split_by_run(data, 0, 1);
  const auto kept = thinned(data, split.training, 20);
  const auto of_long = std::count_if(kept.begin(), kept.end(),
                                     [&](std::size_t i) { return data.readings[i].run == 0; });
  EXPECT_NEAR(static_cast<double>(of_long), 16, 1);
  EXPECT_NEAR(static_cast<double>(kept.size()), 20, 1);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
}

// A run of three gives one or two of its readings, none gives all or none of them.
TEST(Thinned, KeepsAsManyAsItMayOfManyShortRuns) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 0; i < 300; ++i) {
    text += std::to_string(i / 3) + ",TR3,10," + std::to_string(i) + "e-2\n";
  }
  const MeasuredData data = read_data(text);
  const RunSplit split = split_by_run(data, 0, 1);
  for (const std::size_t most : {100U, 170U, 299U}) {
    const auto kept = thinned(data, split.training, most);
    EXPECT_EQ(kept.size(), most);
    std::map<std::size_t, std::size_t> by_run;
    for (const std::size_t i : kept) ++by_run[data.readings[i].run];
    EXPECT_EQ(by_run.size(), 100U) << most;
    for (const auto& [run, count] : by_run) {
      EXPECT_NEAR(static_cast<double>(count), static_cast<double>(most) / 100, 1) << most;
    }
  }
}

TEST(Thinned, LeavesAloneWhatIsNotTooMuch) {
  const MeasuredData data = read_data(seven_runs());
  const RunSplit split = split_by_run(data, 0, 1);
  EXPECT_EQ(thinned(data, split.training, 28), split.training);
  EXPECT_EQ(thinned(data, split.training, 27).size(), 27U);
}

}  // namespace
}  // namespace reeve::testing
