#include "core/hand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace reeve::core {
namespace {

double spring_torque(const FingerJoint& joint, double flexion_deg) {
  return joint.spring_Nmm_rad * in_rad(flexion_deg - joint.rest_deg);
}

double holding_torque(const FingerJoint& joint) {
  return spring_torque(joint, joint.held_flexion_deg());
}

std::vector<JointDemand> demands_of(const std::vector<FingerJoint>& joints, double force_N) {
  std::vector<JointDemand> demands;
  double held_phi = 0;
  double closed_phi = 0;
  for (const FingerJoint& joint : joints) {
    held_phi += guide_exponent(joint, in_rad(joint.held_flexion_deg()));
    closed_phi += guide_exponent(joint, in_rad(joint.range_deg));
    demands.push_back({(joint.lever_mm * force_N + holding_torque(joint)) / joint.arm_mm,
                       spring_torque(joint, joint.range_deg) / joint.arm_mm,
                       joint.arm_mm / joint.lever_mm, std::exp(-held_phi), std::exp(-closed_phi)});
  }
  return demands;
}

HandFinger finger_of(const FingerParts& parts, const Hardware& hardware) {
  HandFinger finger;
  finger.joints = with_guide_coefficients(parts.joints, hardware);
  finger.is_known = !parts.joints.empty() && parts.force_N;
  finger.force_N = parts.force_N.value_or(0);
  finger.demands = demands_of(finger.joints, finger.force_N);
  for (const FingerJoint& joint : finger.joints) {
    finger.excursion_mm += joint.arm_mm * in_rad(joint.range_deg);
  }
  return finger;
}

FingerPull closed_pull(const HandFinger& finger, const FingerPull& pull) {
  if (!has_guides(finger.joints)) return pull;
  const JointDemand& last = finger.demands.back();
  return pull.in_posture(last.closed_decay / last.held_decay);
}

// A joint asks this of the motor: nothing where its need is met without any pull.
double force_for(double need_N, double pull_per_motor) {
  if (need_N <= 0) return 0;
  return pull_per_motor > 0 ? need_N / pull_per_motor : std::numeric_limits<double>::infinity();
}

// Returns the carriage travel in a grasp until one of its fingers comes to its end.
double travel_to_first_end(const Hand& hand, int fingers, const HandPulls& pulls) {
  double travel_mm = std::numeric_limits<double>::infinity();
  for (int number = 1; number <= fingers; ++number) {
    const double closing = pulls.closings[static_cast<std::size_t>(number)];
    if (closing > 0) travel_mm = std::min(travel_mm, hand.finger(number).excursion_mm / closing);
  }
  return travel_mm;
}

// If no force is enough for a finger, none of any of its motors is.
void add_motor_forces(double hardest_N, const HandPulls& pulls, int finger, MotorArray& forces_N) {
  const MotorGroup& group = pulls.groups[static_cast<std::size_t>(finger)];
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (!group.has_motor(motor)) continue;
    const double force = std::isfinite(hardest_N) ? hardest_N * pulls.ratios[motor] : hardest_N;
    forces_N[motor] = std::max(forces_N[motor], force);
  }
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
    hand.fingers.push_back(finger_of(finger_parts(hardware, number), hardware));
  }
  return hand;
}

Hand without_guides(const Hand& hand) {
  Hand result = hand;
  for (HandFinger& finger : result.fingers) {
    finger.joints = without_guides(std::move(finger.joints));
    finger.demands = demands_of(finger.joints, finger.force_N);
  }
  return result;
}

int first_unknown_finger(const Hand& hand, int fingers) {
  for (int number = 1; number <= fingers; ++number) {
    if (!hand.finger(number).is_known) return number;
  }
  return 0;
}

HeldForce held_force(const HandFinger& finger, const FingerPull& per_motor, double motor_N) {
  HeldForce held{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t j = 0; j < finger.joints.size(); ++j) {
    const FingerJoint& joint = finger.joints[j];
    const double pull_N = per_motor.behind_guide_N(finger.demands[j].held_decay) * motor_N;
    const double force = (joint.arm_mm * pull_N - holding_torque(joint)) / joint.lever_mm;
    if (force < held.force_N) held = {force, j};
  }
  held.force_N = std::max(held.force_N, 0.0);
  return held;
}

double force_without_springs(const HandFinger& finger, const FingerPull& pull) {
  double force = std::numeric_limits<double>::infinity();
  for (const JointDemand& joint : finger.demands) {
    force = std::min(force, pull.behind_guide_N(joint.held_decay) * joint.arm_over_lever);
  }
  return std::max(force, 0.0);
}

bool closes_springs(const HandFinger& finger, const FingerPull& per_motor, double motor_N) {
  const FingerPull closed = closed_pull(finger, per_motor);
  return std::all_of(finger.demands.begin(), finger.demands.end(), [&](const JointDemand& joint) {
    return closed.behind_guide_N(joint.closed_decay) * motor_N >= joint.close_N;
  });
}

double working_pull(const HandFinger& finger, const FingerPull& pull) {
  if (!has_guides(finger.joints)) return pull.sum_N();
  double work_Nmm = 0;
  for (std::size_t j = 0; j < finger.joints.size(); ++j) {
    const FingerJoint& joint = finger.joints[j];
    work_Nmm +=
        pull.behind_guide_N(finger.demands[j].held_decay) * joint.arm_mm * in_rad(joint.range_deg);
  }
  return work_Nmm / finger.excursion_mm;
}

double spring_energy(const HandFinger& finger, double share) {
  double energy_Nmm = 0;
  for (const FingerJoint& joint : finger.joints) {
    const double open = in_rad(-joint.rest_deg);
    const double closed = in_rad(share * joint.range_deg - joint.rest_deg);
    energy_Nmm += joint.spring_Nmm_rad * (closed * closed - open * open) / 2;
  }
  return energy_Nmm / 1000;
}

AskedForce asked_force(const HandFinger& finger, bool held, const FingerPull& pull_per_motor) {
  const FingerPull closed = closed_pull(finger, pull_per_motor);
  AskedForce most;
  for (std::size_t j = 0; j < finger.demands.size(); ++j) {
    const JointDemand& joint = finger.demands[j];
    double force = force_for(joint.grip_N, pull_per_motor.behind_guide_N(joint.held_decay));
    if (!held) {
      const double closing = force_for(joint.close_N, closed.behind_guide_N(joint.closed_decay));
      force = std::max(force, closing);
    }
    if (force > most.motor_N) most = {force, j};
  }
  return most;
}

double motor_force(const HandFinger& finger, bool held, const FingerPull& pull_per_motor) {
  return asked_force(finger, held, pull_per_motor).motor_N;
}

GripDemand grip_demand(const Hand& hand, int fingers, const HandPulls& pulls, Grasp grasp) {
  GripDemand demand{std::numeric_limits<double>::infinity(), 0, 1, {}, pulls.stretch};
  for (int number = 1; number <= fingers; ++number) {
    const HandFinger& finger = hand.finger(number);
    const FingerPull& pull = pulls.fingers[static_cast<std::size_t>(number)];
    demand.force_per_motor_N =
        std::min(demand.force_per_motor_N, force_without_springs(finger, pull));
    const double force = motor_force(finger, grasp.holds(number), pull);
    if (force > demand.motor_force_N) {
      demand.motor_force_N = force;
      demand.weakest = number;
    }
    add_motor_forces(force, pulls, number, demand.motors_N);
  }
  if (demand.stretch.sliding_mm_N > 0) {
    demand.stretch.most_N = travel_to_first_end(hand, fingers, pulls) / demand.stretch.sliding_mm_N;
  }
  return demand;
}

}  // namespace reeve::core
