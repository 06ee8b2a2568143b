// Friction between the tendon and the guides at a finger's joints.
//
// A guide sits on the link before its joint j. The tendon wraps it by w_j + q_j: w_j with the hand
// open, and the flexion q_j besides. With the friction coefficient mu_j its exponent is
//
//   phi_j = mu_j (w_j + q_j)
//
// and joint j feels the tension behind its guide. Along a strand with the tension T at the palm
//
//   sliding towards the palm     T_j = T e^{−S_j},   S_j = phi_1 + … + phi_j
//   sliding towards the tip      T_j = T e^{+S_j}
//
// so that the distal joint gets less than the proximal one where the palm draws the tendon in. A
// tendon that goes in along one strand and comes out along the other passes each guide twice: this
// adds 2 S_n to the exponent between both strands, that of the tip contact (mechanics.hpp).
//
// Assumptions: Coulomb friction; both strands pass guides of equal wrap; a strand slides one way at
// all of its guides, which the tip contact's slip tells; a strand that does not move is loaded from
// the palm. The pulls of a grasp are those of the posture that holds.
// Source: capstan law (tension/tension.hpp), guide by guide; wrap = bend of the joint, as for
// tendon sheaths: M. Kaneko, T. Yamashita, K. Tanie, Basic considerations on transmission
// characteristics for tendon drive robots, ICAR, 1991.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "core/hardware.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

constexpr double in_rad(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double in_deg(double radians) { return radians * 180 / std::numbers::pi; }

// "pulley", "tube"; "" of none.
const char* guide_name(JointGuide guide);

// The joints with the coefficients of tubes and bearings where a guide has none of its own.
std::vector<FingerJoint> with_guide_coefficients(std::vector<FingerJoint> joints,
                                                 const Hardware& hardware);
std::vector<FingerJoint> without_guides(std::vector<FingerJoint> joints);

// True if the tendon loses tension at some joint.
bool has_guides(const std::vector<FingerJoint>& joints);

// mu (w + q), q in rad; 0 without a guide.
double guide_exponent(const FingerJoint& joint, double flexion_rad);

// S_n with every joint at the end of its range, and in the posture that holds.
double closed_exponent(const std::vector<FingerJoint>& joints);
double held_exponent(const std::vector<FingerJoint>& joints);

// Tensions of a finger's strands at the palm: the sum of those that slide towards the palm, and of
// those that slide towards the tip.
struct FingerPull {
  double inward_N = 0;
  double outward_N = 0;

  double sum_N() const { return inward_N + outward_N; }
  // With `decay` = e^{−S_j}.
  double behind_guide_N(double decay) const { return inward_N * decay + outward_N / decay; }
};

// Pulls of fingers 1 … n at their numbers, while the carriage pulls.
using FingerPullArray = std::array<FingerPull, max_fingers + 1>;
FingerPullArray finger_pulls_of(const Network& network, const TensionState& state);

}  // namespace reeve::core
