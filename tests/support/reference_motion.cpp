#include "tests/support/reference_motion.hpp"

#include <Eigen/Dense>

#include <cstddef>
#include <stdexcept>

namespace reeve::testing::reference {

namespace {

constexpr Real rank_tolerance = 1e-13L;

// One row for each tendon; columns: z of each block, then q of each closing finger.
struct Constraints {
  Matrix rows;
  Vector travel;
};

Constraints constraints(const Tree& tree, const std::map<int, Real>& weights) {
  const Index blocks = tree.hangs.cols();
  const auto tendons = static_cast<Index>(tree.spans.size());
  Constraints found{Matrix::Zero(tendons, blocks + static_cast<Index>(weights.size())),
                    Vector::Zero(tendons)};
  for (Index t = 0; t < tendons; ++t) {
    const Span& span = tree.spans[static_cast<std::size_t>(t)];
    for (Index i = span.segment; i < span.segment + span.segments; ++i) {
      found.rows.row(t).head(blocks) += tree.c(i) * tree.hangs.row(i);
      found.travel(t) -= tree.c(i) * tree.motor(i);
      const auto finger = weights.find(tree.finger[static_cast<std::size_t>(i)]);
      if (finger == weights.end()) continue;
      const auto column = static_cast<Index>(std::distance(weights.begin(), finger));
      found.rows(t, blocks + column) -= tree.c(i) * finger->second;
    }
  }
  return found;
}

// Of sum_f w_f (q_f - mean)^2, as a quadratic form in all the unknowns.
Matrix variance(Index blocks, const std::map<int, Real>& weights) {
  Vector w(static_cast<Index>(weights.size()));
  Index at = 0;
  for (const auto& [finger, value] : weights) w(at++) = value;
  Matrix form = Matrix::Zero(blocks + w.size(), blocks + w.size());
  form.bottomRightCorner(w.size(), w.size()) = w.asDiagonal();
  form.bottomRightCorner(w.size(), w.size()) -= w * w.transpose() / w.sum();
  return form;
}

bool solves(const Constraints& k, const Vector& x) {
  const Vector size = k.rows.cwiseAbs() * x.cwiseAbs() + k.travel.cwiseAbs();
  return ((k.rows * x - k.travel).array().abs() <= 1e-12L * (1 + size.array())).all();
}

// Moves x along the constraints to where the variance is least.
Vector most_equal(const Vector& x, const Matrix& along, const Matrix& form) {
  const Matrix reduced = along.transpose() * form * along;
  Eigen::FullPivLU<Matrix> factor(reduced);
  factor.setThreshold(rank_tolerance);
  if (factor.rank() < reduced.rows())
    throw std::invalid_argument("the reference model: the motion is not determined");
  return x - along * factor.solve(along.transpose() * form * x);
}

}  // namespace

Motion motion(const Tree& tree, const std::map<int, Real>& weights) {
  Motion found;
  const Index blocks = tree.hangs.cols();
  const bool lets_out = tree.motor.minCoeff() < 0;
  if (tree.motor.isZero(0)) {
    found.possible = true;
    found.z = Vector::Zero(blocks);
    return found;
  }
  if (weights.empty() && !lets_out) return found;
  const Constraints k = constraints(tree, weights);
  if (k.rows.cols() == 0) {  // a tendon alone, whose fingers are held
    if (tree.motor.sum() < 0)
      throw std::invalid_argument("the reference model: a tendon is let out");
    found.possible = tree.motor.sum() == 0;
    return found;
  }
  Eigen::FullPivLU<Matrix> factor(k.rows);
  factor.setThreshold(rank_tolerance);
  Vector x = factor.solve(k.travel);
  if (!solves(k, x)) return found;
  if (factor.dimensionOfKernel() > 0) x = most_equal(x, factor.kernel(), variance(blocks, weights));
  const Real greatest = weights.empty() ? 0 : x.tail(x.size() - blocks).cwiseAbs().maxCoeff();
  if (!lets_out && !(greatest > 1e-12L))
    throw std::invalid_argument("the reference model: the carriage moves no finger");
  found.possible = true;
  found.z = x.head(blocks);
  Index at = blocks;
  for (const auto& [finger, w] : weights) {
    if (x(at) < -1e-12L * (lets_out ? 1 + greatest : greatest))
      throw std::invalid_argument("the reference model: finger " + std::to_string(finger) +
                                  " would have to open");
    found.closing[finger] = w * std::max(x(at++), Real(0));
  }
  return found;
}

}  // namespace reeve::testing::reference
