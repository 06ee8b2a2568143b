// Computes how the motors pull the fingers of a hand in one grasp.
//
// Tendons, blocks and bars join the motors on whose carriages they hang. Such a group pulls
// together, its tensions in the ratio of tension/tension.hpp. Two groups have nothing in common, so
// each pulls with a force of its own, and no jam of one stops the other: it is solved while the
// carriages of the others stand still.
//
// Pulls are per newton of the motor that pulls hardest in the finger's group. At a force F of that
// motor, motor c pulls with its ratio times F, and none with more than F. With one motor this is
// per newton of T_M.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/finger_guides.hpp"
#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/series_stretch.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

// One value for each of motors 1 … n, at its number less 1.
using MotorArray = std::array<double, max_carriages>;

struct MotorGroup {
  std::uint8_t motors = 0;    // bit c-1: motor c
  std::uint64_t fingers = 0;  // bit f-1: finger f

  bool has_motor(std::size_t number_less_1) const { return (motors >> number_less_1 & 1U) != 0; }
  bool has_finger(int finger) const { return (fingers >> (finger - 1) & 1U) != 0; }
};

struct MotorGroups {
  std::array<MotorGroup, max_carriages> groups{};
  std::size_t count = 0;

  const MotorGroup* begin() const { return groups.data(); }
  const MotorGroup* end() const { return groups.data() + count; }
};

MotorGroups motor_groups(const Network& network);

// The grasp in which the carriages of the other groups stand still.
Grasp pulling_alone(const MotorGroup& group, const MotorGroups& groups, Grasp grasp);

struct HandPulls {
  FingerPullArray fingers{};
  std::array<MotorGroup, max_fingers + 1> groups{};  // group of each finger, at its number
  MotorArray ratios{};      // tension of each motor; 0 of all motors of a group that stands still
  SeriesStretch stretch{};  // of the springs in series with tendons
  FingerArray closings{};   // of the fingers, per travel of the carriage

  // Returns the pull of the hardest motor at which no motor of the finger's group pulls with more
  // than its own of these forces; 0 if none pulls.
  double hardest_pull_N(int finger, const MotorArray& forces_N) const;
};

// A state, and the mechanics with the exponents that it was solved with.
struct SolvedGrasp {
  const TensionState& state;
  const Mechanics& mechanics;
};

// True if some end of the group moves.
bool is_driven(const Network& network, const MotorGroup& group, const Grasp& grasp);
void add_pulls(const Network& network, const MotorGroup& group, const SolvedGrasp& solved,
               HandPulls& pulls);

// `solve(grasp)` returns a SolvedGrasp.
template <typename Solve>
HandPulls hand_pulls(const Network& network, const Grasp& grasp, Solve solve) {
  HandPulls pulls;
  const MotorGroups groups = motor_groups(network);
  for (const MotorGroup& group : groups) {
    for (int f = 1; f <= network.fingers; ++f) {
      if (group.has_finger(f)) pulls.groups[static_cast<std::size_t>(f)] = group;
    }
    if (!is_driven(network, group, grasp)) continue;
    const Grasp alone = pulling_alone(group, groups, grasp);
    const SolvedGrasp solved = solve(alone);
    add_pulls(network, group, solved, pulls);
    pulls.stretch = series_stretch(network, solved.mechanics, alone, solved.state);
  }
  return pulls;
}

}  // namespace reeve::core
