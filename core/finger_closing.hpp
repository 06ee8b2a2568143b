// The closing of one finger in free motion: joint angles over the excursion of its tendon.
//
// The palm draws the tendon in slowly. With T_0 the tension at the palm and T_j that behind the
// guide of joint j (finger_guides.hpp), at each excursion x
//
//   joint      r_j T_j = k_j (q_j − q0_j)       if the joint is free
//              r_j T_j ≥ k_j (q_j − q0_j)       at its stop: the range's end or an object
//              r_j T_j ≤ k_j (q_j − q0_j)       at 0, held open by a preloaded spring
//   guide      T_j = T_{j−1} e^{−phi_j(q_j)}    closing: the tendon slides to the palm
//              T_{j−1} = T_j e^{−phi_j(q_j)}    opening: it slides to the tip
//   tendon     x = Σ_j r_j q_j
//
// Closing, T_n fixes all angles, from the tip to the palm, and x grows with T_n: one unknown. In
// opening a guide sticks, its joint and all beyond it at rest, until T_{j−1} has fallen to
// T_j e^{−phi_j}. So the guides let go one after another from the palm on, and at the same x the
// proximal joints are more open than in closing: the hysteresis of the finger.
//
// A joint without a spring turns as one with a vanishing spring: such joints move first, in
// proportion to their arms over friction. If springs are slack at a flexion above 0, the tendon is
// slack until x has reached that posture.
//
// An object at joint j takes the torque M_j = r_j T_j − k_j (q_j − q0_j). With phalanges of known
// length l, touched at their middle and square to them, the forces f follow from the tip inward:
//
//   M_j = Σ_{k ≥ j, touched} f_k [ l_k / 2 + Σ_{j ≤ i < k} l_i cos(q_{i+1} + … + q_k) ]
//
// A negative force says that the object cannot hold this phalanx: it would have to pull. There are
// no forces where a joint nearer to the palm is free, or would be pushed back from the end of its
// range: an object that rests would bend it back, and only one that goes with the finger is met.
//
// Assumptions: quasi-static, planar, constant arms, stiff tendon, one drive of the strands from the
// palm; an object acts as a stop of its joint, and goes with the phalanges nearer to the palm.
// Source: capstan law; joint balance and contact forces: L. Birglen, T. Laliberté, C. Gosselin,
// Underactuated Robotic Hands, Springer, 2008.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/finger_guides.hpp"
#include "core/hardware.hpp"

namespace reeve::core {

struct FingerPosture {
  double excursion_mm = 0;
  double pull_N = 0;                // T_0
  std::vector<double> flexion_rad;  // flexions of the joints
  std::vector<double> tension_N;    // T_j
  std::vector<double> object_Nmm;   // M_j; 0 where no object stops the joint
  std::vector<double> contact_N;    // f_j; empty without them, or without lengths of all phalanges
};

// The excursion at which a joint comes to its stop.
struct JointStop {
  std::size_t joint = 0;  // index, from 0
  double excursion_mm = 0;
  bool at_object = false;
};

// FurtherPull is added at the objects by a newton of pull beyond the whole closing, all joints at
// their stops.
struct FurtherPull {
  std::vector<double> object_mm;  // N mm/N
  std::vector<double> contact{};  // N/N; empty where there are no contact forces
};

struct FingerClosing {
  std::vector<FingerPosture> closing;  // equal steps of excursion from the open hand
  std::vector<FingerPosture> opening;  // the same steps back
  std::vector<JointStop> stops;        // in their order
  FurtherPull further;
};

// Joints with their guides' coefficients (with_guide_coefficients). At least one step.
FingerClosing close_finger(const std::vector<FingerJoint>& joints, int steps);

// The posture at one excursion of the closing.
FingerPosture closing_posture(const std::vector<FingerJoint>& joints, double excursion_mm);

}  // namespace reeve::core
