// What a user says of a hand: the joints of its fingers and the motor that pulls them. Angles are
// flexions, 0 with the hand open. hand.hpp has the laws.
#pragma once

#include <optional>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// The same arm at each strand of the finger, and in every posture.
struct FingerJoint {
  double arm_mm = 0;          // of the tendon about the joint
  double range_deg = 0;       // from open to closed
  double lever_mm = 0;        // of the fingertip force about the joint, in the posture that holds
  double spring_Nmm_rad = 0;  // return spring: torque for each radian beyond its rest
  double rest_deg = 0;        // flexion at which the spring is slack; below 0: preloaded when open
  std::optional<double>
      held_deg{};  // flexion in the posture that holds; the whole range if not given

  friend bool operator==(const FingerJoint&, const FingerJoint&) = default;
};

// Of one finger, or of all that have none of their own.
struct FingerParts {
  std::vector<FingerJoint> joints{};  // from the palm to the tip
  std::optional<double> force_N{};    // wanted at the fingertip

  friend bool operator==(const FingerParts&, const FingerParts&) = default;
};

struct MotorParts {
  std::optional<double> spool_radius_mm{};
  double close_s = 1;  // time in which the hand is to close
  // What the motor can do.
  std::optional<double> force_N{};
  std::optional<double> stroke_mm{};

  friend bool operator==(const MotorParts&, const MotorParts&) = default;
};

}  // namespace reeve::core
