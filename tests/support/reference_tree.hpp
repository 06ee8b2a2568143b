// Trees of tendons that floating blocks join, in numbers. A tendon without blocks is a tree alone.
//
// A block b that moves by z_b toward its tails lengthens what both strands of each pass and each
// becket need by z_b and shortens what its tails need: e_i = ... + C_ib z_b with C_ib = 1, 1, -1.
// Its balance is sum_i C_ib T_i = 0.
//
// The arms of a bar move by z_l and z_r, (a z_l + b z_r) / (a + b) = z, where T_l : T_r = a : b. So
// lengths pass from its one side to the other in the ratio b : a: c_l : c_r = a : b makes
// sum_i c_i e_i what a tendon conserves (c = 1 without bars).
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "tests/support/reference_numbers.hpp"
#include "tests/support/reference_shared.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing::reference {

struct TreeContact {
  Index left, right;  // segments
  Real phi;
  bool bar;
  Real arms;      // ln (T_left / T_right) of a bar
  Real slip = 0;  // zero-order, times c, D = 1
};

// The segments and contacts of one tendon.
struct Span {
  std::size_t tendon;  // its place in the word
  Index segment, segments, contact, contacts;
  bool loop;
};

struct Tree {
  std::vector<Span> spans;
  std::vector<TreeContact> contacts;
  std::vector<int> finger;  // of each segment; 0 if it is no strand
  Vector strand;            // 1 at a strand, -1 at an extensor's, 0 elsewhere
  Vector length, c;
  Vector motor;                  // travel of the carriage of motor-side segments
  std::vector<bool> motor_side;  // whether each segment is one
  Vector give;                   // dl of the finger of each strand, reversed at an extensor's
  Vector elastic;                // E
  Matrix hangs;                  // C: a row for each segment, a column for each block
  std::map<int, Real> closing;   // dl of the fingers that close; empty if the tree jams
  bool jams = false;
  std::vector<bool> slack{};  // of each span, by the kinematics; empty if none is
};

// One for each set of tendons that blocks join, with the motion of the grasp imposed. Throws
// std::invalid_argument for a tree without a motor-side segment, a block without tail or without
// pass and becket, one that hangs on a tendon that passes it, and a bar with unequal arms in a
// loop.
std::vector<Tree> pose_trees(const std::vector<Tendon>& tendons, const std::set<int>& held,
                             ReferenceDirection direction, const ReferenceHardware& hardware);

// One for each tendon, with the motion of the fingers that they share; nothing is imposed on a
// slack one.
std::vector<Tree> pose_shared(const std::vector<Tendon>& tendons, const SharedMotion& shared,
                              ReferenceDirection direction, const ReferenceHardware& hardware);

}  // namespace reeve::testing::reference
