// Trees of tendons, each solved once for all routings that contain it.
//
// Trees on one carriage share a scale and nothing else. Let t_i be the tensions of a tree alone
// (TensionSolver::solve_relative). The tensions of a routing are
//
//   T_i = t_i / Σ t_j,  j: all motor-side segments
//
// If a tree jams, the trees that do not jam have t_i = 0 and nothing moves. With sums in the order
// of the network, tensions are those that TensionSolver gives, bit for bit, at a small part of the
// work where many routings have the same tendons. Trees are kept up to a bounded number.
//
// Of most trees nobody asks for more than sums, which for a tendon alone are found without solving.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/jamming.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/tendon_sums.hpp"
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

// Sums of a tree's state, whose tensions are in units of `unit_N`.
TreeSums sums_of(const Network& network, const TensionState& state, double unit_N = 1);

class SharedStates {
 public:
  // The model and the grasps must allow sharing.
  explicit SharedStates(const Hardware& hardware) : tendon_sums_(hardware), builder_(hardware) {}

  // These trees of a routing, valid until the next call. Sums of a tendon alone are those of its
  // states but for rounding.
  const std::vector<const TreeOutline*>& outlines(const Routing& routing,
                                                  const std::vector<TreeSpan>& spans);

  // False if the routing must be solved as a whole: it is one tree, or split_into_trees says so.
  bool set_routing(const Routing& routing);

  // Jams, tensions and closing, in a grasp that holds one finger at most. False where a tension
  // leaves the range of a double.
  bool solve(Grasp grasp, Direction direction, TensionState& state);

  // Returns the same as JamFinder::grasps.
  double jams() const;

 private:
  struct Mark {
    bool jams = false;
    bool in_range = true;
  };
  // A tree with, state after state, the relative tensions of all segments and the closing of the
  // fingers: first the states pulled, then those released.
  struct Tree {
    TreeOutline outline;
    std::size_t segments = 0;
    std::vector<std::size_t> motor_sides;  // indices of motor-side segments
    std::vector<Mark> marks;               // empty if only its outline is known
    std::vector<double> numbers;
    double moving = 0;  // number of sets of its held fingers with which it does not jam
  };

  void make_room(std::size_t trees);
  void outline(const Routing& routing, const TreeSpan& span, Tree& tree);
  // States released follow those pulled.
  void solve_tree(const Routing& routing, const TreeSpan& span, Direction direction, Tree& tree);
  void start(Tree& tree) const;
  bool mark(Grasp grasp, Direction direction, TensionState& state);

  TendonSums tendon_sums_;
  MechanicsBuilder builder_;
  Network network_;
  Mechanics mechanics_;
  TensionSolver solver_;
  JamFinder jam_finder_;
  TensionState alone_;
  Routing part_;
  std::unordered_map<TreeKey, Tree, TreeKey::Hash> known_;
  // A tree with more than half of a routing's fingers, whose outline was asked for: there are many
  // of them, and one stays while those beside it change.
  TreeKey greatest_key_;
  Tree greatest_;
  std::vector<const TreeOutline*> outlines_;

  // State of the current routing.
  std::vector<TreeSpan> spans_;
  std::vector<const Tree*> trees_;
  std::size_t segments_ = 0;
  std::size_t fingers_ = 0;
  std::vector<std::size_t> states_;  // states of its trees in the grasp
};

}  // namespace reeve::search
