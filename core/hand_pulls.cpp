#include "core/hand_pulls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/motor_sides.hpp"

namespace reeve::core {
namespace {

void add_tendon(const Network& network, const TendonSpan& tendon, MotorGroup& group) {
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::motor_side) {
      group.motors = static_cast<std::uint8_t>(group.motors | 1U << (segment.carriage - 1));
    }
    if (segment.kind == SegmentKind::strand) {
      group.fingers |= std::uint64_t{1} << (segment.finger - 1);
    }
  }
}

// Joins the groups that share a motor or a finger with the new one.
void add_group(MotorGroup added, MotorGroups& found) {
  const auto joins = [&](const MotorGroup& group) {
    if ((group.motors & added.motors) == 0 && (group.fingers & added.fingers) == 0) return false;
    added.motors |= group.motors;
    added.fingers |= group.fingers;
    return true;
  };
  MotorGroup* const first = found.groups.data();
  found.count = static_cast<std::size_t>(std::remove_if(first, first + found.count, joins) - first);
  found.groups[found.count++] = added;
}

// Returns the tension of the motor that pulls hardest: exactly 1 with one motor.
double hardest(const MotorGroup& group, const TensionState& state) {
  double most = 0;
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (group.has_motor(motor)) most = std::max(most, state.motor_tension[motor]);
  }
  return most;
}

}  // namespace

MotorGroups motor_groups(const Network& network) {
  MotorGroups found;
  for (std::size_t tree = 0; tree < network.tendons.size(); ++tree) {
    MotorGroup group;
    for (const TendonSpan& tendon : network.tendons) {
      if (tendon.tree == tree) add_tendon(network, tendon, group);
    }
    if (group.motors != 0) add_group(group, found);
  }
  return found;
}

Grasp pulling_alone(const MotorGroup& group, const MotorGroups& groups, Grasp grasp) {
  if (groups.count < 2) return grasp;
  grasp.carriages.given = 0;
  for (const MotorGroup& other : groups) {
    for (std::size_t motor = 0; motor < max_carriages; ++motor) {
      if (!other.has_motor(motor)) continue;
      ++grasp.carriages.given;
      if (!group.has_motor(motor)) grasp.carriages.over_D[motor] = 0;
    }
  }
  return grasp;
}

double HandPulls::hardest_pull_N(int finger, const MotorArray& forces_N) const {
  double most = std::numeric_limits<double>::infinity();
  const MotorGroup& group = groups[static_cast<std::size_t>(finger)];
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (!group.has_motor(motor) || ratios[motor] == 0) continue;
    most = std::min(most, forces_N[motor] / ratios[motor]);
  }
  return std::isinf(most) ? 0 : most;
}

bool is_driven(const Network& network, const MotorGroup& group, const Grasp& grasp) {
  return std::any_of(network.segments.begin(), network.segments.end(), [&](const Segment& side) {
    return side.kind == SegmentKind::motor_side &&
           group.has_motor(static_cast<std::size_t>(side.carriage) - 1) &&
           !grasp.locks(side.number) && grasp.travel(side.carriage) != 0;
  });
}

void add_pulls(const Network& network, const MotorGroup& group, const SolvedGrasp& solved,
               HandPulls& pulls) {
  const double unit_N = hardest(group, solved.state);
  const FingerPullArray found = finger_pulls_of(network, solved.mechanics, solved.state);
  for (int f = 1; f <= network.fingers; ++f) {
    if (!group.has_finger(f)) continue;
    pulls.closings[static_cast<std::size_t>(f)] =
        solved.state.closing[static_cast<std::size_t>(f) - 1];
    // A tendon that opposes a finger's closing pulls as hard as those that close it.
    if (f == solved.state.opposed) continue;
    FingerPull& pull = pulls.fingers[static_cast<std::size_t>(f)];
    pull = found[static_cast<std::size_t>(f)];
    pull.left_N /= unit_N;
    pull.right_N /= unit_N;
  }
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (group.has_motor(motor)) pulls.ratios[motor] = solved.state.motor_tension[motor] / unit_N;
  }
}

}  // namespace reeve::core
