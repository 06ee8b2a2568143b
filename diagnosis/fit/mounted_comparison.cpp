#include "diagnosis/fit/mounted_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "diagnosis/fit/null_model.hpp"
#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Mountings compared per routing. More tell little more about four numbers, and the cost grows with
// the cube.
constexpr std::size_t most_mountings = 12;

// Columns that any model of a routing could explain in all its mountings together.
class CommonColumns {
 public:
  CommonColumns(const Problem& problem, const Forecast& at)
      : dataset_(*problem.dataset),
        relative_(at.reading_N.cwiseQuotient(problem.deviation_N)),
        absolute_(problem.deviation_N.cwiseInverse()) {}

  MatrixXd of(const std::vector<Index>& cells) const {
    std::map<std::tuple<std::uint64_t, Direction, std::size_t>, Index> classes;
    std::map<std::size_t, Index> channels;
    for (const Index i : cells) {
      const Cell& cell = dataset_.cells[static_cast<std::size_t>(i)];
      const Reading& reading = dataset_.data->readings[cell.reading];
      classes.emplace(std::tuple(reading.grasp.held, reading.direction, cell.channel),
                      static_cast<Index>(classes.size()));
      channels.emplace(cell.channel, static_cast<Index>(channels.size()));
    }
    const auto means = static_cast<Index>(classes.size());
    MatrixXd columns = MatrixXd::Zero(static_cast<Index>(cells.size()),
                                      means + 3 * static_cast<Index>(channels.size()));
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const Cell& cell = dataset_.cells[static_cast<std::size_t>(cells[n])];
      const Reading& reading = dataset_.data->readings[cell.reading];
      const double relative = relative_[cells[n]];
      const auto row = static_cast<Index>(n);
      columns(row, classes.at({reading.grasp.held, reading.direction, cell.channel})) = relative;
      const Index trend = means + 3 * channels.at(cell.channel);
      const double motor = std::max(reading.motor_tension_N.value_or(1), 1e-6);
      columns(row, trend) = absolute_[cells[n]];
      columns(row, trend + 1) = relative * std::log(motor);
      columns(row, trend + 2) =
          relative * std::log(std::max(reading.speed_mm_s.value_or(10), 0.01) / 10);
    }
    return columns;
  }

 private:
  const Dataset& dataset_;
  VectorXd relative_;
  VectorXd absolute_;
};

// Returns columns for the effects of cycle and temperature at each kind of contact, and of the
// order at each channel.
MatrixXd condition_columns(const Problem& problem, const MountingModes& modes) {
  const Dataset& dataset = *problem.dataset;
  constexpr Index conditions = 4;
  std::vector<Eigen::Vector4d> of_row;
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  for (const DatasetRow& row : dataset.rows) {
    const Reading& reading = dataset.data->readings[row.reading];
    const double cycle = reading.cycle.value_or(0);
    of_row.emplace_back(cycle, std::log1p(std::max(cycle, 0.0) / 100),
                        reading.temperature_C.value_or(20), static_cast<double>(reading.taken));
    mean += of_row.back() / static_cast<double>(dataset.rows.size());
  }
  MatrixXd result =
      MatrixXd::Zero(modes.by_share_N.rows(), conditions * static_cast<Index>(mounted_kinds));
  for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
    const Eigen::Vector4d centred = of_row[r] - mean;
    for (std::size_t i = dataset.rows[r].first; i < dataset.rows[r].last; ++i) {
      const auto cell = static_cast<Index>(i);
      for (std::size_t k = 0; k < modes.kind.size(); ++k) {
        const double change =
            modes.by_share_N(cell, static_cast<Index>(k)) / problem.deviation_N[cell];
        const Index first = conditions * static_cast<Index>(modes.kind[k]);
        for (Index c = 0; c < conditions; ++c) result(cell, first + c) += change * centred[c];
      }
    }
  }
  return result;
}

// A reading that is far off is so by accident, or by a law: of mountings it says no more than one
// at the limit.
VectorXd limited(const VectorXd& residuals) {
  const std::vector<double> all(residuals.begin(), residuals.end());
  constexpr double usual = 10;
  const double limit = usual * std::max(mad_about_zero(all), 1.0);
  return residuals.cwiseMax(-limit).cwiseMin(limit);
}

class MountedComparison {
 public:
  MountedComparison(const Problem& problem, const Forecast& at, const MountingModes& modes)
      : common_(problem, at), modes_(modes), problem_(problem), at_(at) {
    residuals_ = limited(own_residuals(problem, at));
    conditions_ = without_scales(condition_columns(problem, modes));
    loadings_ = without_scales(problem.deviation_N.cwiseInverse().asDiagonal() * modes.by_share_N);
    // A difference between groups of rows is no scatter of mountings.
    std::map<std::pair<std::size_t, std::optional<std::size_t>>, std::vector<Mounting>> comparable;
    for (Mounting& mounting : mountings(*problem.dataset)) {
      comparable[{mounting.routing, group_of(mounting)}].push_back(std::move(mounting));
    }
    for (const auto& [key, all] : comparable) {
      if (all.size() > 1) add(chosen(all));
    }
  }

  MountedEquations equations() const {
    MountedEquations result;
    result.kind = kind_;
    result.mounted_again = mounted_again_;
    if (parts_.empty()) return result;
    const auto size = static_cast<Index>(kind_.size());
    // The conditions are common to all routings.
    Index rows = 0;
    for (const Part& part : parts_) rows += part.conditions.rows();
    MatrixXd conditions(rows, conditions_.cols());
    rows = 0;
    for (const Part& part : parts_) {
      conditions.middleRows(rows, part.conditions.rows()) = part.conditions;
      rows += part.conditions.rows();
    }
    const MatrixXd basis = orthonormal_basis(conditions);
    result.shared = MatrixXd::Zero(size, basis.cols());
    VectorXd of_residuals = VectorXd::Zero(basis.cols());
    result.along = VectorXd::Zero(size);
    rows = 0;
    for (const Part& part : parts_) {
      const auto own = basis.middleRows(rows, part.conditions.rows());
      result.squares.push_back(part.loadings.transpose() * part.loadings);
      result.shared.middleRows(part.first, part.loadings.cols()) = part.loadings.transpose() * own;
      of_residuals += own.transpose() * part.residuals;
      result.along.segment(part.first, part.loadings.cols()) =
          part.loadings.transpose() * part.residuals;
      rows += part.conditions.rows();
    }
    result.along -= result.shared * of_residuals;
    return result;
  }

 private:
  // The mountings of one routing, with everything taken out that they have in common.
  struct Part {
    Index first = 0;  // index of its first perturbation among all
    MatrixXd loadings;
    MatrixXd conditions;
    VectorXd residuals;
  };

  // Returns the group of the mounting's first reading.
  std::optional<std::size_t> group_of(const Mounting& mounting) const {
    const Dataset& dataset = *problem_.dataset;
    const auto first = static_cast<std::size_t>(mounting.cells.front());
    return dataset.data->readings[dataset.cells[first].reading].group;
  }

  static std::vector<Mounting> chosen(const std::vector<Mounting>& all) {
    const std::size_t count = std::min(all.size(), most_mountings);
    std::vector<Mounting> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(all[i * all.size() / count]);
    return result;
  }

  MatrixXd without_scales(MatrixXd columns) const {
    for (Index c = 0; c < columns.cols(); ++c) {
      VectorXd column = columns.col(c);
      take_out_scales(problem_, at_, column);
      columns.col(c) = column;
    }
    return columns;
  }

  void add(const std::vector<Mounting>& mountings) {
    std::vector<Index> cells;
    for (const Mounting& mounting : mountings) {
      cells.insert(cells.end(), mounting.cells.begin(), mounting.cells.end());
    }
    const auto modes = static_cast<Index>(modes_.kind.size());
    MatrixXd loadings = MatrixXd::Zero(static_cast<Index>(cells.size()),
                                       modes * static_cast<Index>(mountings.size()));
    Index row = 0;
    Index column = 0;
    for (const Mounting& mounting : mountings) {
      const MatrixXd own = loadings_(mounting.cells, Eigen::all);
      loadings.block(row, column, own.rows(), modes) = own;
      row += own.rows();
      column += modes;
      kind_.insert(kind_.end(), modes_.kind.begin(), modes_.kind.end());
    }
    const MatrixXd basis = orthonormal_basis(common_.of(cells));
    Part part{parts_.empty() ? 0 : parts_.back().first + parts_.back().loadings.cols(), {}, {}, {}};
    part.loadings = loadings - basis * (basis.transpose() * loadings);
    const MatrixXd conditions = conditions_(cells, Eigen::all);
    part.conditions = conditions - basis * (basis.transpose() * conditions);
    const VectorXd residuals = residuals_(cells);
    part.residuals = residuals - basis * (basis.transpose() * residuals);
    parts_.push_back(std::move(part));
    mounted_again_ += mountings.size() - 1;
  }

  CommonColumns common_;
  const MountingModes& modes_;
  const Problem& problem_;
  const Forecast& at_;
  VectorXd residuals_;
  MatrixXd conditions_;
  MatrixXd loadings_;
  std::vector<Part> parts_;
  std::vector<Mounted> kind_;
  std::size_t mounted_again_ = 0;
};

}  // namespace

MountedEquations mounted_equations(const Problem& problem, const Forecast& at,
                                   const MountingModes& modes) {
  return MountedComparison(problem, at, modes).equations();
}

}  // namespace reeve::diagnosis
