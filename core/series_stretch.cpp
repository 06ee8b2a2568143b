#include "core/series_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "core/hand_pulls.hpp"
#include "core/motor_sides.hpp"
#include "core/tension/tension.hpp"
#include "core/tension/tree_kinematics.hpp"
#include "numerics/matrices.hpp"

namespace reeve::core {
namespace {

constexpr double mJ_in_J = 1000;
constexpr double tolerance = 1e-9;

// A grasp, and its state at a motor tension of 1 N.
struct Pull {
  const Network& network;
  const Mechanics& mechanics;
  const Grasp& grasp;
  const TensionState& state;

  double stretch_mm_N(std::size_t segment) const {
    return state.tension[segment] * mechanics.springs_mm[segment] / mechanics.EA_N;
  }
  double travel(std::size_t segment) const {
    const bool is_end = network.segments[segment].kind == SegmentKind::motor_side;
    return is_end ? end_travel(network, mechanics, grasp, segment) : 0;
  }
};

// Equations of a tree whose fingers stand, one row for each tendon: the carriage, then each block.
struct StandingTree {
  Eigen::MatrixXd travels;
  Eigen::VectorXd stretches;  // of springs, mm/N
  double stored_mJ_N2 = 0;
};

StandingTree standing_tree(const Pull& pull, std::size_t tree) {
  const Network& network = pull.network;
  StandingTree result;
  const auto tendons = static_cast<Eigen::Index>(network.tendons.size());
  const auto blocks = static_cast<Eigen::Index>(network.blocks.size());
  result.travels = Eigen::MatrixXd::Zero(tendons, 1 + blocks);
  result.stretches = Eigen::VectorXd::Zero(tendons);
  for (Eigen::Index row = 0; row < tendons; ++row) {
    const TendonSpan& tendon = network.tendons[static_cast<std::size_t>(row)];
    if (tendon.tree != tree) continue;
    for_each_weighted_segment(network, tendon, [&](std::size_t i, double weight) {
      result.travels(row, 0) += weight * pull.travel(i);
      result.stretches(row) += weight * pull.stretch_mm_N(i);
      result.stored_mJ_N2 += pull.state.tension[i] * pull.stretch_mm_N(i) / 2;
    });
    for_each_pull(network, tendon, [&](std::size_t, std::size_t block, double sign, double weight) {
      result.travels(row, 1 + static_cast<Eigen::Index>(block)) += sign * weight;
    });
  }
  return result;
}

// Adds the tendon's contacts with friction that slide as its spring stretches.
void add_slips(const Pull& pull, const TendonSpan& tendon, const Eigen::VectorXd& travel,
               SeriesStretch& stretch) {
  std::vector<double> imposed(pull.network.segments.size(), 0.0);
  for_each_pull(pull.network, tendon, [&](std::size_t i, std::size_t block, double sign, double) {
    imposed[i] += sign * travel(1 + static_cast<Eigen::Index>(block));
  });
  double slip = 0;
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    const std::size_t i = tendon.first_segment + k;
    const std::size_t contact = tendon.first_contact + k;
    slip -= imposed[i] + pull.travel(i) * travel(0) - pull.stretch_mm_N(i);
    if (pull.network.contacts[contact].kind == ContactKind::bar) {
      slip /= behind_bar(pull.network, pull.network.contacts[contact]);
    } else if (std::abs(slip) > tolerance * travel(0) && pull.mechanics.phi[contact] > 0) {
      const double on_the_way = pull.state.slip[contact];
      stretch.is_lossless = false;
      if (on_the_way != 0)
        stretch.sliding_mm_N = std::max(stretch.sliding_mm_N, -slip / on_the_way);
      // The tendon that goes round a loop depends on the way.
      if (tendon.closed) stretch.is_known = false;
    }
  }
}

SeriesStretch stretch_of(const Pull& pull, std::size_t root) {
  const StandingTree tree = standing_tree(pull, root);
  SeriesStretch result{.stored_mJ_N2 = tree.stored_mJ_N2};
  if (tree.stretches.isZero(0)) return result;
  const Eigen::VectorXd travel = least_norm_solution(tree.travels, tree.stretches);
  const double miss = (tree.travels * travel - tree.stretches).cwiseAbs().maxCoeff();
  const Eigen::MatrixXd blocks = tree.travels.rightCols(tree.travels.cols() - 1);
  result.travel_mm_N = travel(0);
  const Eigen::Index rank_of_blocks = blocks.size() > 0 ? column_rank(blocks) : 0;
  result.is_known = miss <= tolerance * tree.stretches.cwiseAbs().maxCoeff() &&
                    column_rank(tree.travels) > rank_of_blocks;
  for (const TendonSpan& tendon : pull.network.tendons) {
    if (tendon.tree == root) add_slips(pull, tendon, travel, result);
  }
  return result;
}

}  // namespace

double SeriesStretch::stored_J(double motor_N) const {
  return stored_mJ_N2 * motor_N * motor_N / mJ_in_J;
}

double SeriesStretch::work_J(double motor_N) const {
  return is_lossless ? stored_J(motor_N) : motor_N * travel_mm(motor_N) / mJ_in_J;
}

bool shares_slack(const Network& network, const Mechanics& mechanics) {
  if (mechanics.slack_mm.empty()) return false;
  std::size_t trees = 0;
  for (std::size_t t = 0; t < network.tendons.size(); ++t) trees += network.tendons[t].tree == t;
  return trees > motor_groups(network).count;
}

SeriesStretch greatest(const SeriesStretch& one, const SeriesStretch& other) {
  SeriesStretch result = one.travel_mm_N < other.travel_mm_N ? other : one;
  result.is_known = one.is_known && other.is_known;
  result.is_lossless = one.is_lossless && other.is_lossless;
  result.sliding_mm_N = std::max(one.sliding_mm_N, other.sliding_mm_N);
  result.most_N = std::min(one.most_N, other.most_N);
  return result;
}

bool is_counted(const SeriesStretch& stretch, double closure, double motor_N) {
  return stretch.is_known && closure == 1 && std::isfinite(motor_N) && motor_N <= stretch.most_N;
}

SeriesStretch series_stretch(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
                             const TensionState& state) {
  if (mechanics.springs_mm.empty()) return {};
  const bool is_seized = std::ranges::find(mechanics.decay, 0.0) != mechanics.decay.end();
  const bool is_unlike = network.shared || carriage_count(network) > 1;
  if (is_seized || is_unlike || shares_slack(network, mechanics)) return {.is_known = false};
  SeriesStretch all;
  for (std::size_t tree = 0; tree < network.tendons.size(); ++tree) {
    if (network.tendons[tree].tree != tree) continue;
    const SeriesStretch own = stretch_of({network, mechanics, grasp, state}, tree);
    const double stored = all.stored_mJ_N2 + own.stored_mJ_N2;
    all = greatest(all, own);
    all.stored_mJ_N2 = stored;
    all.is_lossless &= tree == 0;
  }
  return all;
}

}  // namespace reeve::core
