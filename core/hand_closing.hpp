// How far the carriage travels until the hand is closed.
//
// A finger has closed when each of its strands has given up its excursion E. From the open hand the
// fingers close as the kinematics says (tension/kinematics.hpp), with shares by their excursions,
// so that the fingers of one tendon come to their ends together. Where they do not, those that have
// come to their ends are held from then on, and the others close further, until all have closed or
// the carriage is blocked: a tendon with nothing left to close blocks the carriage for all others.
//
//   stroke    D: the travel until then
//   closure   least share of its range that a finger has closed: 1 if nothing blocks the carriage
//
// Without blocks each tendon has 2 Σ E over its fingers (Σ E where a tendon is tied to the tip) for
// n_a motor-side segments; the stroke is the least of these quotients.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/hand.hpp"
#include "core/mechanics.hpp"
#include "core/performance.hpp"
#include "core/tension/kinematics.hpp"

namespace reeve::core {

struct HandClosing {
  double stroke_mm = 0;
  double closure = 0;
  FingerArray closed{};  // share of each finger's range, at its number
};

// Calls on_phase(grasp, travel in mm, closings per travel) for each stretch of the way in which the
// same fingers close. Keeps the memory of `motion`.
template <typename OnPhase>
HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       Kinematics& kinematics, Motion& motion, OnPhase on_phase) {
  // Of a finger's range; what is nearer to its end than this is rounding.
  constexpr double tolerance = 1e-9;
  HandClosing closing;
  Grasp at_end;
  for (int phase = 0; phase < network.fingers; ++phase) {
    kinematics.solve(network, mechanics, at_end, Direction::pull, motion);
    double travel = 0;
    for (int f = 1; f <= network.fingers; ++f) {
      const double way = motion.closing[static_cast<std::size_t>(f) - 1];
      if (!(way > tolerance) || at_end.holds(f)) continue;
      const double left =
          (1 - closing.closed[static_cast<std::size_t>(f)]) * hand.finger(f).excursion_mm / way;
      if (travel == 0 || left < travel) travel = left;
    }
    if (travel == 0) break;
    on_phase(at_end, travel, motion.closing);
    closing.stroke_mm += travel;
    for (int f = 1; f <= network.fingers; ++f) {
      double& closed = closing.closed[static_cast<std::size_t>(f)];
      closed +=
          travel * motion.closing[static_cast<std::size_t>(f) - 1] / hand.finger(f).excursion_mm;
      if (closed < 1 - tolerance) continue;
      closed = 1;
      at_end.held |= std::uint64_t{1} << (f - 1);
    }
  }
  closing.closure = 1;
  for (int f = 1; f <= network.fingers; ++f) {
    closing.closure = std::min(closing.closure, closing.closed[static_cast<std::size_t>(f)]);
  }
  return closing;
}

HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       Kinematics& kinematics, Motion& motion);

}  // namespace reeve::core
