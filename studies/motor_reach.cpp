#include "studies/motor_reach.hpp"

#include <algorithm>

namespace reeve::studies {

void add_grasp(const Hand& hand, int fingers, Grasp grasp, const FingerArray& pulls,
               ForceReach& reach) {
  for (int f = 1; f <= fingers; ++f) {
    const HandFinger& finger = hand.finger(f);
    const double pull_per_motor = pulls[static_cast<std::size_t>(f)];
    const double pull = pull_per_motor * reach.motor_N;
    const HeldForce held = held_force(finger, pull);
    const bool closes = grasp.holds(f) || pull >= finger.close_pull_N;
    if (closes && finger.force_N == 0) continue;
    const double share = closes ? held.force_N / finger.force_N : 0;
    const double asks = motor_force(finger, grasp.holds(f), pull_per_motor);
    const bool has_more =
        share > reach.share || (share == reach.share && asks <= reach.asks_motor_N);
    if (reach.weakest > 0 && has_more) continue;
    reach.share = share;
    reach.asks_motor_N = asks;
    reach.weakest = f;
    reach.grasp = grasp;
    reach.joint = held.joint;
    reach.force_N = held.force_N;
  }
}

StrokeReach stroke_reach(const Hand& hand, const Network& network, const Mechanics& mechanics,
                         double limit_mm) {
  StrokeReach reach;
  reach.closed.assign(static_cast<std::size_t>(network.fingers), 0.0);
  Kinematics kinematics;
  Motion motion;
  close_hand(hand, network, mechanics, kinematics, motion,
             [&](Grasp, double travel_mm, const std::vector<double>& closings) {
               const double way = std::min(travel_mm, limit_mm - reach.stroke_mm);
               for (std::size_t f = 0; f < closings.size() && f < reach.closed.size(); ++f) {
                 const double excursion = hand.finger(static_cast<int>(f) + 1).excursion_mm;
                 reach.closed[f] = std::min(1.0, reach.closed[f] + way * closings[f] / excursion);
               }
               reach.stroke_mm += way;
             });
  // Sums of stretches miss the end, and each other, by a rounding error.
  constexpr double rounding = 1e-9;
  const double least = *std::min_element(reach.closed.begin(), reach.closed.end());
  for (std::size_t f = 0; f < reach.closed.size(); ++f) {
    if (reach.closed[f] <= least + rounding) reach.last.push_back(static_cast<int>(f) + 1);
  }
  reach.closure = least > 1 - rounding ? 1 : least;
  return reach;
}

}  // namespace reeve::studies
