#include "readings/motor_limit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

// Strands that carry a third of what the motor pulls, but for half a percent, which goes on and
// off. The motor pulls 2 N more from row to row.
std::string rows(double limit_N, double off = 0.005) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (int i = 1; i <= 30; ++i) {
    text += fmt::format("A,TR5,{},{}\n", std::min(2.0 * i, limit_N),
                        2.0 * i / 3 * (i % 2 == 0 ? 1 : 1 + off));
  }
  return text;
}

std::size_t freed(const MeasuredData& data) {
  return static_cast<std::size_t>(std::ranges::count_if(
      data.readings, [](const Reading& reading) { return !reading.motor_tension_N; }));
}

TEST(MotorLimit, TakesTheMotorTensionOffTheRowsWhereItsSensorEnds) {
  const MeasuredData data = read_data(rows(30));
  EXPECT_EQ(freed(data), 16U);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::not_compared).size(), 16U);
}

TEST(MotorLimit, IsNoneWhereStrandsCarryTheSamePart) {
  EXPECT_EQ(freed(read_data(rows(100))), 0U);
  EXPECT_EQ(freed(read_data(rows(52))), 0U);  // too few rows to tell
  EXPECT_EQ(freed(read_data(rows(30, 0.5))), 0U);
}

}  // namespace
}  // namespace reeve::testing
