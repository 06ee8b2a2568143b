// Tensions of whole routings of which each tree is solved once, pulled and released.
//
// Put together as known_trees.hpp says, with sums in the order of the network, they are those that
// TensionSolver gives, bit for bit, at a small part of the work where many routings have the same
// tendons. States of trees are kept up to a bounded number.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

// True if a tree behaves alike in every routing: all fingers are alike, and no effect of the model
// depends on tensions or contacts.
bool routings_share_states(const Model& model);

// True also only if no grasp gives the travels of carriages.
bool hold_one_finger_at_most(const GraspSet& grasps);

// True if no finger differs from another in hardware, and it has no hand.
bool have_like_fingers(const Model& model);

// No finger, or the one that is held if it is one of the tree's, from 1.
std::size_t held_in_tree(const TreeSpan& span, Grasp grasp);

class SharedStates {
 public:
  // The model and the grasps must allow sharing.
  explicit SharedStates(const Hardware& hardware) : builder_(hardware) {}

  // False if the routing must be solved as a whole: it is one tree, or split_into_trees says so.
  bool set_routing(const Routing& routing);

  // Jams, tensions and closing, in a grasp that holds one finger at most. False where a tension
  // leaves the range of a double.
  bool solve(Grasp grasp, Direction direction, TensionState& state);

 private:
  struct Mark {
    bool jams = false;
    bool in_range = true;
  };
  // A tree with, state after state, the relative tensions of all segments and the closing of the
  // fingers.
  struct Tree {
    std::size_t segments = 0;
    std::size_t fingers = 0;
    std::vector<std::size_t> motor_sides;  // indices of motor-side segments
    std::vector<Mark> marks;
    std::vector<double> numbers;
  };
  struct HashKey {
    std::size_t operator()(const TreeKey& key) const { return hash(key); }
  };

  const Tree& tree(const Routing& routing, const TreeSpan& span);
  Tree solved(const Routing& routing);
  bool mark(Grasp grasp, Direction direction, TensionState& state);

  MechanicsBuilder builder_;
  Network network_;
  Mechanics mechanics_;
  TensionSolver solver_;
  TensionState alone_;
  Routing part_;
  std::unordered_map<TreeKey, Tree, HashKey> known_;

  // State of the current routing.
  std::vector<TreeSpan> spans_;
  std::vector<const Tree*> trees_;
  std::size_t segments_ = 0;
  std::size_t fingers_ = 0;
  std::vector<std::size_t> states_;  // states of its trees in the grasp
};

}  // namespace reeve::search
