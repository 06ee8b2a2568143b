// Where the parts of a planar rig stand, in metres: fingers side by side along y, each of their
// legs and those of the carriage parallel to x, blocks in lanes of their own beside them.
//
// A leg must never come to an end: each mover stands so far from its eyelets as it can travel while
// the fingers close, which is bounded by the kinematics (core/tension/kinematics.hpp): the greatest
// travel of a block for each millimetre closed in the grasps "none held" and "one finger held",
// times what all fingers can close.
#pragma once

#include <vector>

#include "core/hand.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"
#include "reports/mujoco/rope_plan.hpp"

namespace reeve::reports {

struct RigFinger {
  std::vector<FingerJoint> joints;  // none: the finger is a slider with a spring
  double closing_m = 0;             // what each strand gives up at most
  double spring_N_m = 0;            // of a slider
  double reach_m = 0;               // from the eyelets to the runner in the open hand
  double y_m = 0;
};

struct RigBlock {
  double reach_m = 0;  // to its eyelets on either side
  double y_m = 0;
};

struct RigLayout {
  std::vector<RigFinger> fingers;  // 1 … n, at their numbers less 1
  std::vector<RigBlock> blocks;
};

struct Place {
  double x_m = 0;
  double y_m = 0;
};

inline constexpr double carriage_x_m = -0.15;

// Throws OutOfRange where the kinematics leaves blocks undetermined, InputError of bad hardware.
RigLayout rig_layout(const Network& network, const Hardware& hardware);

// In the world, with the hand open.
Place mover_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg);
Place eyelet_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg);

}  // namespace reeve::reports
