// Noise of a known size is put on readings of a law that the estimate does not know.
#include "diagnosis/noise.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "numerics/random.hpp"
#include "tests/diagnosis/read_data.hpp"

namespace reeve::testing {
namespace {

constexpr double relative = 0.03;
constexpr double absolute = 0.05;

double noisy(double tension, std::uint64_t index) {
  return tension * (1 + relative * normal(7, 1, index)) + absolute * normal(7, 2, index);
}

// T1 large and T3 small, so that both parts of the noise show.
std::string rows_of_loads(int count, const std::function<double(int)>& motor_tension) {
  std::string text = "run,routing,motor_tension_N,T1_N,T3_N\n";
  for (int i = 0; i < count; ++i) {
    const double motor = motor_tension(i);
    const auto index = static_cast<std::uint64_t>(i);
    const double large = 0.8 * std::pow(motor, 1.1);
    text += fmt::format("{},TR3,{},{},{}\n", i % 4, motor, noisy(large, 2 * index),
                        noisy(large / 20, 2 * index + 1));
  }
  return text;
}

TEST(Noise, IsFoundInRepeats) {
  const MeasuredData data =
      read_data(rows_of_loads(600, [](int i) { return i % 2 == 0 ? 10.0 : 40.0; }));
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_EQ(noise->source, NoiseSource::repeats);
  EXPECT_NEAR(noise->relative, relative, 0.1 * relative);
  EXPECT_NEAR(noise->absolute_N, absolute, 0.15 * absolute);
}

TEST(Noise, IsFoundBesideASmoothLaw) {
  const MeasuredData data = read_data(rows_of_loads(
      600, [](int i) { return 5 + 45 * uniform(7, 3, static_cast<std::uint64_t>(i)); }));
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_EQ(noise->source, NoiseSource::smoothing);
  EXPECT_NEAR(noise->relative, relative, 0.1 * relative);
  EXPECT_NEAR(noise->absolute_N, absolute, 0.15 * absolute);
}

TEST(Noise, OfTooFewReadingsNeedsAModel) {
  const MeasuredData data = read_data(rows_of_loads(8, [](int i) { return 10.0 + i; }));
  EXPECT_FALSE(noise_without_model(all_of(data)).has_value());
}

TEST(Noise, OfAReadingFarFromWhatIsExpectedIsThatOfTheReading) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N\n1,TR3,10,4\n1,TR3,10,4.1\n");
  const Noise noise{0.1, 0, NoiseSource::repeats, 30};
  const Eigen::VectorXd sd = deviations(all_of(data), noise, Eigen::Vector2d{0.1, 4});
  EXPECT_DOUBLE_EQ(sd[0], 0.4);
  EXPECT_DOUBLE_EQ(sd[1], 0.4);
}

}  // namespace
}  // namespace reeve::testing
