// Computes the closing of fingers whose two strands may lie on two tendons, because a contact
// between them is seized (seizure.hpp).
//
// The carriage travels D = 1. A tendon with m motor-side segments must lose m; its strands give up
// dl_f each. The fingers close as little as they must:
//
//   minimise   Σ_f dl_f² / w_f    (w_f: closing weight)
//   subject to Σ_{strands on tendon p} dl_f >= m_p,   dl_f = 0 for held fingers
//
// so that on one tendon alone the closing fingers share by weight, as everywhere else. A tendon
// that has to give up more than it must is slack, and so is one without motor-side segment; one
// that the motor pulls and no finger can serve jams. Release is the motion reversed.
//
// Solved by Hildreth's method: the multipliers lambda_p >= 0 one after the other, dl = W Aᵀ lambda.
//
// Where blocks tie tendons together, a tendon also gives z to its tails' blocks and takes it from
// the blocks that it passes (tree_kinematics.hpp), z free: on the left of the constraint stands
// Σ dl_f + Σ tails z − 2 Σ passes z − Σ beckets z. A tendon is slack if its multiplier is 0. Solved
// as least_motion.hpp says.
#pragma once

#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension_fault.hpp"

namespace reeve::core {

struct SplitClosing {
  std::vector<double> closing;  // dl of fingers 1 … n
  std::vector<char> jams;       // one per tendon
  std::vector<char> slack;      // one per tendon
  std::vector<double> block_travel;
  // Only shared_closing (shared_kinematics.hpp) sets these two.
  TensionFault fault = TensionFault::none;
  int opposed = 0;  // finger whose tendons ask for two closings, if it jams so
};

SplitClosing split_closing(const Network& network, const Mechanics& mechanics, Grasp grasp);

}  // namespace reeve::core
