#include "diagnosis/fit/null_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

constexpr std::size_t replicates = 403;  // the last ones are fewer than are drawn at a time

std::vector<Eigen::VectorXd> drawn(const Bench& bench, const Model& model, std::uint64_t seed = 1,
                                   int threads = 1) {
  const Forecast at = forecast(bench.dataset, model);
  const Projection projection(bench.problem, model, at);
  const NullModel null_model(bench.problem, projection, at, seed, replicates);
  std::vector<Eigen::VectorXd> result(replicates);
  Workers workers(threads);
  null_model.for_each(workers, [&](std::size_t first, const Eigen::MatrixXd& residuals) {
    for (const auto& one : residuals.colwise()) result[first++] = one;
  });
  return result;
}

double mean_square(const std::vector<Eigen::VectorXd>& all) {
  double sum = 0;
  for (const Eigen::VectorXd& one : all) sum += one.squaredNorm() / static_cast<double>(all.size());
  return sum;
}

// 120 readings, so that |e|² has the standard deviation √240 for each of 400 replicates.
TEST(NullModel, DrawsResidualsOfTheNoise) {
  const Bench bench(Pattern{});
  const auto all = drawn(bench, {});
  EXPECT_NEAR(mean_square(all), 120, 3 * std::sqrt(240.0 / replicates));
  double sum = 0;
  for (const Eigen::VectorXd& one : all) sum += one.sum();
  EXPECT_NEAR(sum, 0, 3 * std::sqrt(120.0 * replicates));
}

TEST(NullModel, FitsTheParametersAgain) {
  const Bench bench({1});
  const auto all = drawn(bench, on_T1.model(1));
  EXPECT_NEAR(mean_square(all), 119, 3 * std::sqrt(240.0 / replicates));
  for (const Eigen::VectorXd& one : all) {
    double of_T1 = 0;
    for (Eigen::Index i = 0; i < one.size(); i += 4) of_T1 += one[i];
    EXPECT_NEAR(of_T1, 0, 1e-9);
  }
}

// A sensor cannot read below 0: at 0 half of the noise is cut off, and what is left about its mean
// has the variance 1/2 - 1/(2 pi).
TEST(NullModel, CutsOffWhatNoSensorReads) {
  const Bench bench(Pattern{});
  Forecast zero = forecast(bench.dataset, {});
  for (Eigen::Index i = 3; i < zero.reading_N.size(); i += 4) zero.reading_N[i] = 0;
  const Projection nothing(bench.problem, {}, zero);
  const NullModel null_model(bench.problem, nothing, zero, 1, replicates);
  Workers workers(1);
  std::vector<double> sums(replicates), squares(replicates);
  null_model.for_each(workers, [&](std::size_t first, const Eigen::MatrixXd& residuals) {
    for (Eigen::Index b = 0; b < residuals.cols(); ++b) {
      const std::size_t replicate = first + static_cast<std::size_t>(b);
      for (Eigen::Index i = 3; i < residuals.rows(); i += 4) {
        sums[replicate] += residuals(i, b);
        squares[replicate] += residuals(i, b) * residuals(i, b);
      }
    }
  });
  double sum = 0, square = 0;
  for (std::size_t b = 0; b < replicates; ++b) {
    sum += sums[b];
    square += squares[b];
  }
  const double n = 30.0 * replicates;
  const double variance = 0.5 - 0.5 / std::numbers::pi;
  EXPECT_NEAR(sum / n, 0, 4 * std::sqrt(variance / n));
  EXPECT_NEAR(square / n, variance, 0.02);
}

// What T4 scatters about 0 in replicates, where its sensor read 0 in all rows but the first ones.
double scatter_of_T4(std::size_t alive) {
  Bench bench(Pattern{});
  Forecast zero = forecast(bench.dataset, {});
  for (std::size_t row = 0; row < bench.data.readings.size(); ++row) {
    const std::size_t cell = 4 * row + 3;
    zero.reading_N[static_cast<Eigen::Index>(cell)] = 0;
    bench.problem.clips[cell] = false;
    if (row < alive) continue;
    bench.data.readings[row].tension_N[3] = 0;
    bench.problem.measured_N[static_cast<Eigen::Index>(cell)] = 0;
  }
  const Projection nothing(bench.problem, {}, zero);
  const NullModel null_model(bench.problem, nothing, zero, 1, replicates);
  Workers workers(1);
  double greatest = 0;
  null_model.for_each(workers, [&](std::size_t, const Eigen::MatrixXd& residuals) {
    const Eigen::Index last = residuals.rows() - 1;  // T4 of the last row
    greatest = std::max(greatest, residuals.row(last).cwiseAbs().maxCoeff());
  });
  return greatest;
}

TEST(NullModel, AddsNoNoiseToADeadSensor) {
  EXPECT_EQ(scatter_of_T4(0), 0);
  // A coarse one that reads 0 now and then is not.
  EXPECT_GT(scatter_of_T4(1), 1);
}

TEST(NullModel, IsDrawnByTheSeedWhateverTheThreads) {
  const Bench bench(Pattern{});
  EXPECT_EQ(drawn(bench, {}, 1, 1), drawn(bench, {}, 1, 3));
  EXPECT_NE(drawn(bench, {}, 1)[0], drawn(bench, {}, 2)[0]);
}

TEST(Projection, RemovesWhatTheParametersExplain) {
  const Bench bench({1});
  const Model model = on_T1.model(1);
  const Forecast at = forecast(bench.dataset, model);
  const Projection projection(bench.problem, model, at);
  EXPECT_EQ(projection.degrees_of_freedom(), 119);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(120, 2);
  for (Eigen::Index i = 0; i < 120; i += 4) columns(i, 0) = columns(i, 1) = 7;
  for (Eigen::Index i = 1; i < 120; i += 4) columns(i, 1) = 2;
  projection.take_out(columns);
  EXPECT_EQ(columns.col(0).norm(), 0);
  EXPECT_NEAR(columns.col(1).norm(), 2 * std::sqrt(30), 1e-6);
}

TEST(OrthonormalBasis, LeavesOutWhatOtherColumnsExplain) {
  Eigen::MatrixXd columns(4, 3);
  columns << 1, 0, 0, 0.3, 1.7, 0, 0.7, 0.1, 0, 0.2, 2.9, 0;
  columns.col(2) = 1e6 * (std::numbers::sqrt2 * columns.col(0) + std::numbers::pi * columns.col(1));
  const Eigen::MatrixXd basis = orthonormal_basis(columns);
  ASSERT_EQ(basis.cols(), 2);
  EXPECT_TRUE((basis.transpose() * basis).isApprox(Eigen::Matrix2d::Identity(), 1e-12));
  EXPECT_NEAR((columns.col(2) - basis * (basis.transpose() * columns.col(2))).norm(), 0, 1e-6);
}

// The data count as one replicate more, so that no p-value is 0.
TEST(PValue, IsTheShareOfReplicatesThatAreAtLeastAsFar) {
  EXPECT_DOUBLE_EQ(p_value(5, {1, 2, 3, 4}), 0.2);
  EXPECT_DOUBLE_EQ(p_value(3, {1, 2, 3, 4}), 0.6);
  EXPECT_DOUBLE_EQ(p_value(0, {1, 2, 3, 4}), 1);
}

}  // namespace
}  // namespace reeve::testing
