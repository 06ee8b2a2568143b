// Draws of one sheath, whose law is closed: T1 = T_M e^(-phi (1 + tau z)).
#include "diagnosis/fit/mounted_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

constexpr int all_draws = 4000;
constexpr double nominal_exponent = 0.18 * 2 * 3.141592653589793;

// Two mountings of one routing; of the first, two rows.
MeasuredData two_mountings() {
  return read_data("run,routing,motor_tension_N,T1_N\na,M-1-F,10,3\na,M-1-F,20,6\nb,M-1-F,10,3\n");
}

// ln(T / T_M) + phi of each row and draw.
std::vector<std::vector<double>> logs(const MountingScatter& scatter) {
  const MeasuredData data = two_mountings();
  const Dataset all = dataset(data, all_readings(data));
  const MountedDraws mounted(all, Model{Hardware{}}, scatter);
  std::vector<std::vector<double>> result(3);
  for (int d = 0; d < all_draws; ++d) {
    const Eigen::VectorXd drawn = mounted.draw(5, static_cast<std::uint32_t>(d), 100);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double motor_N = *data.readings[static_cast<std::size_t>(i)].motor_tension_N;
      result[static_cast<std::size_t>(i)].push_back(std::log(drawn[i] / motor_N) +
                                                    nominal_exponent);
    }
  }
  return result;
}

double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());
}

MountingScatter of_sheaths(double tau, double told_by) {
  MountingScatter scatter;
  scatter.relative[static_cast<std::size_t>(Mounted::sheath)] = tau;
  scatter.told_by[static_cast<std::size_t>(Mounted::sheath)] = told_by;
  return scatter;
}

TEST(MountedDraws, WithoutScatterAreTheModels) {
  for (const auto& row : logs({})) EXPECT_LT(mean_product(row, row), 1e-20);
}

// Standard error of a mean square: √(2 / 4000) = 2.2 %.
TEST(MountedDraws, ShareTheExponentWithinAMountingAndNotBetween) {
  constexpr double tau = 0.3;  // no first order would do
  const auto rows = logs(of_sheaths(tau, 0));
  const double variance = std::pow(nominal_exponent * tau, 2);
  EXPECT_NEAR(mean_product(rows[0], rows[0]) / variance, 1, 0.07);
  EXPECT_NEAR(mean_product(rows[0], rows[1]) / variance, 1, 0.07);
  EXPECT_NEAR(mean_product(rows[0], rows[2]) / variance, 0, 0.05);
}

// The channel's and the motor's.
TEST(MountedDraws, ScaleReadingsByTwoGains) {
  MountingScatter scatter;
  scatter.relative[static_cast<std::size_t>(Mounted::gain)] = 0.01;
  const auto rows = logs(scatter);
  EXPECT_NEAR(mean_product(rows[0], rows[0]) / 2e-4, 1, 0.08);
  EXPECT_NEAR(mean_product(rows[0], rows[2]) / 2e-4, 0, 0.05);
}

// A scatter told by ν differences: τ² is ν / χ², whose mean is ν / (ν - 2).
TEST(MountedDraws, KnowTheScatterNoBetterThanItWasTold) {
  const auto rows = logs(of_sheaths(0.05, 12));
  EXPECT_NEAR(mean_product(rows[0], rows[0]) / std::pow(nominal_exponent * 0.05, 2), 1.2, 0.1);
}

TEST(MountedDraws, AreTheSameForOneStream) {
  const MeasuredData data = two_mountings();
  const Dataset all = dataset(data, all_readings(data));
  const MountedDraws mounted(all, Model{Hardware{}}, of_sheaths(0.05, 12));
  EXPECT_EQ(mounted.draw(1, 2, 3), mounted.draw(1, 2, 3));
  EXPECT_NE(mounted.draw(1, 2, 3), mounted.draw(1, 3, 3));
}

}  // namespace
}  // namespace reeve::testing
