// Finds the least motion that leaves no tendon too short, and which tendons it pulls.
//
//   minimise ½ Σ c_i x_i²   subject to   give · x >= motor, one row for each tendon
//
// x holds closings, c > 0, and the travels of blocks, c = 0. A tendon can only pull: a multiplier
// is its tension without friction, and where it is 0 the tendon is slack. If no x meets all rows,
// their tendons hold each other: a jam.
//
// Solved by active sets: tendons that would have to push are let go, and those that are then too
// short are taken back. Meanwhile tendons stretch by a little of their tension, so that tendons
// that cannot all be taut have tensions, too.
#pragma once

#include <Eigen/Core>

#include "numerics/floors.hpp"

namespace reeve::core {

struct LengthBounds {
  Eigen::MatrixXd give;
  Eigen::VectorXd motor;
  Eigen::VectorXd cost;
};

struct LeastMotion {
  Eigen::VectorXd x;
  Eigen::VectorXd pull;  // one for each tendon
  bool met = false;

  bool pulls(Eigen::Index tendon) const { return pull(tendon) > 1e-9; }
};

LeastMotion least_motion(const LengthBounds& bounds);

}  // namespace reeve::core
