// A routing as ropes that have one tension each, since nothing rubs.
//
// A rope is a tendon, or where bars part it, a piece of a tendon. On its way it meets *legs*:
// straight stretches between an eyelet that is fixed at the hand and a point on something that
// moves, all parallel to the way of what moves, so that a leg is as much longer or shorter as that
// has moved:
//   strand               to the runner of its finger, which gives up what the finger closes; an
//                        extensor's on the other side
//   motor-side segment   to the carriage, or to an end of its own, on a spool or behind a spring
//   pass, becket, arm    to the block, on the side from which it goes away as it moves to its tails
//   tail                 to the block, on the other side
// Between its legs a rope runs from eyelet to eyelet at constant length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/network.hpp"
#include "core/routing.hpp"

namespace reeve::reports {

enum class Mover : std::uint8_t { runner, carriage, own_end, block, left_arm, right_arm };

struct Leg {
  Mover mover = Mover::runner;
  std::size_t owner = 0;  // finger or motor from 1; index of the block
  std::string name;       // T1, a, Y1_1
  bool is_tail = false;   // as an extensor's, longer as its owner moves
};

enum class PointKind : std::uint8_t {
  eyelet,  // one end of a leg
  mover,   // the other end of the leg
  fixed,   // end of a tendon at the hand, or a joint there
};

struct RopePoint {
  PointKind kind = PointKind::eyelet;
  std::size_t index = 0;  // index of the leg; of fixed points, their number
};

struct Rope {
  std::vector<RopePoint> points;
  std::vector<std::size_t> segments;  // segments of the network
};

struct RopePlan {
  std::vector<Leg> legs;
  std::vector<Rope> ropes;
  std::size_t fixed_points = 0;
};

RopePlan rope_plan(const Routing& routing, const Network& network);

}  // namespace reeve::reports
