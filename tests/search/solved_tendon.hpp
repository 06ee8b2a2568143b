// Hardware in which no two lengths are alike, and a tree's sums as the solver finds them.
#pragma once

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/shared_states.hpp"

namespace reeve::testing {

inline Hardware with_friction(double tube, double bearing, double sheath) {
  Hardware hardware;
  hardware.tube.mu = tube;
  hardware.bearing.mu = bearing;
  hardware.sheath.mu = sheath;
  hardware.strand_mm = 71;
  hardware.motor_side_mm = 260;
  hardware.hand_mm = 17;
  return hardware;
}

inline TreeSums solved_sums(const Hardware& hardware, const Network& network, int held) {
  TensionSolver solver;
  TensionState state;
  const Grasp grasp{held == 0 ? 0 : std::uint64_t{1} << (held - 1)};
  solver.solve_relative(network, mechanics(network, hardware), grasp, Direction::pull, state);
  return sums_of(network, state);
}

}  // namespace reeve::testing
