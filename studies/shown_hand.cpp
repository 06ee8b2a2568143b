#include "studies/shown_hand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "causes/model_solver.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::studies {
namespace {

constexpr double mm_in_m = 1000;

Mechanics without_friction(Mechanics mechanics) {
  mechanics.phi.assign(mechanics.phi.size(), 0.0);
  mechanics.decay.assign(mechanics.decay.size(), 1.0);
  return mechanics;
}

ShownHandGrasp shown_grasp(const Hand& hand, const Network& network, const Mechanics& mechanics,
                           const TensionState& state, Grasp grasp) {
  const GripDemand demand = grip_demand(hand, network, mechanics, state, grasp);
  const FingerPullArray pulls = finger_pulls_of(network, mechanics, state);
  ShownHandGrasp shown{grasp, demand.motor_force_N, 0, demand.weakest, {}};
  for (int f = 1; f <= network.fingers; ++f) {
    const HandFinger& finger = hand.finger(f);
    ShownFingerForce force;
    force.finger = f;
    force.pull_per_motor = pulls[static_cast<std::size_t>(f)];
    force.per_motor_N = force_without_springs(finger, force.pull_per_motor);
    force.asks_motor_N = motor_force(finger, grasp.holds(f), force.pull_per_motor);
    if (const auto limit = hand.motor.force_N) {
      force.at_limit_N = held_force(finger, force.pull_per_motor, *limit).force_N;
    }
    shown.fingers.push_back(force);
  }
  return shown;
}

// Adds the greatest demand of the grasps, with its finger and joint.
void add_greatest_force(const Hand& hand, const std::vector<ShownHandGrasp>& grasps,
                        MotorDemand& demand) {
  FingerPull pull;
  for (const ShownHandGrasp& shown : grasps) {
    demand.frictionless_N = std::max(demand.frictionless_N, shown.frictionless_N);
    if (demand.weakest > 0 && !(shown.motor_force_N > demand.force_N)) continue;
    demand.force_N = shown.motor_force_N;
    demand.weakest = shown.weakest;
    demand.grasp = shown.grasp;
    pull = shown.fingers[static_cast<std::size_t>(shown.weakest) - 1].pull_per_motor;
  }
  // The force is rounded as the objective motor_force, so that both are the same number.
  demand.force_N = on_grid(demand.force_N);
  demand.joint = asking_joint(hand.finger(demand.weakest), pull);
}

void add_motion(const MotorParts& motor, MotorDemand& demand) {
  demand.speed_mm_s = demand.stroke_mm / motor.close_s;
  demand.work_J = demand.force_N * demand.stroke_mm / mm_in_m;
  demand.power_W = demand.work_J / motor.close_s;
  if (!motor.spool_radius_mm) return;
  constexpr double s_in_min = 60;
  demand.torque_Nm = demand.force_N * *motor.spool_radius_mm / mm_in_m;
  demand.spool_rpm = s_in_min * demand.speed_mm_s / (2 * std::numbers::pi * *motor.spool_radius_mm);
}

bool is_worth_closing(const std::vector<FingerJoint>& joints) {
  return has_guides(joints) || std::ranges::any_of(joints, [](const FingerJoint& joint) {
           return joint.object_deg.has_value();
         });
}

std::vector<ShownClosing> shown_closings(const Hand& hand, int fingers) {
  constexpr int steps = 20;
  std::vector<ShownClosing> closings;
  for (int f = 1; f <= fingers; ++f) {
    const std::vector<FingerJoint>& joints = hand.finger(f).joints;
    if (!is_worth_closing(joints)) continue;
    const auto alike =
        std::ranges::find_if(closings, [&](const ShownClosing& c) { return c.joints == joints; });
    if (alike != closings.end()) {
      alike->fingers.push_back(f);
    } else {
      closings.push_back({{f}, joints, close_finger(joints, steps)});
    }
  }
  return closings;
}

// One routing of one hand, solved grasp by grasp.
class HandStudy {
 public:
  HandStudy(const Hand& hand, const Network& network, const std::string& word, const Model& model)
      : hand_(hand),
        ideal_hand_(without_guides(hand)),
        network_(network),
        word_(word),
        model_(model),
        plain_(mechanics(network, possible_hardware(model))),
        frictionless_(without_friction(plain_)),
        solver_(model, possible_hardware(model), word, network) {}

  ShownHand run(const GraspSet& grasps) {
    ShownHand shown;
    shown.motor = hand_.motor;
    for (const WeightedGrasp& weighted : grasps) {
      const TensionState& state = pulled(weighted.grasp);
      shown.grasps.push_back(shown_grasp(hand_, network_, solver_.solved(), state, weighted.grasp));
      const TensionState ideal = tensions(network_, frictionless_, weighted.grasp);
      shown.grasps.back().frictionless_N =
          grip_demand(ideal_hand_, network_, frictionless_, ideal, weighted.grasp).motor_force_N;
    }
    add_reach(grasps, shown);
    add_greatest_force(hand_, shown.grasps, shown.demand);
    add_forces(shown);
    add_closing(shown);
    shown.closings = shown_closings(hand_, network_.fingers);
    return shown;
  }

 private:
  const TensionState& pulled(Grasp grasp) {
    return require_in_range(solver_.solve(grasp, Direction::pull, model_.conditions), grasp);
  }

  FingerPullArray pulls_in(Grasp grasp) {
    const TensionState& state = pulled(grasp);
    return finger_pulls_of(network_, solver_.solved(), state);
  }

  void add_reach(const GraspSet& grasps, ShownHand& shown) {
    if (const auto force = hand_.motor.force_N) {
      ForceReach& reach = shown.force_reach.emplace();
      reach.motor_N = *force;
      reach.share = std::numeric_limits<double>::infinity();
      for (const WeightedGrasp& weighted : grasps) {
        const FingerPullArray pulls = pulls_in(weighted.grasp);
        add_grasp(hand_, network_.fingers, weighted.grasp, pulls, reach);
      }
    }
    if (const auto stroke = hand_.motor.stroke_mm) {
      shown.stroke_reach = stroke_reach(hand_, network_, plain_, *stroke);
    }
  }

  void add_forces(ShownHand& shown) const {
    if (!std::isfinite(shown.demand.force_N)) return;
    for (ShownHandGrasp& grasp : shown.grasps) {
      for (ShownFingerForce& force : grasp.fingers) {
        const HeldForce held =
            held_force(hand_.finger(force.finger), force.pull_per_motor, shown.demand.force_N);
        force.force_N = held.force_N;
        force.gives = held.joint;
      }
    }
  }

  void add_closing(ShownHand& shown) {
    Kinematics kinematics;
    Motion motion;
    double to_fingers = 0;  // J per N of motor tension
    double before_mm = 0;
    const HandClosing closing = close_hand(
        hand_, network_, plain_, kinematics, motion,
        [&](Grasp at_end, double travel_mm, const std::vector<double>& closings) {
          // How tendons behind slack share the carriage changes on the way: as in its middle.
          Mechanics there = plain_;
          there.travel_mm = before_mm + travel_mm / 2;
          before_mm += travel_mm;
          if (*std::ranges::max_element(closings) == 0) return;
          solver_.set_routing(word_, network_, there);
          const FingerPullArray pulls = pulls_in(at_end);
          for (std::size_t f = 0; f < closings.size(); ++f) {
            const HandFinger& finger = hand_.finger(static_cast<int>(f) + 1);
            to_fingers += working_pull(finger, pulls[f + 1]) * closings[f] * travel_mm / mm_in_m;
          }
        });
    MotorDemand& demand = shown.demand;
    demand.stroke_mm = closing.stroke_mm;
    demand.closure = closing.closure;
    add_motion(hand_.motor, demand);
    for (int f = 1; f <= network_.fingers; ++f) {
      const HandFinger& finger = hand_.finger(f);
      const double closed = closing.closed[static_cast<std::size_t>(f)];
      shown.fingers.push_back({f, finger.force_N, finger.excursion_mm, closed});
      demand.springs_J += spring_energy(finger, closed);
    }
    demand.friction_J = demand.work_J - demand.force_N * to_fingers;
    demand.fingers_J = demand.force_N * to_fingers - demand.springs_J;
  }

  const Hand& hand_;
  Hand ideal_hand_;  // without friction
  const Network& network_;
  const std::string& word_;
  const Model& model_;
  Mechanics plain_;
  Mechanics frictionless_;
  ModelSolver solver_;
};

}  // namespace

void add_grasp(const Hand& hand, int fingers, Grasp grasp, const FingerPullArray& pulls,
               ForceReach& reach) {
  for (int f = 1; f <= fingers; ++f) {
    const HandFinger& finger = hand.finger(f);
    const FingerPull& pull_per_motor = pulls[static_cast<std::size_t>(f)];
    const HeldForce held = held_force(finger, pull_per_motor, reach.motor_N);
    const bool closes = grasp.holds(f) || closes_springs(finger, pull_per_motor, reach.motor_N);
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
  const double least = *std::ranges::min_element(reach.closed);
  for (std::size_t f = 0; f < reach.closed.size(); ++f) {
    if (reach.closed[f] <= least + rounding) reach.last.push_back(static_cast<int>(f) + 1);
  }
  reach.closure = least > 1 - rounding ? 1 : least;
  return reach;
}

std::optional<ShownHand> shown_hand(const Network& network, const std::string& word,
                                    const Model& model, const GraspSet& grasps) {
  const auto known = hand(model.hardware);
  const bool is_known = known && first_unknown_finger(*known, network.fingers) == 0;
  if (!is_known || network.fingers == 0) return std::nullopt;
  return HandStudy(*known, network, word, model).run(grasps);
}

}  // namespace reeve::studies
