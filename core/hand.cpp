#include "core/hand.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace reeve::core {
namespace {

constexpr double rad(double degrees) { return degrees * std::numbers::pi / 180; }

double spring_torque(const FingerJoint& joint, double flexion_deg) {
  return joint.spring_Nmm_rad * rad(flexion_deg - joint.rest_deg);
}

double holding_torque(const FingerJoint& joint) {
  return spring_torque(joint, joint.held_deg.value_or(joint.range_deg));
}

double grip_pull(const FingerJoint& joint, double force_N) {
  return (joint.lever_mm * force_N + holding_torque(joint)) / joint.arm_mm;
}

HandFinger finger_of(const FingerParts& parts) {
  HandFinger finger;
  finger.joints = parts.joints;
  finger.is_known = !parts.joints.empty() && parts.force_N;
  finger.force_N = parts.force_N.value_or(0);
  finger.force_per_pull = std::numeric_limits<double>::infinity();
  for (const FingerJoint& joint : finger.joints) {
    finger.excursion_mm += joint.arm_mm * rad(joint.range_deg);
    finger.force_per_pull = std::min(finger.force_per_pull, joint.arm_mm / joint.lever_mm);
    finger.grip_pull_N = std::max(finger.grip_pull_N, grip_pull(joint, finger.force_N));
    finger.close_pull_N =
        std::max(finger.close_pull_N, spring_torque(joint, joint.range_deg) / joint.arm_mm);
  }
  return finger;
}

}  // namespace

FingerParts finger_parts(const Hardware& hardware, int finger) {
  FingerParts parts = hardware.finger_parts;
  for (const FingerHardware& own : hardware.fingers) {
    if (own.finger != finger) continue;
    if (!own.parts.joints.empty()) parts.joints = own.parts.joints;
    if (own.parts.force_N) parts.force_N = own.parts.force_N;
  }
  return parts;
}

std::optional<Hand> hand(const Hardware& hardware) {
  const bool any = !hardware.finger_parts.joints.empty() ||
                   std::any_of(hardware.fingers.begin(), hardware.fingers.end(),
                               [](const FingerHardware& f) { return !f.parts.joints.empty(); });
  if (!any) return std::nullopt;
  Hand hand{{}, hardware.motor};
  for (int number = 1; number <= max_fingers; ++number) {
    hand.fingers.push_back(finger_of(finger_parts(hardware, number)));
  }
  return hand;
}

int first_unknown_finger(const Hand& hand, int fingers) {
  for (int number = 1; number <= fingers; ++number) {
    if (!hand.finger(number).is_known) return number;
  }
  return 0;
}

HeldForce held_force(const HandFinger& finger, double pull_N) {
  HeldForce held{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t j = 0; j < finger.joints.size(); ++j) {
    const FingerJoint& joint = finger.joints[j];
    const double force = (joint.arm_mm * pull_N - holding_torque(joint)) / joint.lever_mm;
    if (force < held.force_N) held = {force, j};
  }
  held.force_N = std::max(held.force_N, 0.0);
  return held;
}

std::size_t asking_joint(const HandFinger& finger) {
  const auto asks_less = [&](const FingerJoint& a, const FingerJoint& b) {
    return grip_pull(a, finger.force_N) < grip_pull(b, finger.force_N);
  };
  return static_cast<std::size_t>(
      std::max_element(finger.joints.begin(), finger.joints.end(), asks_less) -
      finger.joints.begin());
}

double spring_energy(const HandFinger& finger, double share) {
  double energy_Nmm = 0;
  for (const FingerJoint& joint : finger.joints) {
    const double open = rad(-joint.rest_deg);
    const double closed = rad(share * joint.range_deg - joint.rest_deg);
    energy_Nmm += joint.spring_Nmm_rad * (closed * closed - open * open) / 2;
  }
  return energy_Nmm / 1000;
}

double motor_force(const HandFinger& finger, bool held, double pull_per_motor_N) {
  const double pull = held ? finger.grip_pull_N : std::max(finger.grip_pull_N, finger.close_pull_N);
  if (pull == 0) return 0;
  return pull_per_motor_N > 0 ? pull / pull_per_motor_N : std::numeric_limits<double>::infinity();
}

GripDemand grip_demand(const Hand& hand, const Network& network, const TensionState& state,
                       Grasp grasp) {
  const FingerArray pulls = pulls_by_finger(network, state);
  GripDemand demand{std::numeric_limits<double>::infinity(), 0, 1};
  for (int number = 1; number <= network.fingers; ++number) {
    const HandFinger& finger = hand.finger(number);
    const double pull = pulls[static_cast<std::size_t>(number)];
    demand.force_per_motor_N = std::min(demand.force_per_motor_N, pull * finger.force_per_pull);
    const double force = motor_force(finger, grasp.holds(number), pull);
    if (force > demand.motor_force_N) {
      demand.motor_force_N = force;
      demand.weakest = number;
    }
  }
  return demand;
}

}  // namespace reeve::core
