// The five indicators by which the authors of the dual-tendon routings judge them (B. Kim, U.
// Jeong, K.-J. Cho, IEEE Robotics and Automation Letters 10(4), 2025), for any number n of fingers.
// With S the sum of the strand tensions, on a scale on which 10 is best:
//
//   adaptability         10 (1 − (greatest − least P_f) / S), P_f = T(2f−1) + T(2f)
//   torsional balance    10 (1 − greatest |T(2f−1) − T(2f)| / S), over the fingers with two strands
//   reliability          10 (1 − F / S), F: greatest friction force |T_l − T_r| at any contact
//   authors' efficiency  10 c S / (2n T_M), c = Σ_i dl_i / D while all fingers close alike
//   transmission         10 S / (2n T_M)
//
// A finger to which a tendon is tied has one strand: P_f is its tension, and 2n the number of all
// strands. F counts sheaths and pulleys too, not bars. The authors' efficiency is work over work if
// all strands closed alike (motor efficiency: performance.hpp): without blocks c is the number of
// motor-side segments, as they write it, and with blocks what the ways of the blocks leave.
//
// For two fingers these are the authors' formulas. They judge with finger 1 held. All are 0 where
// the strands are slack.
#pragma once

#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

struct Indicators {
  double adaptability = 0;
  double torsional_balance = 0;
  double reliability = 0;
  double authors_efficiency = 0;
  double transmission = 0;
};

// Keeps its memory from call to call.
class ClosingAlike {
 public:
  // c: what all strands together give up per unit of carriage travel, whatever the hardware says of
  // the fingers' shares. 0 where the carriage is blocked. Of the mechanics only the spools tell.
  double given_up(const Network& network, const Mechanics& mechanics);

 private:
  Mechanics mechanics_;
  Kinematics kinematics_;
  Motion motion_;
};

Indicators indicators(const Network& network, const TensionState& state);
// With what finger_pulls and ClosingAlike give.
Indicators indicators(const Network& network, const TensionState& state, const FingerPulls& pulls,
                      double given_up);

}  // namespace reeve::core
