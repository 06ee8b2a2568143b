#include "diagnosis/verdict/structure.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Limits of the tests in every replicate, which keep them cheap for any file.
constexpr std::size_t most_groups = 200;
constexpr std::size_t most_frequencies = 150;
// With fewer readings, a mean says no more than a residual.
constexpr std::size_t least_group = 3;

// Returns the effect of a relative change of every reading, in units of the noise.
VectorXd relative(const Problem& problem, const Forecast& at) {
  return at.reading_N.cwiseQuotient(problem.deviation_N);
}

using CellKey = std::function<std::string(const Cell&, const Reading&)>;

std::map<std::string, std::vector<std::size_t>> groups(const Dataset& dataset, const CellKey& key) {
  std::map<std::string, std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    const Cell& cell = dataset.cells[i];
    result[key(cell, dataset.data->readings[cell.reading])].push_back(i);
  }
  std::erase_if(result, [](const auto& group) { return group.second.size() < least_group; });
  return result;
}

class Tests {
 public:
  Tests(const Problem& problem, const Forecast& at, const Projection& projection)
      : problem_(problem),
        dataset_(*problem.dataset),
        data_(*problem.dataset->data),
        at_(at),
        projection_(projection),
        relative_(relative(problem, at)),
        absolute_(problem.deviation_N.cwiseInverse()) {}

  std::vector<StructureTest> all() {
    const auto channel = [this](const Cell& cell) { return data_.channels[cell.channel].name; };
    if (!data_.groups.empty()) {
      add_groups("group", [](const Cell&, const Reading& r) {
        return r.group ? std::to_string(*r.group) : std::string();
      });
    }
    add_groups("routing", [](const Cell&, const Reading& r) { return std::to_string(r.routing); });
    add_groups("strand", [=](const Cell& c, const Reading&) { return channel(c); });
    add_groups("grasp", [](const Cell&, const Reading& r) {
      return to_text(r.grasp) + (r.direction == Direction::pull ? "" : " release");
    });
    add_groups("routing, grasp and strand", [=](const Cell& c, const Reading& r) {
      return fmt::format("{} {} {} {}", r.routing, r.grasp.held, static_cast<int>(r.direction),
                         channel(c));
    });
    add_trend("load", &Reading::motor_tension_N, true);
    add_trend("speed", &Reading::speed_mm_s, true);
    add_trend("cycle", &Reading::cycle, false);
    add_trend("temperature", &Reading::temperature_C, false);
    for (std::size_t k = 0; k < data_.covariates.size(); ++k) {
      add_trend(
          "column '" + data_.covariates[k] + "'", [k](const Reading& r) { return r.covariates[k]; },
          false);
    }
    add_order();
    return std::move(tests_);
  }

 private:
  void add(std::string about, MatrixXd columns, bool scan) {
    take_out_scales(columns);
    whiten(problem_.shared, columns);
    projection_.take_out(columns);
    if (!scan) columns = orthonormal_basis(columns);
    if (scan) normalise_pairs(columns);
    if (columns.cols() > 0) tests_.push_back({std::move(about), std::move(columns), scan});
  }

  // As of residuals. If a row's scale is free, a joint change of all its readings says nothing: the
  // remainder of such a column is rounding.
  void take_out_scales(MatrixXd& columns) const {
    constexpr double of_rounding = 1e-6;
    for (Index c = 0; c < columns.cols(); ++c) {
      VectorXd column = columns.col(c);
      const double before = column.norm();
      diagnosis::take_out_scales(problem_, at_, column);
      if (column.norm() <= of_rounding * before) column.setZero();
      columns.col(c) = column;
    }
  }

  static void normalise_pairs(MatrixXd& columns) {
    for (Index c = 0; c < columns.cols(); c += 2) {
      columns.col(c) /= std::max(columns.col(c).norm(), 1e-300);
      columns.col(c + 1) -= columns.col(c).dot(columns.col(c + 1)) * columns.col(c);
      columns.col(c + 1) /= std::max(columns.col(c + 1).norm(), 1e-300);
    }
  }

  void add_groups(const std::string& about, const CellKey& key) {
    const auto found = groups(dataset_, key);
    if (found.size() < 2 || found.size() > most_groups) return;
    MatrixXd columns = MatrixXd::Zero(relative_.size(), 2 * static_cast<Index>(found.size()));
    Index column = 0;
    for (const auto& [name, cells] : found) {
      for (const std::size_t i : cells) {
        const auto row = static_cast<Index>(i);
        columns(row, column) = relative_[row];
        columns(row, column + 1) = absolute_[row];
      }
      column += 2;
    }
    // Groups of many cells are told apart by their relative residual alone.
    constexpr std::size_t few = 12;  // two columns for each would be too much to project
    if (found.size() > few) {
      for (Index c = 0; c < column / 2; ++c) columns.col(c) = MatrixXd(columns.col(2 * c));
      columns.conservativeResize(Eigen::NoChange, column / 2);
    }
    add(about, std::move(columns), false);
  }

  // Linear and quadratic in the variable (or its logarithm), for each channel.
  template <typename Value>
  void add_trend(const std::string& about, Value value, bool logarithmic) {
    std::vector<double> x(dataset_.rows.size(), std::nan(""));
    double sum = 0, squares = 0, count = 0;
    for (std::size_t r = 0; r < x.size(); ++r) {
      const std::optional<double> given =
          std::invoke(value, data_.readings[dataset_.rows[r].reading]);
      if (!given) continue;
      x[r] = logarithmic ? std::log(std::max(*given, 1e-6)) : *given;
      sum += x[r];
      squares += x[r] * x[r];
      count += 1;
    }
    if (count < 4) return;
    const double mean = sum / count;
    const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    if (deviation <= 1e-9 * (1 + std::abs(mean))) return;
    const auto channels = static_cast<Index>(data_.channels.size());
    MatrixXd columns = MatrixXd::Zero(relative_.size(), 2 * channels);
    for (std::size_t r = 0; r < x.size(); ++r) {
      if (std::isnan(x[r])) continue;
      const double z = (x[r] - mean) / deviation;
      for (std::size_t i = dataset_.rows[r].first; i < dataset_.rows[r].last; ++i) {
        const auto c = 2 * static_cast<Index>(dataset_.cells[i].channel);
        columns(static_cast<Index>(i), c) = relative_[static_cast<Index>(i)] * z;
        columns(static_cast<Index>(i), c + 1) = relative_[static_cast<Index>(i)] * (z * z - 1);
      }
    }
    add(about, std::move(columns), false);
  }

  void add_order() {
    const std::size_t rows = dataset_.rows.size();
    if (rows < 8) return;
    const std::size_t frequencies = std::min(rows / 2, most_frequencies);
    MatrixXd columns(relative_.size(), 2 * static_cast<Index>(frequencies));
    for (std::size_t r = 0; r < rows; ++r) {
      const double along = static_cast<double>(data_.readings[dataset_.rows[r].reading].taken) /
                           static_cast<double>(data_.readings.size());
      for (std::size_t f = 0; f < frequencies; ++f) {
        // Half a turn from the first reading to the last, which is a drift; then whole turns.
        const double turn = 2 * std::numbers::pi * along * (f == 0 ? 0.5 : static_cast<double>(f));
        const auto cosine = 2 * static_cast<Index>(f);
        for (std::size_t i = dataset_.rows[r].first; i < dataset_.rows[r].last; ++i) {
          const auto row = static_cast<Index>(i);
          columns(row, cosine) = relative_[row] * std::cos(turn);
          columns(row, cosine + 1) = relative_[row] * std::sin(turn);
        }
      }
    }
    add("order of the rows", std::move(columns), true);
  }

  const Problem& problem_;
  const Dataset& dataset_;
  const MeasuredData& data_;
  const Forecast& at_;
  const Projection& projection_;
  VectorXd relative_;
  VectorXd absolute_;
  std::vector<StructureTest> tests_;
};

double explained(const StructureTest& test, const VectorXd& along) {
  if (!test.scan) return along.squaredNorm();
  double greatest = 0;
  for (Index c = 0; c < along.size(); c += 2) {
    greatest = std::max(greatest, along.segment(c, 2).squaredNorm());
  }
  return greatest;
}

// Returns the statistics of each column of residuals.
std::vector<double> statistics(const StructureTest& test, const MatrixXd& residuals) {
  const MatrixXd along = test.patterns.transpose() * residuals;
  std::vector<double> result;
  for (Index b = 0; b < residuals.cols(); ++b) {
    const double all = std::max(residuals.col(b).squaredNorm(), 1e-300);
    result.push_back(std::cbrt(explained(test, along.col(b)) / all));
  }
  return result;
}

// "T2 of M-1-P-2-M, held 1": the group whose mean residual is farthest from 0.
std::string farthest_group(const Problem& problem, const VectorXd& residuals) {
  const MeasuredData& data = *problem.dataset->data;
  const auto found = groups(*problem.dataset, [&](const Cell& cell, const Reading& reading) {
    const MeasuredRouting& routing = data.routings[reading.routing];
    const bool has_grasps = routing.network.fingers > 1 || reading.grasp.held != 0;
    const std::string held = has_grasps ? ", held " + to_text(reading.grasp) : "";
    return fmt::format("{} of {}{}{}", data.channels[cell.channel].name, routing.word, held,
                       reading.direction == Direction::pull ? "" : ", release");
  });
  std::string farthest;
  double greatest = 0;
  for (const auto& [name, cells] : found) {
    double sum = 0;
    for (const std::size_t i : cells) sum += residuals[static_cast<Index>(i)];
    const double z = sum / std::sqrt(static_cast<double>(cells.size()));
    if (std::abs(z) <= std::abs(greatest)) continue;
    greatest = z;
    farthest = name + (z > 0 ? " (reads more)" : " (reads less)");
  }
  return farthest;
}

}  // namespace

std::vector<StructureTest> structure_tests(const Problem& problem, const Forecast& at,
                                           const Projection& projection) {
  return Tests(problem, at, projection).all();
}

StructureResult find_structure(const Problem& problem, const std::vector<StructureTest>& tests,
                               const VectorXd& residuals, const NullModel& null_model,
                               Workers& workers) {
  StructureResult result;
  if (tests.empty()) return result;
  std::vector<std::vector<double>> null(tests.size(), std::vector<double>(null_model.replicates()));
  null_model.for_each(workers, [&](std::size_t first, const MatrixXd& drawn) {
    for (std::size_t t = 0; t < tests.size(); ++t) {
      const std::vector<double> of_each = statistics(tests[t], drawn);
      std::ranges::copy(of_each, null[t].begin() + static_cast<std::ptrdiff_t>(first));
    }
  });
  std::vector<double> greatest(null_model.replicates(), -1e300);
  double observed = -1e300;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const auto n = static_cast<double>(null[t].size());
    const Eigen::Map<const VectorXd> sample(null[t].data(), static_cast<Index>(null[t].size()));
    const double mean = sample.mean();
    const double deviation =
        std::sqrt((sample.array() - mean).square().sum() / std::max(n - 1, 1.0)) + 1e-300;
    const double measured = statistics(tests[t], residuals).front();
    const double here = (measured - mean) / deviation;
    for (std::size_t b = 0; b < greatest.size(); ++b) {
      greatest[b] = std::max(greatest[b], (null[t][b] - mean) / deviation);
    }
    observed = std::max(observed, here);
    const double by_chance = sample.array().cube().mean();
    const double share = std::max(0.0, std::pow(measured, 3) - by_chance);
    result.findings.push_back({tests[t].about, here, p_value(measured, null[t]), share});
  }
  std::ranges::stable_sort(result.findings,
                           [](const auto& a, const auto& b) { return a.statistic > b.statistic; });
  result.p_value = p_value(observed, greatest);
  result.where = farthest_group(problem, residuals);
  return result;
}

StructureResult residual_structure(const Problem& problem, const Model& model,
                                   const MountingScatter& mounting, double alpha,
                                   const Replicates& replicates, Workers& workers) {
  const Dataset& training = *problem.dataset;
  const Forecast at = forecast(training, model);
  const Projection projection(problem, model, at);
  const Eigen::VectorXd left = projection.taken_out(residuals(problem, at));
  const auto tests = structure_tests(problem, at, projection);
  const auto judged_by = [&](const MountedDraws* mounted) {
    const NullModel null_model(problem, projection, at, replicates.seed, replicates.count, mounted);
    return find_structure(problem, tests, left, null_model, workers);
  };
  StructureResult result = judged_by(nullptr);
  if (result.p_value >= alpha || problem.shared.empty()) return result;
  const MountedDraws mounted(training, model, mounting);
  return judged_by(&mounted);
}

}  // namespace reeve::diagnosis
