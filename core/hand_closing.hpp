// Computes the carriage travel that closes the hand.
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
// A tendon with slack s, whose motor sides take in m D, closes nothing before D = s / m. What
// springs in series add to the stroke is in series_stretch.hpp.
//
// A locked end takes nothing in.
//
// With several motors this is D of each group of them (hand_pulls.hpp), whose carriages travel v_c
// D as the grasp says, in or out: a motor that lets an extensor out has a stroke, too. No group's
// carriages are blocked by another group.
//
// Without blocks each tendon has 2 Σ E over its fingers (Σ E where a tendon is tied to the tip) for
// n_a motor-side segments; the stroke is the least of these quotients.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "core/hand.hpp"
#include "core/mechanics.hpp"
#include "core/performance.hpp"
#include "core/tension/kinematics.hpp"

namespace reeve::core {

struct HandClosing {
  double stroke_mm = 0;  // greatest of the motors; 0 if a carriage is blocked from the open hand on
  double closure = 0;
  FingerArray closed{};     // share of each finger's range, at its number
  MotorArray strokes_mm{};  // of each motor; infinite if its carriage is blocked likewise
};

// SlackOnTheWay says which tendons are slack as the carriage travels.
class SlackOnTheWay {
 public:
  SlackOnTheWay(const Network& network, const Mechanics& mechanics, const Grasp& grasp);

  // Returns mechanics in which tendons that are slack now never pull, and the others have no slack.
  const Mechanics& mechanics() const { return now_ ? *now_ : plain_; }
  int tendons() const { return static_cast<int>(pulls_at_mm_.size()); }
  // Further travel until the next tendon pulls; infinite if none is slack.
  double next_mm() const;
  void travel(double way_mm);

 private:
  const Mechanics& plain_;
  std::optional<Mechanics> now_;
  std::map<std::size_t, double> pulls_at_mm_;  // further travel, by the segment that has the slack
};

// Closes the fingers of one group of motors and returns D. `at_end` is the grasp at the beginning.
template <typename OnPhase>
double close_fingers(const Hand& hand, const Network& network, const Mechanics& mechanics,
                     Grasp at_end, Kinematics& kinematics, Motion& motion, OnPhase on_phase,
                     FingerArray& closed_share) {
  // Share of a finger's range; a finger nearer to its end than this has reached it.
  constexpr double tolerance = 1e-9;
  constexpr double no_end = std::numeric_limits<double>::infinity();
  double way_mm = 0;
  SlackOnTheWay slack(network, mechanics, at_end);
  const int phases = network.fingers + slack.tendons();
  for (int phase = 0; phase < phases; ++phase) {
    kinematics.solve(network, slack.mechanics(), at_end, Direction::pull, motion);
    double travel = 0;
    for (int f = 1; f <= network.fingers; ++f) {
      const double way = motion.closing[static_cast<std::size_t>(f) - 1];
      if (!(way > tolerance) || at_end.holds(f)) continue;
      const double left =
          (1 - closed_share[static_cast<std::size_t>(f)]) * hand.finger(f).excursion_mm / way;
      if (travel == 0 || left < travel) travel = left;
    }
    const bool blocked = std::find(motion.jams.begin(), motion.jams.end(), 1) != motion.jams.end();
    const double until_pull = slack.next_mm();
    if (!blocked && until_pull < (travel == 0 ? no_end : travel)) travel = until_pull;
    if (travel == 0) break;
    slack.travel(travel);
    on_phase(at_end, way_mm, travel, motion.closing);
    way_mm += travel;
    for (int f = 1; f <= network.fingers; ++f) {
      double& closed = closed_share[static_cast<std::size_t>(f)];
      closed +=
          travel * motion.closing[static_cast<std::size_t>(f) - 1] / hand.finger(f).excursion_mm;
      if (closed < 1 - tolerance) continue;
      closed = 1;
      at_end.held |= std::uint64_t{1} << (f - 1);
    }
  }
  return way_mm;
}

// True if some finger of the open hand would have to open further: an extensor pulls it, or its
// flexors are let out. Such a grasp grips nothing.
bool opens_fingers(const Network& network, const Mechanics& mechanics, Grasp grasp,
                   Kinematics& kinematics, Motion& motion);

void add_strokes(const MotorGroup& group, const Grasp& grasp, double way_mm, HandClosing& closing);

// Calls on_phase(grasp, D before, travel in mm, closings per travel) for each stretch of the way in
// which the same fingers close, group of motors by group. `open` holds no finger: it says how
// carriages travel and which ends are locked. Keeps the memory of `motion`.
template <typename OnPhase>
HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       const Grasp& open, Kinematics& kinematics, Motion& motion,
                       OnPhase on_phase) {
  HandClosing closing;
  const MotorGroups groups = motor_groups(network);
  for (const MotorGroup& group : groups) {
    const Grasp alone = pulling_alone(group, groups, open);
    const double way_mm = close_fingers(hand, network, mechanics, alone, kinematics, motion,
                                        on_phase, closing.closed);
    add_strokes(group, alone, way_mm, closing);
  }
  closing.closure = 1;
  for (int f = 1; f <= network.fingers; ++f) {
    closing.closure = std::min(closing.closure, closing.closed[static_cast<std::size_t>(f)]);
  }
  return closing;
}

HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       Kinematics& kinematics, Motion& motion, const Grasp& open = {});

}  // namespace reeve::core
