#include "core/hand_closing.hpp"

#include <cmath>

#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {

SlackOnTheWay::SlackOnTheWay(const Network& network, const Mechanics& mechanics, const Grasp& grasp)
    : plain_(mechanics) {
  if (mechanics.slack_mm.empty()) return;
  now_ = mechanics;
  for (const TendonSpan& tendon : network.tendons) {
    double taken_in = 0;
    double slack_mm = 0;
    std::size_t at = 0;
    for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
      if (network.segments[i].kind != SegmentKind::motor_side) continue;
      taken_in += end_travel(network, mechanics, grasp, i);
      slack_mm += mechanics.slack_mm[i];
      if (mechanics.slack_mm[i] > 0) at = i;
    }
    if (slack_mm == 0) continue;
    pulls_at_mm_[at] = slack_mm / taken_in;
    now_->slack_mm[at] = std::numeric_limits<double>::infinity();
  }
}

double SlackOnTheWay::next_mm() const {
  double next = std::numeric_limits<double>::infinity();
  for (const auto& [segment, left_mm] : pulls_at_mm_) next = std::min(next, left_mm);
  return next;
}

void SlackOnTheWay::travel(double way_mm) {
  for (auto pending = pulls_at_mm_.begin(); pending != pulls_at_mm_.end();) {
    pending->second -= way_mm;
    if (pending->second > 0) {
      ++pending;
      continue;
    }
    now_->slack_mm[pending->first] = 0;
    pending = pulls_at_mm_.erase(pending);
  }
}

bool opens_fingers(const Network& network, const Mechanics& mechanics, Grasp grasp,
                   Kinematics& kinematics, Motion& motion) {
  const auto is_back = [](double way) { return way < 0; };
  const auto& travels = grasp.carriages.over_D;
  const auto& spools = mechanics.spools;
  if (std::none_of(travels.begin(), travels.end(), is_back) &&
      std::none_of(spools.begin(), spools.end(), is_back)) {
    return false;
  }
  grasp.held = 0;
  kinematics.solve(network, mechanics, grasp, Direction::pull, motion);
  return motion.fault == TensionFault::finger_opens ||
         std::any_of(motion.closing.begin(), motion.closing.end(), is_back);
}

void add_strokes(const MotorGroup& group, const Grasp& grasp, double way_mm, HandClosing& closing) {
  const double blocked = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    const double travel = grasp.carriages.over_D[motor];
    if (!group.has_motor(motor) || travel == 0) continue;
    closing.strokes_mm[motor] = way_mm > 0 ? std::abs(travel) * way_mm : blocked;
    greatest = std::max(greatest, closing.strokes_mm[motor]);
  }
  closing.stroke_mm = greatest == blocked ? 0 : greatest;
}

HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       Kinematics& kinematics, Motion& motion, const Grasp& open) {
  return close_hand(hand, network, mechanics, open, kinematics, motion,
                    [](Grasp, double, double, const std::vector<double>&) {});
}

}  // namespace reeve::core
