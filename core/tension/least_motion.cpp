#include "core/tension/least_motion.hpp"

#include <algorithm>
#include <vector>

#include "numerics/matrices.hpp"

namespace reeve::core {
namespace {

// Per unit of carriage travel, of lengths and of multipliers.
constexpr double negligible = 1e-9;
constexpr double stretch_per_pull = 1e-6;
constexpr int most_changes = 1000;

// Stationary with these tendons taut.
LeastMotion with_taut(const LengthBounds& bounds, const std::vector<bool>& taut, double stretch) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < taut.size(); ++i) {
    if (taut[i]) rows.push_back(static_cast<Eigen::Index>(i));
  }
  const Eigen::Index n = bounds.cost.size();
  const auto m = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
  matrix.diagonal().head(n) = bounds.cost;
  matrix.diagonal().tail(m).setConstant(stretch);
  for (Eigen::Index r = 0; r < m; ++r) {
    matrix.row(n + r).head(n) = bounds.give.row(rows[static_cast<std::size_t>(r)]);
    matrix.col(n + r).head(n) = -bounds.give.row(rows[static_cast<std::size_t>(r)]).transpose();
    right(n + r) = bounds.motor(rows[static_cast<std::size_t>(r)]);
  }
  const Eigen::VectorXd solved = least_norm_solution(matrix, right);
  LeastMotion motion{solved.head(n), Eigen::VectorXd::Zero(bounds.motor.size()), false};
  for (Eigen::Index r = 0; r < m; ++r) {
    motion.pull(rows[static_cast<std::size_t>(r)]) = solved(n + r);
  }
  // With a stretch there is always a solution, but tensions of tendons that hold each other are
  // huge.
  motion.met = stretch > 0 || (matrix * solved - right).cwiseAbs().maxCoeff() < negligible;
  return motion;
}

// Returns false if nothing is to be exchanged.
bool exchange(const LengthBounds& bounds, const LeastMotion& motion, std::vector<bool>& taut) {
  Eigen::Index worst = 0;
  if (motion.pull.minCoeff(&worst) < -negligible * std::max(1.0, motion.pull.maxCoeff())) {
    taut[static_cast<std::size_t>(worst)] = false;
    return true;
  }
  Eigen::VectorXd room = bounds.give * motion.x - bounds.motor;
  for (std::size_t i = 0; i < taut.size(); ++i) {
    if (taut[i]) room(static_cast<Eigen::Index>(i)) = 0;
  }
  if (room.minCoeff(&worst) > -negligible) return false;
  taut[static_cast<std::size_t>(worst)] = true;
  return true;
}

LeastMotion settle(const LengthBounds& bounds, std::vector<bool>& taut, double stretch) {
  LeastMotion motion = with_taut(bounds, taut, stretch);
  for (int change = 0; motion.met && exchange(bounds, motion, taut); ++change) {
    motion = with_taut(bounds, taut, stretch);
    motion.met &= change < most_changes;
  }
  return motion;
}

}  // namespace

LeastMotion least_motion(const LengthBounds& bounds) {
  std::vector<bool> taut(static_cast<std::size_t>(bounds.motor.size()), true);
  settle(bounds, taut, stretch_per_pull);
  return settle(bounds, taut, 0);
}

}  // namespace reeve::core
