// What rigs do, hidden by formulas in the readings of a bench, and named by the diagnosis. The
// bench is M-F, a sheath between a motor-side sensor (a) and one at the hand (h1), pulled and
// released:
//
//   a = T_in      h1 = T_in e^{-phi} pulling, T_in e^{phi} releasing,   phi = 0.18 theta
//
// and none of the laws below is taken from the causes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

struct BenchRow {
  bool pulled = true;
  double motor_N = 0;
  double speed_mm_s = 0;
  double angle_rad = 0;
  double place = 0;  // 0 … 1
  // As the plain model has them.
  double arriving_N = 0;
  double exponent = 0;
};

struct BenchReadings {
  double a = 0;
  double h1 = 0;
};

struct HiddenInBench {
  const char* name;
  std::function<void(BenchRow&)> tendon;
  std::function<void(const BenchRow&, BenchReadings&)> sensors;
  const char* equivalent = "";  // another cause of the same readings
};

constexpr std::size_t bench_runs = 8;
constexpr std::size_t bench_rows = 12;

BenchRow bench_row(std::size_t i) {
  const auto draw = [&](std::uint32_t stream) { return uniform(10, stream, i); };
  BenchRow row;
  row.pulled = i % 2 == 0;
  row.motor_N = 6 + 34 * draw(0);
  row.speed_mm_s = 1 + 80 * draw(1);
  row.angle_rad = 1 + 3 * draw(2);
  row.place = static_cast<double>(i) / static_cast<double>(bench_runs * bench_rows - 1);
  row.arriving_N = row.motor_N;
  row.exponent = 0.18 * row.angle_rad;
  return row;
}

std::string bench_csv(const HiddenInBench& hidden) {
  std::string csv =
      "run,routing,direction,motor_tension_N,speed_mm_s,sheath_angle_rad,Ta_N,Th1_N\n";
  for (std::size_t i = 0; i < bench_runs * bench_rows; ++i) {
    BenchRow row = bench_row(i);
    if (hidden.tendon) hidden.tendon(row);
    const double ratio = std::exp(row.pulled ? -row.exponent : row.exponent);
    BenchReadings readings{row.arriving_N, row.arriving_N * ratio};
    if (hidden.sensors) hidden.sensors(row, readings);
    const auto noisy = [&](double tension, std::uint32_t stream) {
      return std::max(
          0.0, tension * (1 + 0.005 * normal(10, stream, i)) + 0.02 * normal(10, stream + 1, i));
    };
    csv += fmt::format("{},M-F,{},{},{},{},{},{}\n", i / bench_rows + 1,
                       row.pulled ? "pull" : "release", row.motor_N, row.speed_mm_s, row.angle_rad,
                       noisy(readings.a, 10), noisy(readings.h1, 20));
  }
  return csv;
}

std::vector<HiddenInBench> all_hidden() {
  const auto taken = [](BenchRow& row, double force_N) {
    row.arriving_N += row.pulled ? -force_N : force_N;
  };
  return {
      {"motor_gain", [](BenchRow& row) { row.arriving_N *= 1.1; }, {}},
      {"motor_offset", [](BenchRow& row) { row.arriving_N += 1; }, {}},
      {"constant_loss", [=](BenchRow& row) { taken(row, 1); }, {}},
      {"viscous_loss", [=](BenchRow& row) { taken(row, 0.03 * row.speed_mm_s); }, {}},
      {"wrap_free_loss", [](BenchRow& row) { row.exponent += 0.2; }, {}},
      {"hysteresis", [](BenchRow& row) { row.exponent *= row.pulled ? 1 : 1.3; }, {}},
      {"cross_talk[a]", {}, [](const BenchRow&, BenchReadings& r) { r.a += 0.1 * r.h1; }},
      // Of sensors that cannot read below 0 a dead zone is an offset.
      {"sensor_offset[h1]",
       {},
       [](const BenchRow&, BenchReadings& r) { r.h1 = std::max(0.0, r.h1 - 6); }},
      // As if the sheath were seized: then nothing arrives there either.
      {"dead_channel[h1]",
       {},
       [](const BenchRow&, BenchReadings& r) { r.h1 = 0; },
       "seized_contact[M-F,a-h1]"},
      {"drift[a]", {}, [](const BenchRow& row, BenchReadings& r) { r.a += 2 * row.place; }},
      {"saturation[h1]",
       {},
       [](const BenchRow&, BenchReadings& r) { r.h1 = std::min(r.h1, 25.0); }},
      {"swapped_channels[a,h1]",
       {},
       [](const BenchRow&, BenchReadings& r) { std::swap(r.a, r.h1); }},
  };
}

class HiddenInABench : public ::testing::TestWithParam<HiddenInBench> {};

TEST_P(HiddenInABench, IsNamedAndNothingElseIs) {
  DiagnoseOptions options;
  options.replicates = 200;
  const DiagnosisResult result = diagnose(read_data(bench_csv(GetParam())), Hardware{}, options);
  ASSERT_EQ(result.causes.size(), 1U);
  const std::string equivalent = GetParam().equivalent;
  if (equivalent.empty()) {
    EXPECT_EQ(result.causes[0].name, GetParam().name);
    EXPECT_EQ(result.verdict, Verdict::cause);
  } else {
    EXPECT_EQ(result.verdict, Verdict::indistinguishable);
    ASSERT_EQ(result.indistinguishable.size(), 1U);
    const std::vector<std::string>& names = result.indistinguishable[0];
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()),
              (std::set<std::string>{GetParam().name, equivalent}));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, HiddenInABench, ::testing::ValuesIn(all_hidden()), [](const auto& hidden) {
      std::string name = hidden.param.name;
      std::replace_if(
          name.begin(), name.end(),
          [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
      return name;
    });

TEST(PlainBench, HasNoCause) {
  DiagnoseOptions options;
  options.replicates = 200;
  EXPECT_EQ(diagnose(read_data(bench_csv({"none", {}, {}})), Hardware{}, options).verdict,
            Verdict::none);
}

}  // namespace
}  // namespace reeve::testing
