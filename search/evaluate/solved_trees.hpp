// What a tree of tendons does by itself, in each grasp of its own fingers.
//
// Trees on one carriage share a scale and nothing else: with t_i the tensions that a tree has alone
// (TensionSolver::solve_relative), those of a routing are
//
//   T_i = t_i / Σ t_j,  j: all motor-side segments
//
// and where a tree jams, those that do not have t_i = 0 and nothing moves. So what is solved once
// for a tree holds for every routing that it is part of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/tree_outline.hpp"

namespace reeve::search {

// Arrays in the order of the network.
struct SolvedTree {
  bool jams = false;
  bool in_range = true;
  std::span<const double> motor_side;  // t_i
  std::span<const double> strand;      // t_i
  std::span<const double> closing;     // of the strands; 0 if it jams
};

struct SolvedTrees {
  TreeOutline outline;
  std::vector<double> length;               // of all segments
  std::vector<std::uint8_t> strand_finger;  // from 0
  std::size_t motor_sides = 0;

  // 0: no finger held; f: finger f.
  SolvedTree in_state(std::size_t held) const;

 private:
  friend class TreeSolver;

  std::vector<double> numbers_;  // state by state: the three spans
};

// Of hardware on which all fingers are alike. Keeps its memory.
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
};

}  // namespace reeve::search
