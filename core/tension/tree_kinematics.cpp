#include "core/tension/tree_kinematics.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace reeve::core {
namespace {

// Of lengths of order one, sums of a few tens of terms.
constexpr double length_tolerance = 1e-9;

// One row for each tendon, one column for each block and each closing finger of the tree.
struct Equations {
  Eigen::MatrixXd blocks;    // take-up for each block's z
  Eigen::MatrixXd closings;  // giving up, for each finger's dl
  Eigen::VectorXd motor;     // motor-side lengths
  std::vector<std::size_t> block;
  std::vector<int> finger;
};

std::vector<const TendonSpan*> tendons_of(const Network& network, std::size_t tree) {
  std::vector<const TendonSpan*> tendons;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree == tree) tendons.push_back(&tendon);
  }
  return tendons;
}

template <typename Thing>
Eigen::Index column(std::vector<Thing>& columns, Thing thing) {
  const auto found = std::find(columns.begin(), columns.end(), thing);
  if (found != columns.end()) return found - columns.begin();
  columns.push_back(thing);
  return static_cast<Eigen::Index>(columns.size()) - 1;
}

Equations equations(const Network& network, Grasp grasp,
                    const std::vector<const TendonSpan*>& tendons) {
  Equations result;
  const auto closes = [&](const Segment& segment) {
    return segment.kind == SegmentKind::strand && !grasp.holds(segment.finger);
  };
  for (const TendonSpan* tendon : tendons) {
    for_each_pull(network, *tendon,
                  [&](std::size_t, std::size_t block, double) { column(result.block, block); });
    for (std::size_t i = 0; i < tendon->segments; ++i) {
      const Segment& segment = network.segments[tendon->first_segment + i];
      if (closes(segment)) column(result.finger, segment.finger);
    }
  }
  const auto rows = static_cast<Eigen::Index>(tendons.size());
  result.blocks.setZero(rows, static_cast<Eigen::Index>(result.block.size()));
  result.closings.setZero(rows, static_cast<Eigen::Index>(result.finger.size()));
  result.motor.setZero(rows);
  std::vector<double> weight(network.segments.size(), 0);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const TendonSpan& tendon = *tendons[static_cast<std::size_t>(row)];
    for_each_weighted_segment(network, tendon, [&](std::size_t i, double of_segment) {
      weight[i] = of_segment;
      const Segment& segment = network.segments[i];
      if (segment.kind == SegmentKind::motor_side) result.motor(row) += of_segment;
      if (closes(segment))
        result.closings(row, column(result.finger, segment.finger)) += of_segment;
    });
    for_each_pull(network, tendon, [&](std::size_t i, std::size_t block, double sign) {
      result.blocks(row, column(result.block, block)) += sign * weight[i];
    });
  }
  return result;
}

struct Solved {
  bool exact = false;
  bool unique = false;
  Eigen::VectorXd blocks;
  Eigen::VectorXd closings;
};

// All closing fingers share one dl.
Solved with_one_closing(const Equations& e, const Eigen::VectorXd& weights) {
  const Eigen::Index m = e.blocks.cols();
  Eigen::MatrixXd matrix(e.blocks.rows(), m + 1);
  matrix << e.blocks, -e.closings * weights;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  const Eigen::VectorXd x = qr.solve(-e.motor);
  const double miss = (matrix * x + e.motor).cwiseAbs().maxCoeff();
  return {miss < length_tolerance, qr.rank() == m + 1, x.head(m), weights * x(m)};
}

// The closings as equal as the tendons let them: the conditions of a stationary variance.
Solved with_equal_closings(const Equations& e, const Eigen::VectorXd& weights) {
  const Eigen::Index m = e.blocks.cols();
  const Eigen::Index f = e.closings.cols();
  const Eigen::Index n = e.blocks.rows();
  const Eigen::Index common = m + f;  // the dl that all would share
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(common + 1 + n, common + 1 + n);
  for (Eigen::Index i = 0; i < f; ++i) {
    matrix(m + i, m + i) = 1 / weights(i);
    matrix(m + i, common) = matrix(common, m + i) = -1;
    matrix(common, common) += weights(i);
  }
  Eigen::MatrixXd constraints = Eigen::MatrixXd::Zero(n, common + 1);
  constraints.leftCols(m) = e.blocks;
  constraints.middleCols(m, f) = -e.closings;
  matrix.bottomLeftCorner(n, common + 1) = constraints;
  matrix.topRightCorner(common + 1, n) = constraints.transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.rows());
  right.tail(n) = -e.motor;
  const Eigen::VectorXd x = matrix.completeOrthogonalDecomposition().solve(right);
  const double miss = (constraints * x.head(common + 1) + e.motor).cwiseAbs().maxCoeff();
  const bool unique = e.blocks.colPivHouseholderQr().rank() == m;
  return {miss < length_tolerance, unique, x.head(m), x.segment(m, f)};
}

}  // namespace

TreeState solve_tree_kinematics(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                std::size_t tree, std::vector<double>& closing,
                                std::vector<double>& block_travel) {
  const Equations e = equations(network, grasp, tendons_of(network, tree));
  for (const std::size_t block : e.block) block_travel[block] = 0;
  if (e.finger.empty()) return TreeState::jams;
  Eigen::VectorXd weights(static_cast<Eigen::Index>(e.finger.size()));
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    weights(i) =
        mechanics.closing[static_cast<std::size_t>(e.finger[static_cast<std::size_t>(i)]) - 1];
  }
  Solved solved = with_one_closing(e, weights);
  if (!solved.exact) solved = with_equal_closings(e, weights);
  if (!solved.exact) return TreeState::jams;
  if (!solved.unique || solved.closings.minCoeff() < -length_tolerance) {
    return TreeState::undetermined;
  }
  for (std::size_t i = 0; i < e.block.size(); ++i) {
    block_travel[e.block[i]] = solved.blocks(static_cast<Eigen::Index>(i));
  }
  for (std::size_t i = 0; i < e.finger.size(); ++i) {
    const double dl = solved.closings(static_cast<Eigen::Index>(i));
    closing[static_cast<std::size_t>(e.finger[i]) - 1] = std::max(dl, 0.0);
  }
  return TreeState::moves;
}

}  // namespace reeve::core
