// Hands for tests, with numbers that no two joints share.
#pragma once

#include <vector>

#include "core/hand_pulls.hpp"
#include "core/hardware.hpp"

namespace reeve::testing {

// Three joints with springs and a posture of their own.
inline FingerParts three_joint_finger() {
  return {{{10, 80, 82, 12, -20, 55}, {8, 90, 44, 10, -15, 45}, {6, 55, 22, 8, -10, {}}}, 5.0};
}

// One joint without a spring: the fingertip force is arm over lever times the pull.
inline FingerParts simple_finger(double arm_mm, double range_deg, double lever_mm, double force_N) {
  return {{{arm_mm, range_deg, lever_mm}}, force_N};
}

// Fingers 1 … n of these parts, on the paper's contacts.
inline Hardware hand_of(const std::vector<FingerParts>& fingers) {
  Hardware hardware;
  for (const FingerParts& parts : fingers) {
    FingerHardware finger;
    finger.finger = static_cast<int>(hardware.fingers.size()) + 1;
    finger.parts = parts;
    hardware.fingers.push_back(finger);
  }
  return hardware;
}

inline HandPulls pulls_in(const Network& network, const Mechanics& mechanics, const Grasp& grasp) {
  TensionState state;
  return hand_pulls(network, grasp, [&](const Grasp& alone) {
    state = tensions(network, mechanics, alone);
    return SolvedGrasp{state, mechanics};
  });
}

}  // namespace reeve::testing
