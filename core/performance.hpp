// How well a routing pulls the fingers in one grasp.
//
//   uniformity          min_i T_i / max_i T_i over the strands
//   motor efficiency    Σ_i T_i dl_i / (T_M D): useful work over motor work
//                       (releasing, the inverse: how much of the fingers' work the motor gets)
//   force transmission  Σ_i T_i / T_M over the strands
//
// Efficiency is 1 without friction and never more than the best sheath's e^{-phi}. All are numbers
// without unit; where all strands are slack uniformity is 0, and a routing without strands (a test
// bench) has none (NaN).
#pragma once

#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

struct Performance {
  double uniformity = 0;
  double efficiency = 0;
  double force_transmission = 0;
};

Performance performance(const Network& network, const TensionState& state,
                        Direction direction = Direction::pull);

// Motor tension while the fingers draw the tendon out over motor tension while the motor draws it
// in, at equal work of the strands: the product of both efficiencies. 1 without friction, 0 where
// the grasp jams.
double return_friction(const Performance& pull, const Performance& release);

// Parts that a routing needs.
struct PartCount {
  int sheaths = 0;  // one for each M, two for each P
  int pulleys = 0;  // everything that turns on a bearing: P, B, and fingertips with a bearing
  int knots = 0;    // one for each loop, whose ends must be tied

  int total() const { return sheaths + pulleys + knots; }
};

PartCount parts(const Network& network);

}  // namespace reeve::core
