// Trees that were solved before, as many as a table of fixed size holds.
//
// Each hash has a set of four places, of which the one that was not asked for longest makes room:
// memory is bounded, and what is not found is solved again, to the same figures. A tree with more
// than half of a routing's fingers has a place of its own beside the table: there are many of them,
// and in the order in which routings are generated one stays while all others beside it change.
//
// Of most trees nobody asks for more than sums, which for a tendon alone are found without solving.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/tension/jamming.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/tendon_sums.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

// Solved states of a tree of tendons by itself, for each grasp of its own fingers.
//
// Trees on one carriage share a scale and nothing else. Let t_i be the tensions of a tree alone
// (TensionSolver::solve_relative). The tensions of a routing are
//
//   T_i = t_i / Σ t_j,  j: all motor-side segments
//
// If a tree jams, the trees that do not jam have t_i = 0 and nothing moves. A tree solved once thus
// serves every routing that contains it. Arrays have the order of the network.
struct SolvedTree {
  bool jams = false;
  bool in_range = true;
  std::span<const double> motor_side;  // t_i
  std::span<const double> strand;      // t_i
  std::span<const double> closing;     // closing of each strand; 0 if the tree jams
};

struct SolvedTrees {
  TreeOutline outline;
  std::vector<double> length;               // length of each segment
  std::vector<std::uint8_t> strand_finger;  // finger of each strand, from 0
  std::size_t motor_sides = 0;
  double moving_sets = 0;  // number of sets of its held fingers with which it does not jam

  // 0: no finger held; f: finger f.
  SolvedTree in_state(std::size_t held) const;

 private:
  friend class TreeSolver;

  std::vector<double> numbers_;  // state by state: the three spans
};

// Requires hardware on which all fingers are alike. Keeps its memory.
class TreeSolver {
 public:
  explicit TreeSolver(const Hardware& hardware) : builder_(hardware) {}

  // Keeps the memory of `states`.
  void solve(const Routing& tree, SolvedTrees& states);

 private:
  void solve(Grasp grasp, SolvedTrees& states);

  MechanicsBuilder builder_;
  Network network_;
  Mechanics mechanics_;
  TensionSolver solver_;
  TensionState state_;
  JamFinder jam_finder_;
};

class KnownTrees {
 public:
  static constexpr std::size_t default_sets = 2048;

  // `sets` is a power of two.
  explicit KnownTrees(const Hardware& hardware, std::size_t sets = default_sets);

  // These trees of a routing, valid until the next call; nothing where more trees than there are
  // places share a hash. Sums of a tendon alone are those of its states but for rounding.
  const std::vector<const TreeOutline*>& outlines(const Routing& routing,
                                                  const std::vector<TreeSpan>& spans);
  const std::vector<const SolvedTrees*>& states(const Routing& routing,
                                                const std::vector<TreeSpan>& spans);

  // Trees solved so far.
  std::uint64_t solved() const { return solved_; }

 private:
  static constexpr std::size_t ways = 4;

  struct Place {
    TreeKey key;
    std::uint64_t asked = 0;  // number of the last request; 0: empty
    bool solved = false;      // false: it has an outline only
    SolvedTrees states;
  };

  bool find(const Routing& routing, const std::vector<TreeSpan>& spans);
  Place* find(const Routing& routing, const TreeSpan& span);
  void outline(const Routing& routing, const TreeSpan& span, Place& place);
  void solve(const Routing& routing, const TreeSpan& span, Place& place);

  TendonSums tendon_sums_;
  TreeSolver solver_;
  Routing tree_;
  Place greatest_;
  std::vector<Place> table_;
  std::uint64_t now_ = 0;
  std::uint64_t solved_ = 0;
  std::vector<Place*> found_;
  std::vector<const TreeOutline*> outlines_;
  std::vector<const SolvedTrees*> states_;
};

}  // namespace reeve::search
