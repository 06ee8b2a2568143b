#include "core/tension/shared_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {
namespace {

// Per unit of carriage travel, as in tree_kinematics.cpp.
constexpr double least_step = 1e-9;
constexpr double settled_step = 1e-14;
// Steps of trees that can all move shrink by more than this over so many sweeps.
constexpr double shrinks = 0.999;
constexpr int most_stalled_sweeps = 50;

class SharedClosing {
 public:
  SharedClosing(const Network& network, const Mechanics& mechanics, const Grasp& grasp)
      : net_(network), mechanics_(mechanics), grasp_(grasp) {
    const std::size_t n = net_.tendons.size();
    found_.closing.assign(static_cast<std::size_t>(net_.fingers), 0.0);
    found_.block_travel.assign(net_.blocks.size(), 0.0);
    found_.jams.assign(n, 0);
    found_.slack.assign(n, 0);
    for (std::size_t t = 0; t < n; ++t) {
      if (net_.tendons[t].tree != t) continue;
      trees_.push_back({t, is_pulled(t), found_.closing, found_.closing});
    }
  }

  SplitClosing solve() {
    if (settle()) follow();
    return std::move(found_);
  }

 private:
  struct Tree {
    std::size_t number;
    bool pulled;
    std::vector<double> closing;
    std::vector<double> step;
  };

  bool is_pulled(std::size_t tree) const {
    for (const TendonSpan& tendon : net_.tendons) {
      if (tendon.tree != tree) continue;
      for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
        if (net_.segments[i].kind == SegmentKind::motor_side &&
            end_travel(net_, mechanics_, grasp_, i) > 0) {
          return true;
        }
      }
    }
    return false;
  }

  // Closes the tree's fingers beyond what the others do, and returns its greatest step.
  double move(Tree& tree, TreeState& state) {
    std::vector<double> given(found_.closing.size(), 0.0);
    for (const Tree& other : trees_) {
      if (&other == &tree) continue;
      for (std::size_t f = 0; f < given.size(); ++f) given[f] += other.closing[f];
    }
    std::vector<double> closing(given.size(), 0.0);
    state = solve_tree_kinematics(net_, mechanics_, grasp_, tree.number, closing,
                                  found_.block_travel, given);
    double greatest = 0;
    for (std::size_t f = 0; f < given.size(); ++f) {
      tree.step[f] = closing[f] - tree.closing[f];
      greatest = std::max(greatest, std::abs(tree.step[f]));
    }
    tree.closing = std::move(closing);
    return greatest;
  }

  void mark(const Tree& tree, std::vector<char>& marks) const {
    for (std::size_t t = 0; t < marks.size(); ++t) {
      if (net_.tendons[t].tree == tree.number) marks[t] = 1;
    }
  }

  static int first_moved(const std::vector<double>& ways) {
    const auto moved = std::find_if(ways.begin(), ways.end(),
                                    [](double way) { return std::abs(way) > least_step; });
    return moved == ways.end() ? 0 : static_cast<int>(moved - ways.begin()) + 1;
  }

  // False if the grasp jams or has a fault.
  bool settle() {
    double before = 0;
    for (int stalled = 0; stalled < most_stalled_sweeps;) {
      double greatest = 0;
      bool blocked = false;
      std::fill(found_.slack.begin(), found_.slack.end(), 0);
      for (Tree& tree : trees_) {
        if (!tree.pulled) continue;
        TreeState state;
        greatest = std::max(greatest, move(tree, state));
        found_.fault = state.fault;
        if (state.fault != TensionFault::none) return false;
        for (std::size_t t = 0; t < state.slack.size(); ++t) found_.slack[t] |= state.slack[t];
        if (state.jams) mark(tree, found_.jams);
        blocked |= state.jams;
      }
      if (blocked) return false;
      if (greatest < settled_step) return true;
      stalled = greatest > shrinks * before ? stalled + 1 : 0;
      before = greatest;
    }
    for (const Tree& tree : trees_) {
      if (first_moved(tree.step) == 0) continue;
      found_.opposed = first_moved(tree.step);
      mark(tree, found_.jams);
    }
    return false;
  }

  // A tree that no carriage pulls, and that would have to move a finger against one that is pulled.
  void oppose(const Tree& still, const Tree& pulled) {
    for (std::size_t f = 0; f < found_.closing.size(); ++f) {
      if (std::abs(still.closing[f]) <= least_step || pulled.closing[f] == 0) continue;
      found_.opposed = static_cast<int>(f) + 1;
      mark(pulled, found_.jams);
      return;
    }
  }

  // Trees that no carriage pulls.
  void follow() {
    for (Tree& tree : trees_) {
      if (tree.pulled) continue;
      TreeState state;
      move(tree, state);
      if (state.fault != TensionFault::none) found_.fault = state.fault;
      mark(tree, found_.slack);
      for (const Tree& other : trees_) {
        if (other.pulled) oppose(tree, other);
      }
      std::fill(tree.closing.begin(), tree.closing.end(), 0.0);
    }
    for (const Tree& tree : trees_) {
      for (std::size_t f = 0; f < found_.closing.size(); ++f) found_.closing[f] += tree.closing[f];
    }
  }

  const Network& net_;
  const Mechanics& mechanics_;
  const Grasp& grasp_;
  SplitClosing found_;
  std::vector<Tree> trees_;
};

}  // namespace

SplitClosing shared_closing(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  return SharedClosing(network, mechanics, grasp).solve();
}

}  // namespace reeve::core
