// Computes fingertip forces from strand tensions, finger by finger.
//
// With r_j the tendon's arm at joint j, h_j the lever of the fingertip force about it, and
// tau_j = k_j (q_j − q0_j) the torque of its return spring in the posture that holds:
//
//   excursion          E = Σ_j r_j Δ_j, what each strand gives up over the whole range Δ_j
//   pull               P = Σ T over the finger's strands, at the palm
//   pull at a joint    P_j = T_l,j + T_r,j, behind its guide (finger_guides.hpp): P without guides
//   fingertip force    F = min_j (r_j P_j − tau_j) / h_j, and not below 0
//   pull for a force   P_j = (h_j F + tau_j) / r_j: the same, solved for the pull at each joint
//   pull to close      P_j = k_j (Δ_j − q0_j) / r_j: against the springs, to the end
//
// A joint with r_j P_j − tau_j > h_j F flexes on until the object or its stop takes the rest; one
// with less is forced open. So the joint of the minimum is the one that gives, and F is the
// greatest force that no joint gives way to. Forces are linear in the motor tension T_M but for the
// springs.
//
// Assumptions: quasi-static; planar; the fingertip force acts along one line, stated by its levers;
// no slip at the object; arms that do not change as the joint turns; no friction in the joints but
// at their guides. A finger's strands have equal arms.
// Source: tau = J^T F joint by joint; L. Birglen, T. Laliberté, C. Gosselin, Underactuated Robotic
// Hands, Springer, 2008, on which joints of an underactuated finger hold and which give.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/finger_guides.hpp"
#include "core/grasp.hpp"
#include "core/hand_pulls.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"

namespace reeve::core {

// Pulls that one joint needs behind its guide, and the share of a pull at the palm that arrives.
struct JointDemand {
  double grip_N = 0;   // for the wanted force, in the posture that holds
  double close_N = 0;  // against the spring, at the end of the range
  double arm_over_lever = 0;
  double held_decay = 1;  // e^{−S_j} in the posture that holds
  double closed_decay = 1;
};

struct HandFinger {
  std::vector<FingerJoint> joints;
  std::vector<JointDemand> demands;  // one per joint
  bool is_known = false;             // true if its joints and its force are given
  double force_N = 0;                // wanted force
  double excursion_mm = 0;
};

// Fingers 1 … max_fingers, at their numbers less 1.
struct Hand {
  std::vector<HandFinger> fingers;
  MotorParts motor;

  const HandFinger& finger(int number) const {
    return fingers[static_cast<std::size_t>(number) - 1];
  }
};

// Its own, or where it has none those of all fingers.
FingerParts finger_parts(const Hardware& hardware, int finger);

// Nothing if no finger has joints.
std::optional<Hand> hand(const Hardware& hardware);
// The same hand, its tendons free of friction at the joints.
Hand without_guides(const Hand& hand);

// The first of fingers 1 … n that is not known; 0 if all are.
int first_unknown_finger(const Hand& hand, int fingers);

// The joint that gives first under a fingertip force, from 0, and the force at which it does, where
// the motor pulls with `motor_N`.
struct HeldForce {
  double force_N = 0;
  std::size_t joint = 0;
};
HeldForce held_force(const HandFinger& finger, const FingerPull& per_motor, double motor_N);

// Fingertip force under a pull, springs aside.
double force_without_springs(const HandFinger& finger, const FingerPull& pull);

// True if the motor then closes the finger to its end against its springs.
bool closes_springs(const HandFinger& finger, const FingerPull& per_motor, double motor_N);

// Pull at the palm that would do the pull's work at the joints, all turning by the same share of
// their ranges: less than the pull by the friction of the guides.
double working_pull(const HandFinger& finger, const FingerPull& pull);

// Energy in a finger's springs over that in the open hand, all joints at this share of their
// ranges, J.
double spring_energy(const HandFinger& finger, double share = 1);

// Demand of a grasp on the motor.
struct GripDemand {
  double force_per_motor_N = 0;  // least fingertip force of a finger, N/N, springs aside
  // Motor tension at which every finger presses with its wanted force, and those that are not held
  // can close against their springs; infinite if a finger hangs on slack strands. With several
  // motors that of the motor that needs most.
  double motor_force_N = 0;
  int weakest = 0;        // the finger that asks for it; 0 if nothing is gripped
  MotorArray motors_N{};  // force of each motor
  SeriesStretch stretch{};
};
GripDemand grip_demand(const Hand& hand, int fingers, const HandPulls& pulls, Grasp grasp);
// Motor force that one finger alone needs, and the joint that sets it, from 0.
struct AskedForce {
  double motor_N = 0;
  std::size_t joint = 0;
};
AskedForce asked_force(const HandFinger& finger, bool held, const FingerPull& pull_per_motor);
double motor_force(const HandFinger& finger, bool held, const FingerPull& pull_per_motor);

}  // namespace reeve::core
