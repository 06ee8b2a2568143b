#include "tests/support/reference_motion.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

namespace reeve::testing::reference {

namespace {

constexpr Real rank_tolerance = 1e-13L;

struct FingerOpens : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

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

bool all_equal(const Motion& found, const std::map<int, Real>& weights) {
  Real least = 1e9L, most = -1e9L;
  for (const auto& [finger, w] : weights) {
    least = std::min(least, found.closing.at(finger) / w);
    most = std::max(most, found.closing.at(finger) / w);
  }
  return weights.empty() || most - least <= 1e-11L * (1 + most);
}

Motion all_taut(const Constraints& k, Index blocks, bool lets_out,
                const std::map<int, Real>& weights) {
  Motion found;
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
      throw FingerOpens("the reference model: finger " + std::to_string(finger) +
                        " would have to open");
    found.closing[finger] = w * std::max(x(at++), Real(0));
  }
  return found;
}

std::vector<Index> members_of(std::size_t set, Index tendons) {
  std::vector<Index> members;
  for (Index t = 0; t < tendons; ++t)
    if ((set >> t & 1U) != 0) members.push_back(t);
  return members;
}

// The tendons that the greatest common closing needs; nothing if the tree jams.
std::optional<std::vector<bool>> needed(const Constraints& k, Index blocks) {
  const Index n = k.rows.rows();
  const Vector takes = -k.rows.rightCols(k.rows.cols() - blocks).rowwise().sum();
  std::vector<bool> taut(static_cast<std::size_t>(n), false);
  Real greatest = 0;
  for (std::size_t set = 1; set < std::size_t{1} << n; ++set) {
    const std::vector<Index> members = members_of(set, n);
    const Matrix balance = k.rows.leftCols(blocks)(members, Eigen::all).transpose();
    Eigen::FullPivLU<Matrix> factor(balance);
    factor.setThreshold(rank_tolerance);
    if (factor.dimensionOfKernel() != 1) continue;
    Vector pull = factor.kernel().col(0);
    if (!(pull.maxCoeff() > 0)) pull = -pull;
    pull /= pull.maxCoeff();
    if (!(pull.minCoeff() > 1e-12L)) continue;
    const Real asked = -pull.dot(k.travel(members)), given = pull.dot(takes(members));
    if (given < 1e-12L && asked > 1e-12L) return std::nullopt;
    if (given < 1e-12L || asked / given < 1e-12L) continue;
    if (asked / given < greatest - 1e-12L) continue;
    if (asked / given > greatest + 1e-12L) taut.assign(taut.size(), false);
    greatest = std::max(greatest, asked / given);
    for (const Index t : members) taut[static_cast<std::size_t>(t)] = true;
  }
  return taut;
}

// Only the rows of taut tendons, and only the fingers on them.
struct TautPart {
  Constraints rows;
  std::map<int, Real> weights;
};

TautPart taut_part(const Constraints& k, Index blocks, const std::map<int, Real>& weights,
                   const std::vector<bool>& taut) {
  std::vector<Index> tendons, columns(static_cast<std::size_t>(blocks));
  std::iota(columns.begin(), columns.end(), Index{0});
  for (std::size_t t = 0; t < taut.size(); ++t)
    if (taut[t]) tendons.push_back(static_cast<Index>(t));
  TautPart part;
  Index at = blocks;
  for (const auto& [finger, w] : weights) {
    if (!k.rows.col(at)(tendons).isZero(0)) {
      columns.push_back(at);
      part.weights[finger] = w;
    }
    ++at;
  }
  part.rows = {k.rows(tendons, columns), k.travel(tendons)};
  return part;
}

// The rows of slack tendons, without what the others already move.
Constraints rest_of(const Constraints& k, Index blocks, const std::map<int, Real>& weights,
                    const TautPart& part, const Motion& found, const std::vector<bool>& taut) {
  Constraints rest = k;
  const auto move = [&](Index column, Real by) {
    rest.travel -= rest.rows.col(column) * by;
    rest.rows.col(column).setZero();
  };
  for (Index b = 0; b < blocks; ++b)
    if (!part.rows.rows.col(b).isZero(0)) move(b, found.z(b));
  Index at = blocks;
  for (const auto& [finger, w] : weights) {
    if (part.weights.contains(finger)) move(at, found.closing.at(finger) / w);
    ++at;
  }
  for (std::size_t t = 0; t < taut.size(); ++t) {
    if (!taut[t]) continue;
    rest.rows.row(static_cast<Index>(t)).setZero();
    rest.travel(static_cast<Index>(t)) = 0;
  }
  return rest;
}

// Blocks on no taut tendon stay where they are.
Motion free_blocks_rest(const TautPart& part, Index blocks, bool lets_out) {
  std::vector<Index> tied, columns;
  for (Index b = 0; b < blocks; ++b)
    if (!part.rows.rows.col(b).isZero(0)) tied.push_back(b);
  columns = tied;
  for (Index at = blocks; at < part.rows.rows.cols(); ++at) columns.push_back(at);
  Motion found = all_taut({part.rows.rows(Eigen::all, columns), part.rows.travel},
                          static_cast<Index>(tied.size()), lets_out, part.weights);
  if (!found.possible) throw std::logic_error("the reference model: taut tendons do not fit");
  Vector z = Vector::Zero(blocks);
  z(tied) = found.z;
  found.z = z;
  return found;
}

Motion with_slack(const Constraints& k, Index blocks, bool lets_out,
                  const std::map<int, Real>& weights) {
  std::vector<bool> taut(static_cast<std::size_t>(k.rows.rows()), false);
  Motion found{true, {}, Vector::Zero(blocks)};
  while (true) {
    const TautPart part = taut_part(k, blocks, weights, taut);
    if (part.rows.rows.rows() > 0) found = free_blocks_rest(part, blocks, lets_out);
    const auto more = needed(rest_of(k, blocks, weights, part, found, taut), blocks);
    if (!more && part.rows.rows.rows() == 0) return {};
    if (!more) throw std::logic_error("the reference model: slack tendons do not fit");
    if (std::find(more->begin(), more->end(), true) == more->end()) break;
    for (std::size_t t = 0; t < taut.size(); ++t) taut[t] = taut[t] || (*more)[t];
  }
  found.slack = taut;
  found.slack.flip();
  for (const auto& [finger, w] : weights) found.closing.emplace(finger, Real(0));
  return found;
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
  if (blocks == 0) return all_taut(k, blocks, lets_out, weights);
  try {
    found = all_taut(k, blocks, lets_out, weights);
    if (found.possible && all_equal(found, weights)) return found;
  } catch (const FingerOpens&) {  // some tendons may be slack
  }
  found = with_slack(k, blocks, lets_out, weights);
  if (!(tree.motor.maxCoeff() > 0) && !weights.empty())
    throw FingerOpens("the reference model: a tree is let out");
  return found;
}

}  // namespace reeve::testing::reference
