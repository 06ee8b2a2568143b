#include "diagnosis/fit/whitening.hpp"

#include <algorithm>
#include <utility>

#include "numerics/matrices.hpp"
#include "numerics/random.hpp"

namespace reeve::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Without the things that change nothing here, such as contacts of other routings.
MatrixXd acting_columns(const MatrixXd& columns) {
  std::vector<Index> acting;
  for (Index c = 0; c < columns.cols(); ++c) {
    if (!columns.col(c).isZero(0)) acting.push_back(c);
  }
  return columns(Eigen::all, acting);
}

}  // namespace

SharedScatter shared_scatter(std::vector<Index> cells, MatrixXd loadings, const MatrixXd& seen) {
  // Smallest S², in units of the readings' own noise variance. An axis that scatters less is left
  // out.
  constexpr double least = 1e-6;
  SharedScatter result{std::move(cells), {}, {}, std::move(loadings)};
  const MatrixXd acting = acting_columns(seen);
  if (acting.cols() == 0) {
    result.axes.resize(seen.rows(), 0);
    return result;
  }
  // Few readings of many things are decomposed by the readings.
  const bool by_cells = acting.rows() < acting.cols();
  const SymmetricAxes across = symmetric_axes(by_cells ? MatrixXd(acting * acting.transpose())
                                                       : MatrixXd(acting.transpose() * acting));
  const VectorXd& squares = across.values;  // S², ascending
  const Index all = squares.size();
  Index used = 0;
  while (used < all && squares[all - 1 - used] > least) ++used;
  const VectorXd kept = squares.tail(used);
  result.axes = across.vectors.rightCols(used);
  if (!by_cells) result.axes = acting * result.axes * kept.cwiseSqrt().cwiseInverse().asDiagonal();
  result.shrunk = 1 - (1 + kept.array()).rsqrt();
  return result;
}

void whiten(const Whitening& whitening, Eigen::Ref<MatrixXd> columns) {
  for (const SharedScatter& shared : whitening) {
    if (shared.shrunk.size() == 0) continue;
    MatrixXd own(static_cast<Index>(shared.cells.size()), columns.cols());
    for (Index i = 0; i < own.rows(); ++i) {
      own.row(i) = columns.row(shared.cells[static_cast<std::size_t>(i)]);
    }
    const MatrixXd along = shared.shrunk.asDiagonal() * (shared.axes.transpose() * own);
    own.noalias() -= shared.axes * along;
    for (Index i = 0; i < own.rows(); ++i) {
      columns.row(shared.cells[static_cast<std::size_t>(i)]) = own.row(i);
    }
  }
}

void add_shared_draws(const Whitening& whitening, std::uint64_t seed, std::uint32_t stream,
                      std::uint64_t first, VectorXd& readings) {
  for (const SharedScatter& shared : whitening) {
    VectorXd z(shared.loadings.cols());
    for (Index k = 0; k < z.size(); ++k) z[k] = normal(seed, stream, first++);
    const VectorXd change = shared.loadings * z;
    for (std::size_t i = 0; i < shared.cells.size(); ++i) {
      readings[shared.cells[i]] += change[static_cast<Index>(i)];
    }
  }
}

}  // namespace reeve::diagnosis
