#include "diagnosis/fit/scatter_samples.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "numerics/matrices.hpp"

namespace reeve::diagnosis {
namespace {

using CellGroup = std::vector<std::size_t>;  // cells

const DatasetRow& row_of(const Dataset& dataset, std::size_t cell) {
  return dataset.rows[dataset.cells[cell].row];
}

// Returns the variance of a reading in proportion to the motor tension, N².
double motor_variance_of_reading(const DatasetRow& row, double reading_N) {
  return motor_variance(row, reading_N / row.conditions.motor_tension_N);
}

// The cells of each run have a column.
Eigen::MatrixXd run_columns(const Dataset& dataset, const CellGroup& cells) {
  std::map<std::size_t, Eigen::Index> place;
  const auto run_of = [&](std::size_t cell) {
    return dataset.data->readings[dataset.cells[cell].reading].run;
  };
  for (const std::size_t i : cells) {
    place.emplace(run_of(i), static_cast<Eigen::Index>(place.size()));
  }
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cells.size()),
                                                  static_cast<Eigen::Index>(place.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    columns(static_cast<Eigen::Index>(i), place.at(run_of(cells[i]))) = 1;
  }
  return columns;
}

// The columns of a regression of T / T_M that vary among these cells, centred.
Eigen::MatrixXd smooth_columns(const Dataset& dataset, const CellGroup& cells, Runs runs) {
  const auto n = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd all(n, 7);
  for (Eigen::Index i = 0; i < n; ++i) {
    const DatasetRow& row = row_of(dataset, cells[static_cast<std::size_t>(i)]);
    const Conditions& at = row.conditions;
    all.row(i) << 1 / at.motor_tension_N, std::log(at.motor_tension_N),
        std::log(std::max(at.speed_mm_s, 0.01)), std::log1p(at.cycle / 100), at.temperature_C,
        dataset.data->readings[row.reading].sheath_angle_rad.value_or(0),
        static_cast<double>(dataset.data->readings[row.reading].taken);
  }
  const Eigen::MatrixXd levels =
      runs == Runs::alike ? Eigen::MatrixXd::Ones(n, 1) : run_columns(dataset, cells);
  Eigen::MatrixXd columns(n, levels.cols() + all.cols());
  columns.leftCols(levels.cols()) = levels;
  Eigen::Index used = levels.cols();
  for (Eigen::Index c = 0; c < all.cols(); ++c) {
    const Eigen::VectorXd centred = all.col(c).array() - all.col(c).mean();
    const double size = centred.norm();
    if (size > 1e-9 * (1 + all.col(c).norm())) columns.col(used++) = centred / size;
  }
  return columns.leftCols(used);
}

void smooth(const Dataset& dataset, const CellGroup& cells, double level, Runs runs,
            std::vector<ScatterSample>& samples) {
  const Eigen::MatrixXd columns = smooth_columns(dataset, cells, runs);
  if (columns.rows() < columns.cols() + 3) return;
  Eigen::VectorXd ratio(columns.rows());
  Eigen::VectorXd weight(columns.rows());
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const std::size_t cell = cells[static_cast<std::size_t>(i)];
    const double measured = dataset.cells[cell].measured_N;
    const double motor = row_of(dataset, cell).conditions.motor_tension_N;
    ratio[i] = measured / motor;
    weight[i] = motor / (measured + 0.1 * level);
  }
  const Eigen::MatrixXd weighted = weight.asDiagonal() * columns;
  // A column that is the same in every row of a run is one with the runs' levels.
  const Eigen::MatrixXd q = orthonormal_columns(weighted);
  const Eigen::VectorXd scaled = weight.cwiseProduct(ratio);
  const Eigen::VectorXd left = scaled - q * (q.transpose() * scaled);
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    const Cell& cell = dataset.cells[cells[static_cast<std::size_t>(i)]];
    const DatasetRow& row = dataset.rows[cell.row];
    const double residual = left[i] / weight[i] * row.conditions.motor_tension_N;
    const double expected = std::max(cell.measured_N - residual, 0.0);
    samples.push_back({expected, residual, 1 - q.row(i).squaredNorm(),
                       motor_variance_of_reading(row, expected), cell.row});
  }
}

}  // namespace

double median_reading(const Dataset& dataset) {
  std::vector<double> readings;
  for (const Cell& cell : dataset.cells) {
    if (cell.measured_N > 0) readings.push_back(cell.measured_N);
  }
  if (readings.empty()) return 1;
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2);
  std::nth_element(readings.begin(), middle, readings.end());
  return *middle;
}

std::vector<bool> tell_of_noise(const Dataset& dataset) {
  std::vector<bool> result = reads_zero_alone(*dataset.data);
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = !result[c] && !known_noise(*dataset.data, c);
  }
  return result;
}

double motor_variance(const DatasetRow& row, double by_scale) {
  return std::pow(row.motor_deviation_N * by_scale, 2);
}

std::vector<ScatterSample> repeats(const Dataset& dataset, Runs runs, std::vector<char>& used) {
  using Key = std::tuple<std::size_t, std::size_t, std::size_t, std::uint64_t, Direction, double,
                         double, double, double, std::optional<double>>;
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::map<Key, CellGroup> groups;
  for (const DatasetRow& row : dataset.rows) {
    if (!row.has_motor_tension) continue;
    const Reading& reading = dataset.data->readings[row.reading];
    const Conditions& at = row.conditions;
    for (std::size_t i = row.first; i < row.last; ++i) {
      if (!tells[dataset.cells[i].channel]) continue;
      groups[{runs == Runs::by_themselves ? reading.run : 0, dataset.cells[i].channel,
              reading.routing, reading.grasp.held, reading.direction, at.motor_tension_N,
              at.speed_mm_s, at.cycle, at.temperature_C, reading.sheath_angle_rad}]
          .push_back(i);
    }
  }
  std::vector<ScatterSample> samples;
  for (const auto& [key, group] : groups) {
    const auto n = static_cast<double>(group.size());
    if (group.size() < 2) continue;
    double mean = 0;
    for (const std::size_t i : group) mean += dataset.cells[i].measured_N / n;
    for (const std::size_t i : group) {
      samples.push_back({mean, dataset.cells[i].measured_N - mean, 1 - 1 / n,
                         motor_variance_of_reading(row_of(dataset, i), mean),
                         dataset.cells[i].row});
      used[i] = 1;
    }
  }
  return samples;
}

std::vector<ScatterSample> smoothing(const Dataset& dataset, Runs runs,
                                     const std::vector<char>& used) {
  const double level = median_reading(dataset);
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::vector<ScatterSample> samples;
  using Key = std::tuple<std::size_t, std::size_t, std::uint64_t, Direction>;
  std::map<Key, CellGroup> groups;
  for (const DatasetRow& row : dataset.rows) {
    if (!row.has_motor_tension) continue;
    const Reading& reading = dataset.data->readings[row.reading];
    for (std::size_t i = row.first; i < row.last; ++i) {
      if (used[i] != 0 || !tells[dataset.cells[i].channel]) continue;
      groups[{dataset.cells[i].channel, reading.routing, reading.grasp.held, reading.direction}]
          .push_back(i);
    }
  }
  for (const auto& [key, cells] : groups) smooth(dataset, cells, level, runs, samples);
  return samples;
}

void take_out_motor(const Dataset& dataset, std::vector<ScatterSample>& samples) {
  const double small_N = 0.1 * median_reading(dataset);
  std::map<std::size_t, std::vector<ScatterSample*>> rows;
  for (ScatterSample& sample : samples) {
    if (sample.motor_variance_N2 > 0) rows[sample.row].push_back(&sample);
  }
  for (auto& [row, cells] : rows) {
    if (cells.size() < 2) continue;
    const auto per_level = [&](const ScatterSample& of) {
      return of.level_N / std::pow(of.level_N + small_N, 2);
    };
    double weights = 0;
    double share = 0;
    for (const ScatterSample* sample : cells) {
      weights += per_level(*sample) * sample->level_N;
      share += per_level(*sample) * sample->residual_N;
    }
    share /= weights;
    for (ScatterSample* sample : cells) {
      sample->residual_N -= share * sample->level_N;
      sample->kept *= 1 - per_level(*sample) * sample->level_N / weights;
      sample->motor_variance_N2 = 0;
    }
  }
}

}  // namespace reeve::diagnosis
