#include "core/tension/tree_kinematics.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <array>

#include "core/tension/least_motion.hpp"
#include "numerics/matrices.hpp"

namespace reeve::core {
namespace {

// Tolerance of lengths of order one, sums of a few tens of terms.
constexpr double length_tolerance = 1e-9;

double closing_weight(const Mechanics& mechanics, int finger) {
  return mechanics.closing[static_cast<std::size_t>(finger) - 1];
}

// 1, or −1 for a finger that the tree can only open.
double way_of(const Network& network, std::size_t tree, int finger) {
  if (!network.shared) return 1;
  const auto closes_it = [&](const TendonSpan& tendon) {
    const auto* const first = network.segments.data() + tendon.first_segment;
    return tendon.tree == tree &&
           std::any_of(first, first + tendon.segments, [&](const Segment& segment) {
             return segment.finger == finger && !segment.extensor;
           });
  };
  return std::any_of(network.tendons.begin(), network.tendons.end(), closes_it) ? 1 : -1;
}

// The tendons and blocks of a tree as rows and columns of equations, in the order of the network.
struct TreeColumns {
  Eigen::Index tendons = 0;
  Eigen::Index blocks = 0;
  std::array<Eigen::Index, block_keys> of_block{};

  TreeColumns(const Network& network, std::size_t tree) {
    of_block.fill(-1);
    for (const TendonSpan& tendon : network.tendons) {
      if (tendon.tree != tree) continue;
      ++tendons;
      for_each_pull(network, tendon, [&](std::size_t, std::size_t block, double, double) {
        if (of_block[block] < 0) of_block[block] = blocks++;
      });
    }
  }
};

// One row for each tendon: take-ups for each block's z, what the closing fingers give up for one
// common dl, and the motor-side lengths. At most `Most` tendons or blocks; small ones need no
// memory from the heap.
template <int Most>
struct CommonClosing {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Most, Most>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Most, 1>;

  bool drives = false;  // some carriage pulls
  bool lets_out = false;
  bool closes = false;    // some finger
  bool has_room = false;  // though it moves no finger
  bool exact = false;
  bool unique = false;
  Vector blocks;
  double closing = 0;

  CommonClosing(const Network& network, const Mechanics& mechanics, Grasp grasp, std::size_t tree,
                const std::vector<double>& given, const TreeColumns& columns) {
    Matrix matrix = Matrix::Zero(columns.tendons, columns.blocks + 1);
    Vector motor = Vector::Zero(columns.tendons);
    Eigen::Index row = 0;
    for (const TendonSpan& tendon : network.tendons) {
      if (tendon.tree != tree) continue;
      for_each_term(
          network, mechanics, tendon, grasp,
          [&](double length) {
            motor(row) += length;
            (length < 0 ? lets_out : drives) |= length != 0;
          },
          [&](int finger, double factor) {
            closes = true;
            matrix(row, columns.blocks) -=
                factor * way_of(network, tree, finger) * closing_weight(mechanics, finger);
            if (!given.empty()) motor(row) -= factor * given[static_cast<std::size_t>(finger) - 1];
          },
          [&](std::size_t block, double factor) {
            matrix(row, columns.of_block[block]) += factor;
          });
      ++row;
    }
    if (network.shared && columns.blocks == 0 && matrix.isZero(0)) {
      closes = lets_out = false;
      drives = motor(0) > length_tolerance;
      has_room = motor(0) < -length_tolerance;
    }
    if (stands_still(network)) return;
    const Eigen::ColPivHouseholderQR<Matrix> qr(matrix);
    const Vector x = qr.solve(-motor);
    exact = (matrix * x + motor).cwiseAbs().maxCoeff() < length_tolerance;
    unique = qr.rank() == columns.blocks + (closes ? 1 : 0);
    blocks = x.head(columns.blocks);
    closing = x(columns.blocks);
  }

  // A tree that only lets out stands still if other trees share the fingers that it would open.
  bool stands_still(const Network& network) const {
    return !closes && (!lets_out || (network.shared && !drives));
  }
};

TreeState undetermined(TensionFault fault) { return {.fault = fault}; }

struct TreeMotion {
  TreeState state{.jams = true};
  std::vector<double> blocks;    // travels, by column
  std::vector<double> closings;  // closings of fingers 1 … n
};

// The closings as equal as the tendons let them: the conditions of a stationary variance.
TreeMotion nearly_common_closing(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                 std::size_t tree, const TreeColumns& columns) {
  const Eigen::Index m = columns.blocks;
  const Eigen::Index f = network.fingers;
  const Eigen::Index n = columns.tendons;
  const Eigen::Index common = m + f;  // the dl that all would share
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(common + 1 + n, common + 1 + n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(common + 1 + n);
  std::vector<bool> free(static_cast<std::size_t>(f), false);
  Eigen::Index row = common + 1;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != tree) continue;
    for_each_term(
        network, mechanics, tendon, grasp, [&](double length) { right(row) -= length; },
        [&](int finger, double factor) {
          free[static_cast<std::size_t>(finger) - 1] = true;
          matrix(row, m + finger - 1) -= factor;
        },
        [&](std::size_t block, double factor) { matrix(row, columns.of_block[block]) += factor; });
    ++row;
  }
  const Eigen::MatrixXd tendons = matrix.bottomRows(n);
  matrix.topRightCorner(common + 1, n) = tendons.leftCols(common + 1).transpose();
  for (Eigen::Index i = 0; i < f; ++i) {
    if (!free[static_cast<std::size_t>(i)]) continue;
    const double weight = closing_weight(mechanics, static_cast<int>(i) + 1);
    matrix(m + i, m + i) = 1 / weight;
    matrix(m + i, common) = matrix(common, m + i) = -1;
    matrix(common, common) += weight;
  }
  const Eigen::VectorXd x = least_norm_solution(matrix, right);
  const double miss = (tendons * x - right.tail(n)).cwiseAbs().maxCoeff();
  if (!(miss < length_tolerance)) return {};
  const bool unique = column_rank(tendons.leftCols(m)) == m;
  return {unique ? TreeState{} : undetermined(TensionFault::blocks_free),
          {x.data(), x.data() + m},
          {x.data() + m, x.data() + common}};
}

void write_blocks(const TreeColumns& columns, const double* travel,
                  std::vector<double>& block_travel) {
  for (std::size_t block = 0; block < block_travel.size(); ++block) {
    if (columns.of_block[block] >= 0) block_travel[block] = travel[columns.of_block[block]];
  }
}

// A finger can only close.
template <typename ClosingOf>
TreeState write_closings(const Network& network, Grasp grasp, std::size_t tree,
                         ClosingOf closing_of, std::vector<double>& closing) {
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != tree) continue;
    for (std::size_t i = 0; i < tendon.segments; ++i) {
      const Segment& segment = network.segments[tendon.first_segment + i];
      if (!closes(segment, grasp)) continue;
      const double dl = closing_of(segment.finger);
      if (dl < -length_tolerance) return undetermined(TensionFault::finger_opens);
      closing[static_cast<std::size_t>(segment.finger) - 1] =
          way_of(network, tree, segment.finger) * std::max(dl, 0.0);
    }
  }
  return {};
}

template <int Most>
TreeState write_common(const Network& network, const Mechanics& mechanics, Grasp grasp,
                       std::size_t tree, const TreeColumns& columns,
                       const CommonClosing<Most>& common, std::vector<double>& closing,
                       std::vector<double>& block_travel) {
  if (!common.unique) return undetermined(TensionFault::blocks_free);
  write_blocks(columns, common.blocks.data(), block_travel);
  const auto shared = [&](int finger) {
    return common.closing * closing_weight(mechanics, finger);
  };
  return write_closings(network, grasp, tree, shared, closing);
}

TreeState write_nearly_common(const Network& network, const Mechanics& mechanics, Grasp grasp,
                              std::size_t tree, const TreeColumns& columns,
                              std::vector<double>& closing, std::vector<double>& block_travel) {
  const TreeMotion nearly = nearly_common_closing(network, mechanics, grasp, tree, columns);
  if (!nearly.state.moves()) return nearly.state;
  if (network.shared) return undetermined(TensionFault::uneven_sharing);
  write_blocks(columns, nearly.blocks.data(), block_travel);
  const auto found = [&](int finger) {
    return nearly.closings[static_cast<std::size_t>(finger) - 1];
  };
  return write_closings(network, grasp, tree, found, closing);
}

std::vector<char> tendons_of(const Network& network, std::size_t tree) {
  std::vector<char> own;
  own.reserve(network.tendons.size());
  for (const TendonSpan& tendon : network.tendons) own.push_back(tendon.tree == tree ? 1 : 0);
  return own;
}

// A network in which the slack tendons belong to no tree.
Network without(const std::vector<char>& slack, Network network) {
  for (std::size_t t = 0; t < slack.size(); ++t) {
    if (slack[t] != 0) network.tendons[t].tree = network.tendons.size();
  }
  return network;
}

// Bounds of the slack tendons beside the taut ones of a tree: their lengths beyond the motion of
// fingers and blocks on taut tendons, in terms of the other blocks and of a common dl of the other
// fingers.
class SlackPart {
 public:
  SlackPart(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
            std::size_t tree, const std::vector<double>& given, const Network& taut)
      : network_(network),
        mechanics_(mechanics),
        grasp_(grasp),
        tree_(tree),
        given_(given),
        columns_(network, tree),
        taut_columns_(taut, tree),
        moved_(static_cast<std::size_t>(network.fingers), false) {
    for (const TendonSpan& tendon : taut.tendons) {
      if (tendon.tree != tree) continue;
      for_each_term(
          network, mechanics, tendon, grasp, [](double) {},
          [&](int finger, double) { moved_[static_cast<std::size_t>(finger) - 1] = true; },
          [](std::size_t, double) {});
    }
  }

  LeastMotion least(const std::vector<char>& slack, const std::vector<double>& closing,
                    const std::vector<double>& block_travel) const {
    const Eigen::Index unknowns = columns_.blocks + 1;
    const auto rows = static_cast<Eigen::Index>(slack.size());
    LengthBounds bounds{Eigen::MatrixXd::Zero(rows, unknowns), Eigen::VectorXd::Zero(rows),
                        Eigen::VectorXd::Unit(unknowns, columns_.blocks)};
    for (std::size_t t = 0; t < slack.size(); ++t) {
      if (slack[t] != 0) add(t, closing, block_travel, bounds);
    }
    return least_motion(bounds);
  }

  void write_free_blocks(const LeastMotion& least, std::vector<double>& block_travel) const {
    for (std::size_t block = 0; block < block_travel.size(); ++block) {
      if (columns_.of_block[block] >= 0 && taut_columns_.of_block[block] < 0) {
        block_travel[block] = least.x(columns_.of_block[block]);
      }
    }
  }

 private:
  void add(std::size_t tendon, const std::vector<double>& closing,
           const std::vector<double>& block_travel, LengthBounds& bounds) const {
    const auto row = static_cast<Eigen::Index>(tendon);
    double& motor = bounds.motor(row);
    for_each_term(
        network_, mechanics_, network_.tendons[tendon], grasp_,
        [&](double length) { motor += length; },
        [&](int finger, double factor) {
          const auto f = static_cast<std::size_t>(finger) - 1;
          if (!given_.empty()) motor -= factor * given_[f];
          if (moved_[f]) {
            motor -= factor * closing[f];
          } else {
            bounds.give(row, columns_.blocks) +=
                factor * way_of(network_, tree_, finger) * closing_weight(mechanics_, finger);
          }
        },
        [&](std::size_t block, double factor) {
          if (taut_columns_.of_block[block] >= 0) {
            motor += factor * block_travel[block];
          } else {
            bounds.give(row, columns_.of_block[block]) -= factor;
          }
        });
  }

  const Network& network_;
  const Mechanics& mechanics_;
  const Grasp& grasp_;
  std::size_t tree_;
  const std::vector<double>& given_;
  TreeColumns columns_;
  TreeColumns taut_columns_;
  std::vector<bool> moved_;
};

// Closes the fingers if not all tendons can be taut at one common dl. Each round finds those of the
// slack tendons that the others' motion would leave too short. `opens`: carriages only let out what
// fingers would have to take up.
TreeState solve_with_slack(const Network& network, const Mechanics& mechanics, Grasp grasp,
                           std::size_t tree, const std::vector<double>& given, bool opens,
                           std::vector<double>& closing, std::vector<double>& block_travel) {
  const std::vector<char> own = tendons_of(network, tree);
  std::vector<char> slack = own;
  write_closings(
      network, grasp, tree, [](int) { return 0.0; }, closing);
  while (true) {
    const Network taut = without(slack, network);
    const TreeColumns columns(taut, tree);
    if (columns.tendons > 0) {
      const CommonClosing<Eigen::Dynamic> common(taut, mechanics, grasp, tree, given, columns);
      TreeState state =
          common.exact
              ? write_common(taut, mechanics, grasp, tree, columns, common, closing, block_travel)
              : write_nearly_common(taut, mechanics, grasp, tree, columns, closing, block_travel);
      if (!state.moves()) return state;
    }
    const SlackPart part(network, mechanics, grasp, tree, given, taut);
    const LeastMotion least = part.least(slack, closing, block_travel);
    if (!least.met && slack == own) return {.jams = true};
    bool all_fit = true;
    for (std::size_t t = 0; t < slack.size(); ++t) {
      if (slack[t] == 0 || (least.met && !least.pulls(static_cast<Eigen::Index>(t)))) continue;
      slack[t] = 0;
      all_fit = false;
    }
    if (!all_fit) continue;
    part.write_free_blocks(least, block_travel);
    if (opens && slack == own) return undetermined(TensionFault::finger_opens);
    return {.slack = slack};
  }
}

template <int Most>
TreeState solve_with(const Network& network, const Mechanics& mechanics, Grasp grasp,
                     std::size_t tree, const std::vector<double>& given, const TreeColumns& columns,
                     std::vector<double>& closing, std::vector<double>& block_travel) {
  const CommonClosing<Most> common(network, mechanics, grasp, tree, given, columns);
  if (common.stands_still(network)) {
    if (common.has_room) return {.slack = tendons_of(network, tree)};
    return {.jams = common.drives};
  }
  if (common.exact) {
    if (network.shared && common.unique && common.closing < -length_tolerance) {
      return {.slack = tendons_of(network, tree)};
    }
    TreeState state =
        write_common(network, mechanics, grasp, tree, columns, common, closing, block_travel);
    if (state.fault != TensionFault::finger_opens) return state;
  }
  const bool opens = common.closes && !common.drives && !network.shared;
  return solve_with_slack(network, mechanics, grasp, tree, given, opens, closing, block_travel);
}

// λ is what is at right angles to every block's take-ups.
template <int Most>
bool balanced_ratios(const Network& network, const Mechanics& mechanics, std::size_t tree,
                     const TreeColumns& columns, std::vector<double>& ratios) {
  using Common = CommonClosing<Most>;
  if (columns.tendons != columns.blocks + 1) return false;
  typename Common::Matrix take_ups = Common::Matrix::Zero(columns.tendons, columns.blocks);
  Eigen::Index row = 0;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != tree) continue;
    for_each_pull(network, tendon, [&](std::size_t, std::size_t block, double sign, double weight) {
      take_ups(row, columns.of_block[block]) += sign * weight;
    });
    ++row;
  }
  const Eigen::ColPivHouseholderQR<typename Common::Matrix> qr(take_ups);
  if (qr.rank() < columns.blocks) return false;
  typename Common::Vector balance = Common::Vector::Unit(columns.tendons, columns.blocks);
  balance.applyOnTheLeft(qr.householderQ());
  double motor = 0;
  ratios.assign(static_cast<std::size_t>(network.fingers), 0.0);
  row = 0;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != tree) continue;
    for_each_term(
        network, mechanics, tendon, Grasp{}, [&](double length) { motor += balance(row) * length; },
        [&](int finger, double factor) {
          ratios[static_cast<std::size_t>(finger) - 1] +=
              balance(row) * factor * closing_weight(mechanics, finger);
        },
        [](std::size_t, double) {});
    ++row;
  }
  if (std::abs(motor) < length_tolerance) return false;
  if ((balance / motor).minCoeff() < -length_tolerance) return false;
  for (double& ratio : ratios) {
    ratio /= motor;
    if (std::abs(ratio) < length_tolerance) ratio = 0;
    if (ratio < 0) return false;
  }
  return true;
}

}  // namespace

bool travel_ratios(const Network& network, const Mechanics& mechanics, std::size_t tree,
                   std::vector<double>& ratios) {
  constexpr int small = 8;
  const TreeColumns columns(network, tree);
  if (columns.tendons <= small && columns.blocks < small) {
    return balanced_ratios<small>(network, mechanics, tree, columns, ratios);
  }
  return balanced_ratios<Eigen::Dynamic>(network, mechanics, tree, columns, ratios);
}

TreeState solve_tree_kinematics(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                std::size_t tree, std::vector<double>& closing,
                                std::vector<double>& block_travel,
                                const std::vector<double>& given) {
  constexpr int small = 8;
  const TreeColumns columns(network, tree);
  if (columns.tendons <= small && columns.blocks < small) {
    return solve_with<small>(network, mechanics, grasp, tree, given, columns, closing,
                             block_travel);
  }
  return solve_with<Eigen::Dynamic>(network, mechanics, grasp, tree, given, columns, closing,
                                    block_travel);
}

}  // namespace reeve::core
