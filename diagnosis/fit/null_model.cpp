#include "diagnosis/fit/null_model.hpp"

#include <algorithm>
#include <utility>

#include "numerics/matrices.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

// Share of a column's length: a shorter remainder after projection is rounding.
constexpr double rounding = 1e-5;

}  // namespace

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  Eigen::MatrixXd scaled = columns;
  for (Eigen::Index c = 0; c < scaled.cols(); ++c) {
    const double size = scaled.col(c).norm();
    if (size > 0) scaled.col(c) /= size;
  }
  return orthonormal_columns(scaled, rounding);
}

Projection::Projection(const Problem& problem, const Model& model, const Forecast& at)
    : basis_(orthonormal_basis(sensitivities(problem, model, at))),
      degrees_(problem.dataset->degrees_of_freedom() - static_cast<double>(basis_.cols())) {}

void Projection::take_out(Eigen::MatrixXd& columns) const {
  if (basis_.cols() == 0) return;
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    const double before = columns.col(c).norm();
    columns.col(c) -= basis_ * (basis_.transpose() * columns.col(c));
    if (columns.col(c).norm() <= rounding * before) columns.col(c).setZero();
  }
}

Eigen::VectorXd Projection::taken_out(Eigen::VectorXd vector) const {
  if (basis_.cols() > 0) vector -= basis_ * (basis_.transpose() * vector);
  return vector;
}

void Projection::take_out_of_each(Eigen::MatrixXd& vectors) const {
  if (basis_.cols() > 0) vectors -= basis_ * (basis_.transpose() * vectors);
}

NullModel::NullModel(const Problem& problem, const Projection& projection, const Forecast& at,
                     std::uint64_t seed, std::size_t replicates, const MountedDraws* mounted)
    : problem_(problem),
      projection_(projection),
      at_(at),
      reading_(at.reading_N.cwiseQuotient(problem.deviation_N)),
      expected_(expected_readings(problem, at).cwiseQuotient(problem.deviation_N)),
      seed_(seed),
      replicates_(replicates),
      mounted_(mounted) {
  const std::vector<bool> dead = reads_zero_alone(*problem.dataset->data);
  for (const Cell& cell : problem.dataset->cells) is_dead_.push_back(dead[cell.channel]);
}

Eigen::MatrixXd NullModel::draw(std::size_t first, std::size_t count) const {
  Eigen::MatrixXd drawn(reading_.size(), static_cast<Eigen::Index>(count));
  for (std::size_t b = 0; b < count; ++b) {
    drawn.col(static_cast<Eigen::Index>(b)) = draw_one(first + b);
  }
  projection_.take_out_of_each(drawn);
  return drawn;
}

Eigen::VectorXd NullModel::draw_one(std::size_t replicate) const {
  const auto stream = static_cast<std::uint32_t>(replicate);
  const auto cells = static_cast<std::uint64_t>(reading_.size());
  Eigen::VectorXd drawn = reading_;
  if (mounted_ != nullptr) {
    drawn = mounted_->draw(seed_, stream, cells).cwiseQuotient(problem_.deviation_N);
  } else {
    add_shared_draws(problem_.shared, seed_, stream, cells, drawn);
  }
  add_motor_draws(stream, drawn);
  for (Eigen::Index i = 0; i < drawn.size(); ++i) {
    drawn[i] += normal(seed_, stream, static_cast<std::uint64_t>(i));
  }
  for (Eigen::Index i = 0; i < drawn.size(); ++i) {
    if (problem_.clips[static_cast<std::size_t>(i)]) {
      drawn[i] = std::max(0.0, drawn[i]);
    } else if (is_dead_[static_cast<std::size_t>(i)] && reading_[i] == 0) {
      drawn[i] = 0;  // a sensor that is dead in the model, too, has no noise
    }
  }
  drawn -= expected_;
  take_out_scales(problem_, at_, drawn);
  whiten(problem_.shared, drawn);
  return drawn;
}

void NullModel::add_motor_draws(std::uint32_t stream, Eigen::VectorXd& drawn) const {
  if (problem_.motor_deviation_N.size() == 0) return;
  const std::uint64_t seed = streams::seed_of_motor_tensions(seed_);
  const std::vector<DatasetRow>& rows = problem_.dataset->rows;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const DatasetRow& row = rows[r];
    if (!row.has_motor_tension) continue;
    const double change_N =
        problem_.motor_deviation_N[static_cast<Eigen::Index>(r)] * normal(seed, stream, r);
    for (std::size_t i = row.first; i < row.last; ++i) {
      const auto cell = static_cast<Eigen::Index>(i);
      drawn[cell] += change_N * at_.by_scale[cell] / problem_.deviation_N[cell];
    }
  }
}

void NullModel::for_each(
    Workers& workers, const std::function<void(std::size_t, const Eigen::MatrixXd&)>& use) const {
  constexpr std::size_t together = 16;
  workers.for_each_block(replicates_, together, [&](const IndexBlock& block) {
    use(block.begin, draw(block.begin, block.end - block.begin));
  });
}

double p_value(double observed, const std::vector<double>& replicates) {
  const auto above =
      std::ranges::count_if(replicates, [&](double value) { return value >= observed; });
  return static_cast<double>(above + 1) / static_cast<double>(replicates.size() + 1);
}

}  // namespace reeve::diagnosis
