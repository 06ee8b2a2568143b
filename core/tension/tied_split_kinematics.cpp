#include "core/tension/tied_split_kinematics.hpp"

#include <algorithm>

#include "core/tension/tree_kinematics.hpp"
#include "numerics/matrices.hpp"

namespace reeve::core {
namespace {

// Per unit of carriage travel, of lengths and of multipliers.
constexpr double negligible = 1e-9;
constexpr int most_changes = 1000;

// Give · (dl, z) >= motor, one row for each tendon.
struct Constraints {
  Eigen::MatrixXd give;
  Eigen::VectorXd motor;
  Eigen::VectorXd cost;  // 1 / w of a finger that closes, 0 for a block
};

struct Settled {
  Eigen::VectorXd x;
  Eigen::VectorXd multiplier;  // one per tendon
  bool met = false;
};

Constraints constraints(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  const auto fingers = static_cast<Eigen::Index>(network.fingers);
  const auto rows = static_cast<Eigen::Index>(network.tendons.size());
  const auto columns = fingers + static_cast<Eigen::Index>(network.blocks.size());
  Constraints result{Eigen::MatrixXd::Zero(rows, columns), Eigen::VectorXd::Zero(rows),
                     Eigen::VectorXd::Zero(columns)};
  for (Eigen::Index f = 0; f < fingers; ++f) {
    result.cost(f) = 1 / mechanics.closing[static_cast<std::size_t>(f)];
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const TendonSpan& tendon = network.tendons[static_cast<std::size_t>(row)];
    for_each_term(
        network, mechanics, tendon, grasp, [&](double length) { result.motor(row) += length; },
        [&](int finger, double factor) { result.give(row, finger - 1) += factor; },
        [&](std::size_t block, double factor) {
          result.give(row, fingers + static_cast<Eigen::Index>(block)) -= factor;
        });
  }
  return result;
}

// Stationary with the active tendons tight.
Settled with_active(const Constraints& c, const std::vector<bool>& active) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i]) rows.push_back(static_cast<Eigen::Index>(i));
  }
  const Eigen::Index n = c.cost.size();
  const auto m = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
  matrix.diagonal().head(n) = c.cost;
  for (Eigen::Index r = 0; r < m; ++r) {
    matrix.row(n + r).head(n) = c.give.row(rows[static_cast<std::size_t>(r)]);
    matrix.col(n + r).head(n) = -c.give.row(rows[static_cast<std::size_t>(r)]).transpose();
    right(n + r) = c.motor(rows[static_cast<std::size_t>(r)]);
  }
  const Eigen::VectorXd solved = least_norm_solution(matrix, right);
  Settled settled{solved.head(n), Eigen::VectorXd::Zero(c.motor.size()), false};
  for (Eigen::Index r = 0; r < m; ++r) {
    settled.multiplier(rows[static_cast<std::size_t>(r)]) = solved(n + r);
  }
  settled.met = (matrix * solved - right).cwiseAbs().maxCoeff() < negligible;
  return settled;
}

Settled settle(const Constraints& c) {
  std::vector<bool> active(static_cast<std::size_t>(c.motor.size()), true);
  Settled settled = with_active(c, active);
  for (int change = 0; change < most_changes; ++change) {
    Eigen::Index worst = 0;
    if (settled.multiplier.minCoeff(&worst) < -negligible) {
      active[static_cast<std::size_t>(worst)] = false;
    } else if ((c.give * settled.x - c.motor).minCoeff(&worst) < -negligible) {
      if (active[static_cast<std::size_t>(worst)]) return settled;  // cannot be met
      active[static_cast<std::size_t>(worst)] = true;
    } else {
      return settled;
    }
    settled = with_active(c, active);
  }
  settled.met = false;
  return settled;
}

// The tendons of one tree without the others, which then ask for nothing.
Constraints only_tree(const Network& network, Constraints c, std::size_t tree) {
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    if (network.tendons[t].tree == tree) continue;
    c.give.row(static_cast<Eigen::Index>(t)).setZero();
    c.motor(static_cast<Eigen::Index>(t)) = 0;
  }
  return c;
}

// Trees that cannot give way even alone block the carriage; if none is such a one, all do together.
void find_jams(const Network& network, const Constraints& c, SplitClosing& result) {
  const std::size_t n = network.tendons.size();
  result.jams.assign(n, 0);
  result.slack.assign(n, 0);
  for (std::size_t t = 0; t < n; ++t) {
    const std::size_t tree = network.tendons[t].tree;
    result.jams[t] = settle(only_tree(network, c, tree)).met ? 0 : 1;
  }
  if (std::find(result.jams.begin(), result.jams.end(), 1) == result.jams.end()) {
    result.jams.assign(n, 1);
  }
}

}  // namespace

SplitClosing tied_split_closing(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  const Constraints c = constraints(network, mechanics, grasp);
  const Settled settled = settle(c);
  SplitClosing result;
  result.closing.assign(static_cast<std::size_t>(network.fingers), 0.0);
  result.block_travel.assign(network.blocks.size(), 0.0);
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const auto row = static_cast<Eigen::Index>(t);
    const bool pulls = settled.multiplier(row) > negligible;
    result.slack.push_back(pulls ? 0 : 1);
    result.jams.push_back(0);
  }
  if (!settled.met) {
    find_jams(network, c, result);
    return result;
  }
  for (std::size_t f = 0; f < result.closing.size(); ++f) {
    const bool held = grasp.holds(static_cast<int>(f) + 1);
    result.closing[f] = held ? 0 : settled.x(static_cast<Eigen::Index>(f));
  }
  for (std::size_t b = 0; b < result.block_travel.size(); ++b) {
    result.block_travel[b] = settled.x(static_cast<Eigen::Index>(result.closing.size() + b));
  }
  return result;
}

}  // namespace reeve::core
