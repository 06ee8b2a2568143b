// Noise of a known size is put on readings of a law that the estimate does not know.
#include "diagnosis/fit/noise.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

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
    text += fmt::format("{},TR3,{},{},{}\n", i / 2 % 4, motor, noisy(large, 2 * index),
                        noisy(large / 20, 2 * index + 1));
  }
  return text;
}

TEST(Noise, IsFoundInRepeats) {
  const MeasuredData data =
      read_data(rows_of_loads(600, [](int i) { return i % 2 == 0 ? 10.0 : 40.0; }));
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_EQ(noise->source, diagnosis::NoiseSource::repeats);
  EXPECT_NEAR(noise->relative, relative, 0.1 * relative);
  EXPECT_NEAR(noise->absolute_N, absolute, 0.15 * absolute);
}

// Two readings are half a difference from their mean. 400 pairs: 3.5 % of what is found.
TEST(Noise, IsFoundInPairs) {
  const MeasuredData data =
      read_data(rows_of_loads(400, [](int i) { return 10.0 + 0.1 * static_cast<double>(i / 2); }));
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_EQ(noise->source, diagnosis::NoiseSource::repeats);
  EXPECT_NEAR(noise->degrees_of_freedom, 400, 1e-6);
  EXPECT_NEAR(noise->deviation(20), std::hypot(20 * relative, absolute),
              0.12 * std::hypot(20 * relative, absolute));
}

// 0 = 0 to any accuracy: readings of other sensors that are small are not that sure.
TEST(Noise, IgnoresADeadSensor) {
  const std::string alive = rows_of_loads(240, [](int i) { return 10.0 + 0.1 * i; });
  std::string with_dead;
  std::size_t begin = 0;
  for (std::size_t end = alive.find('\n'); end != std::string::npos;
       end = alive.find('\n', begin)) {
    with_dead += alive.substr(begin, end - begin) + (begin == 0 ? ",T2_N\n" : ",0\n");
    begin = end + 1;
  }
  const auto noise = noise_without_model(all_of(read_data(alive)));
  const auto beside_dead = noise_without_model(all_of(read_data(with_dead)));
  ASSERT_TRUE(noise && beside_dead);
  EXPECT_EQ(beside_dead->absolute_N, noise->absolute_N);
  EXPECT_EQ(beside_dead->relative, noise->relative);
}

TEST(Noise, IsFoundBesideASmoothLaw) {
  const MeasuredData data = read_data(rows_of_loads(
      600, [](int i) { return 5 + 45 * uniform(7, 3, static_cast<std::uint64_t>(i)); }));
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_EQ(noise->source, diagnosis::NoiseSource::smoothing);
  EXPECT_NEAR(noise->relative, relative, 0.1 * relative);
  EXPECT_NEAR(noise->absolute_N, absolute, 0.15 * absolute);
}

// One strand at one load, which follows a column; nothing is measured twice.
TEST(Noise, OfReadingsThatDifferInOneConditionAloneIsNotThatOfRepeats) {
  const std::vector<std::pair<std::string, std::function<double(double)>>> laws{
      {"speed_mm_s", [](double v) { return 1 + 0.1 * std::log(v); }},
      {"cycle", [](double n) { return 1 + 0.3 * std::log1p(n / 100); }},
      {"temperature_C", [](double t) { return 1 + 0.01 * t; }},
      {"sheath_angle_rad", [](double a) { return 1 + 0.01 * a; }}};
  for (const auto& [column, law] : laws) {
    std::string text = "run,routing,motor_tension_N," + column + ",T1_N\n";
    for (int i = 0; i < 100; ++i) {
      const double at = 1 + 29 * uniform(7, 4, static_cast<std::uint64_t>(i));
      text += fmt::format("1,TR3,20,{},{}\n", at,
                          6 * law(at) * (1 + 0.01 * normal(7, 5, static_cast<std::uint64_t>(i))));
    }
    const MeasuredData data = read_data(text);
    const auto noise = noise_without_model(all_of(data));
    ASSERT_TRUE(noise.has_value()) << column;
    EXPECT_EQ(noise->source, diagnosis::NoiseSource::smoothing) << column;
    EXPECT_NEAR(noise->deviation(6), 0.06, 0.02) << column;
  }
}

TEST(Noise, OfReadingsInAnotherGraspDirectionOrRoutingIsNotThatOfRepeats) {
  for (const char* others : {"TR3,2,pull", "TR3,1,release", "TR5,1,pull"}) {
    std::string text = "run,routing,held,direction,motor_tension_N,T1_N\n";
    for (int i = 0; i < 100; ++i) {
      const double level = i % 2 == 0 ? 4 : 8;
      text += fmt::format("1,{},20,{}\n", i % 2 == 0 ? "TR3,1,pull" : others,
                          level * (1 + 0.01 * normal(7, 6, static_cast<std::uint64_t>(i))));
    }
    const MeasuredData data = read_data(text);
    const auto noise = noise_without_model(all_of(data));
    ASSERT_TRUE(noise.has_value()) << others;
    EXPECT_EQ(noise->source, diagnosis::NoiseSource::repeats) << others;
    EXPECT_NEAR(noise->deviation(6), 0.06, 0.02) << others;
  }
}

// Groups of ten readings, of which a regression on seven columns leaves three: 16 strands in nine
// grasps, so 432 degrees of freedom, and a standard deviation of 3.4 % of what is found.
TEST(Noise, AllowsForWhatTheRegressionTakes) {
  std::string text = "run,routing,held,motor_tension_N,speed_mm_s,cycle,temperature_C";
  for (int strand = 1; strand <= 16; ++strand) text += fmt::format(",T{}_N", strand);
  text += '\n';
  std::uint64_t index = 0;
  const auto level = [&](double middle) { return middle * (0.5 + uniform(7, 7, index++)); };
  for (int row = 0; row < 90; ++row) {
    const double motor = level(20);
    text += fmt::format("1,M-1-T-2-T-3-T-4-T-5-T-6-T-7-T-8-F,{},{},{},{},{}",
                        row % 9 == 0 ? "" : std::to_string(row % 9), motor, level(10), level(100),
                        level(20));
    for (int strand = 1; strand <= 16; ++strand) {
      text += fmt::format(",{}", 0.3 * motor * (1 + relative * normal(7, 8, index++)));
    }
    text += '\n';
  }
  const MeasuredData data = read_data(text);
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  EXPECT_NEAR(noise->degrees_of_freedom, 432, 1e-6);
  EXPECT_NEAR(noise->deviation(6), 6 * relative, 0.1 * 6 * relative);
}

// Noise in proportion alone: a reading of 0 still must not weigh infinitely.
TEST(Noise, IsNeverLessThanAThousandthOfTheMedianReading) {
  std::string text = "run,routing,motor_tension_N,T1_N,T3_N\n";
  for (int i = 0; i < 200; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    text += fmt::format("1,TR3,{},{},{}\n", 20 + i % 2, 5 * (1 + relative * normal(7, 9, index)),
                        1e-4 * (1 + relative * normal(7, 10, index)));
  }
  const MeasuredData data = read_data(text);
  const auto noise = noise_without_model(all_of(data));
  ASSERT_TRUE(noise.has_value());
  // The median of as many readings about 5 N as about 0.1 mN is the least of the former, or so.
  EXPECT_GT(noise->absolute_N, 1e-3 * 4);
  EXPECT_LT(noise->absolute_N, 1e-3 * 5);
  EXPECT_NEAR(noise->relative, relative, 0.15 * relative);
}

// Of 1 % and 0.5 N, 40 pairs from 5 to 40 N hardly tell the former: the likeliest is none of it in
// some of these files, and a reading of 100 N would then weigh four times what it should.
TEST(Noise, OfAPartThatReadingsHardlyShowIsNotZero) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::string text = "run,routing,motor_tension_N,T1_N\n";
    for (std::uint64_t i = 0; i < 80; ++i) {
      const double load = 5 + 0.9 * static_cast<double>(i / 2);
      text += fmt::format("{},TR3,{},{}\n", i / 2 % 4, load,
                          load * (1 + 0.01 * normal(seed, 1, i)) + 0.5 * normal(seed, 2, i));
    }
    const auto noise = noise_without_model(all_of(read_data(text)));
    ASSERT_TRUE(noise.has_value());
    EXPECT_GT(noise->relative, 0.002) << seed;
    EXPECT_GT(noise->absolute_N, 0.1) << seed;
    EXPECT_LT(noise->deviation(20), 0.75) << seed;
  }
}

TEST(Noise, OfTooFewReadingsNeedsAModel) {
  const MeasuredData data = read_data(rows_of_loads(8, [](int i) { return 10.0 + i; }));
  EXPECT_FALSE(noise_without_model(all_of(data)).has_value());
}

TEST(Noise, OfAReadingFarFromWhatIsExpectedIsThatOfTheReading) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N\n1,TR3,10,4\n1,TR3,10,4.1\n");
  const Noise noise{0.1, 0, diagnosis::NoiseSource::repeats, 30};
  const Eigen::VectorXd sd = deviations(all_of(data), noise, Eigen::Vector2d{0.1, 4});
  EXPECT_DOUBLE_EQ(sd[0], 0.4);
  EXPECT_DOUBLE_EQ(sd[1], 0.4);
}

// The noise is normal and of 1 %; one reading of eighty is 30 % too great or too small.
std::string rows_with_accidents() {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (std::uint64_t i = 0; i < 800; ++i) {
    const double accident = i % 80 != 7 ? 0 : i % 160 == 7 ? 0.3 : -0.3;
    text += fmt::format("{},TR3,20,{}\n", i % 4, 10 * (1 + 0.01 * normal(8, 1, i) + accident));
  }
  return text;
}

TEST(Noise, IsNotShapedByReadingsThatAreWrongByAccident) {
  const auto found = noise_without_model(all_of(read_data(rows_with_accidents())));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->deviation(10), 0.1, 0.04);  // the root of the mean square is 0.35
}

// The average of many samples cannot be less sure than the file says.
TEST(Noise, IsNotBelowWhatTheFileSaysOfAReading) {
  const MeasuredData data =
      read_data("run,routing,motor_tension_N,T1_N,T1_sd_N,readings\n1,TR3,20,10,4,4\n");
  const Noise noise{0, 0.1, diagnosis::NoiseSource::repeats, 100};
  EXPECT_NEAR(deviations(all_of(data), noise, Eigen::VectorXd::Constant(1, 10))[0], 2, 1e-12);
}

}  // namespace
}  // namespace reeve::testing
