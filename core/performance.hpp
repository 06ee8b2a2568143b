// Measures how well a routing pulls the fingers in one grasp.
//
//   uniformity          min_i T_i / max_i T_i over the strands, but for slack flexors beside an
//                       extensor that pulls, and the reverse
//   finger uniformity   min_f P_f / max_f P_f over the fingers, P_f the sum over its flexors less
//                       that over its extensor, or the reverse where it is greater;
//                       to be used if some fingers have one strand (1x) and some two
//   motor efficiency    Σ_i T_i dl_i / Σ_c T_Mc D_c: useful work over the work of all motors c,
//                       T_M D of one
//                       (releasing, the inverse: how much of the fingers' work the motor gets)
//   force transmission  Σ_i T_i / T_M over the strands
//
// Efficiency is 1 without friction and never more than the best sheath's e^{-phi}. All are numbers
// without unit; where all strands are slack uniformity is 0, and a routing without strands (a test
// bench) has none (NaN).
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

struct Performance {
  double uniformity = 0;
  double efficiency = 0;
  double force_transmission = 0;
  double finger_uniformity = 0;
};

// One value for each of fingers 1 … n, at its number.
using FingerArray = std::array<double, max_fingers + 1>;

// The sum of each finger's strand tensions, an extensor's negative.
FingerArray pulls_by_finger(const Network& network, const TensionState& state);

// Their sizes over the fingers; 0 without fingers.
struct FingerPulls {
  double least = 0;
  double greatest = 0;
};

FingerPulls finger_pulls(const Network& network, const TensionState& state);

Performance performance(const Network& network, const TensionState& state,
                        Direction direction = Direction::pull);
// In a pull, with what finger_pulls gives.
Performance performance(const Network& network, const TensionState& state,
                        const FingerPulls& pulls);
// True if the strand is slack while its finger's antagonist pulls.
bool yields(const Network& network, const TensionState& state, std::size_t strand);
// Its motor efficiency alone.
double motor_efficiency(const Network& network, const TensionState& state, Direction direction);

// Sums and extremes over the strands, from which performance is computed.
struct StrandTally {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  double sum = 0;
  double work = 0;  // per unit of travel; where it is a performance, over the motors' work

  void add(double tension, double closing) {
    least = std::min(least, tension);
    most = std::max(most, tension);
    sum += tension;
    work += tension * closing;
  }
};

// … in a pull, `pulls` those of the same strands.
Performance performance(const StrandTally& tally, const FingerPulls& pulls);

// Motor tension while the fingers draw the tendon out over motor tension while the motor draws it
// in, at equal work of the strands: the product of both efficiencies. 1 without friction, 0 where
// the grasp jams.
double round_trip_efficiency(double pull_efficiency, double release_efficiency);

// Parts that a routing needs.
struct PartCount {
  int sheaths = 0;  // one for each M, two for each P
  int pulleys =
      0;           // everything fixed or on the carriage that turns on a bearing: P, B, tips with b
  int knots = 0;   // one for each loop, whose ends must be tied
  int blocks = 0;  // floating blocks at the hand
  int bars = 0;
  int anchors = 0;  // ends tied at fingertips
  // Counts that prices tell apart (part_prices.hpp); the first three are among the pulleys.
  int tip_bearings = 0;
  int fixed_pulleys = 0;    // B
  int movable_pulleys = 0;  // P
  int tubes = 0;            // fingertips without a bearing, and T
  int fixed_ends = 0;       // F

  int total() const { return sheaths + pulleys + knots + blocks + bars + anchors; }

  PartCount& operator+=(const PartCount& other);
};

PartCount parts(const Network& network);

}  // namespace reeve::core
