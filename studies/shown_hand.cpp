#include "studies/shown_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "causes/model_solver.hpp"
#include "core/motor_sides.hpp"
#include "core/tension/tree_kinematics.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::studies {
namespace {

constexpr double mm_in_m = 1000;
constexpr double rounding_of_work = 1e-12;  // share of it

Mechanics without_friction(Mechanics mechanics) {
  mechanics.phi.assign(mechanics.phi.size(), 0.0);
  mechanics.decay.assign(mechanics.decay.size(), 1.0);
  return mechanics;
}

ShownHandGrasp shown_grasp(const Hand& hand, int fingers, const HandPulls& pulls, Grasp grasp) {
  const GripDemand demand = grip_demand(hand, fingers, pulls, grasp);
  ShownHandGrasp shown{grasp,           demand.motor_force_N, 0, demand.weakest,
                       demand.motors_N, demand.stretch,       {}};
  for (int f = 1; f <= fingers; ++f) {
    const HandFinger& finger = hand.finger(f);
    ShownFingerForce force;
    force.finger = f;
    force.pull_per_motor = pulls.fingers[static_cast<std::size_t>(f)];
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
    for (std::size_t motor = 0; motor < max_carriages; ++motor) {
      demand.motors_N[motor] = std::max(demand.motors_N[motor], on_grid(shown.motors_N[motor]));
    }
    if (demand.weakest > 0 && !(shown.motor_force_N > demand.force_N)) continue;
    demand.force_N = shown.motor_force_N;
    demand.weakest = shown.weakest;
    demand.grasp = shown.grasp;
    pull = shown.fingers[static_cast<std::size_t>(shown.weakest) - 1].pull_per_motor;
  }
  // The force is rounded as the objective motor_force, so that both are the same number.
  demand.force_N = on_grid(demand.force_N);
  demand.joint =
      asked_force(hand.finger(demand.weakest), demand.grasp.holds(demand.weakest), pull).joint;
}

bool passes(const Network& network, const TendonSpan& tendon, int finger) {
  const auto first = network.segments.begin() + static_cast<std::ptrdiff_t>(tendon.first_segment);
  return std::any_of(
      first, first + static_cast<std::ptrdiff_t>(tendon.segments), [&](const Segment& segment) {
        return segment.kind == SegmentKind::strand && segment.finger == finger && !segment.extensor;
      });
}

// True if each tendon that blocks the carriage has a spring, whose stretch would let it go on.
bool is_blocked_at_springs(const TendonParts& tendons, const Motion& motion) {
  const auto has_spring = [&](std::size_t tendon) {
    return std::ranges::any_of(tendons.own, [&](const TendonHardware& own) {
      return own.stiffness_N_mm && static_cast<std::size_t>(own.tendon) == tendon + 1;
    });
  };
  for (std::size_t t = 0; t < motion.jams.size(); ++t) {
    if (motion.jams[t] != 0 && !has_spring(t)) return false;
  }
  return true;
}

NoPull no_pull(const Network& network, const Mechanics& mechanics, const TendonParts& tendons,
               const Grasp& grasp, int finger) {
  const auto own = std::ranges::find_if(
      network.tendons, [&](const TendonSpan& tendon) { return passes(network, tendon, finger); });
  if (own == network.tendons.end()) return NoPull::opposed;
  bool all_locked = true;
  bool all_still = true;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != own->tree) continue;
    for (std::size_t i = 0; i < tendon.segments; ++i) {
      const std::size_t at = tendon.first_segment + i;
      if (network.segments[at].kind != SegmentKind::motor_side) continue;
      all_locked &= grasp.locks(network.segments[at].number);
      all_still &= end_travel(network, mechanics, grasp, at) == 0;
    }
  }
  if (all_locked) return NoPull::ends_locked;
  if (all_still) return NoPull::ends_stand_still;
  const bool has_extensor = std::ranges::any_of(network.segments, [&](const Segment& segment) {
    return segment.kind == SegmentKind::strand && segment.finger == finger && segment.way() < 0;
  });
  if (has_extensor) return NoPull::opposed;
  Motion motion;
  Kinematics().solve(network, mechanics, grasp, Direction::pull, motion);
  const auto at = static_cast<std::size_t>(own - network.tendons.begin());
  if (motion.is_slack(at)) return NoPull::still_slack;
  return is_blocked_at_springs(tendons, motion) ? NoPull::blocked_at_springs : NoPull::blocked;
}

// Springs in series lengthen all strokes, or none.
void count_stretch(MotorDemand& demand) {
  const bool counts = std::ranges::all_of(demand.ways, [&](const ShownWay& way) {
    return is_counted(way.stretch, demand.closure, demand.force_N);
  });
  if (!counts) {
    for (ShownWay& way : demand.ways) way.stretch = {};
    return;
  }
  const ShownWay& longest = *std::ranges::max_element(
      demand.ways, {}, [&](const ShownWay& way) { return way.stroke_mm(demand.force_N); });
  demand.stretch = longest.stretch;
  demand.strokes_mm.front() = longest.stroke_mm(demand.force_N);
}

double work_J(const ShownWay& way, const MotorDemand& demand) {
  double work_J = demand.stretch ? way.stretch.work_J(demand.force_N) : 0;
  for (std::size_t m = 0; m < max_carriages; ++m) {
    if (way.loaded_mm[m] > 0) work_J += demand.motors_N[m] * way.loaded_mm[m] / mm_in_m;
  }
  return work_J;
}

// Returns the stroke at the motor's force; nothing if not every finger closes by it.
std::optional<double> reached_stroke_mm(const ShownHand& shown, double motor_N) {
  const bool is_known = !shown.leaves_out_springs() && shown.demand.can_move();
  if (!is_known || shown.force_reach->share == 0) return std::nullopt;
  double most_mm = 0;
  for (const ShownWay& way : shown.demand.ways) {
    if (motor_N > way.stretch.most_N) return std::nullopt;
    most_mm = std::max(most_mm, way.stroke_mm(motor_N));
  }
  return most_mm;
}

void add_motion(const MotorParts& motor, MotorDemand& demand) {
  for (std::size_t m = 0; m < max_carriages; ++m) {
    const double stroke_mm = demand.strokes_mm[m];
    demand.stroke_mm = std::max(demand.stroke_mm, stroke_mm);
    if (std::isinf(stroke_mm)) continue;
    demand.power_W += demand.motors_N[m] * stroke_mm / mm_in_m / motor.close_s;
  }
  if (!std::isfinite(demand.stroke_mm)) demand.stroke_mm = 0;
  demand.speed_mm_s = demand.stroke_mm / motor.close_s;
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
    const auto alike = std::ranges::find(closings, joints, &ShownClosing::joints);
    if (alike != closings.end()) {
      alike->fingers.push_back(f);
    } else {
      closings.push_back({{f}, joints, close_finger(joints, steps)});
    }
  }
  return closings;
}

// Travel of the fastest carriage over D, in or out.
double fastest(const CarriageTravels& carriages) {
  double most = carriages.given == 0 ? 1 : 0;
  for (std::size_t motor = 0; motor < carriages.given; ++motor) {
    most = std::max(most, std::abs(carriages.over_D[motor]));
  }
  return most;
}

// The motors stop when one of a group has used its stroke up.
StrokeReach reach_from(const Grasp& open, const Hand& hand, const Network& network,
                       const Mechanics& mechanics, double limit_mm) {
  StrokeReach reach;
  reach.closed.assign(static_cast<std::size_t>(network.fingers), 0.0);
  Kinematics kinematics;
  Motion motion;
  double used_mm = 0;
  close_hand(
      hand, network, mechanics, open, kinematics, motion,
      [&](Grasp grasp, double before_mm, double travel_mm, const std::vector<double>& closings) {
        if (before_mm == 0) used_mm = 0;
        const double most = fastest(grasp.carriages);
        const double way = std::min(travel_mm, limit_mm / most - used_mm);
        for (std::size_t f = 0; f < closings.size() && f < reach.closed.size(); ++f) {
          const double excursion = hand.finger(static_cast<int>(f) + 1).excursion_mm;
          reach.closed[f] = std::min(1.0, reach.closed[f] + way * closings[f] / excursion);
        }
        used_mm += way;
        reach.stroke_mm = std::max(reach.stroke_mm, most * used_mm);
      });
  return reach;
}

void find_last(StrokeReach& reach) {
  // Sums of stretches miss the end, and each other, by a rounding error.
  constexpr double rounding = 1e-9;
  const double least = *std::ranges::min_element(reach.closed);
  for (std::size_t f = 0; f < reach.closed.size(); ++f) {
    if (reach.closed[f] <= least + rounding) reach.last.push_back(static_cast<int>(f) + 1);
  }
  reach.closure = least > 1 - rounding ? 1 : least;
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

  struct Sorted {
    GraspSet gripping;
    GraspSet opening;
  };
  Sorted sorted(const GraspSet& grasps) const {
    Sorted sorted;
    Kinematics kinematics;
    Motion motion;
    for (const WeightedGrasp& each : grasps) {
      const bool opens = opens_fingers(network_, plain_, each.grasp, kinematics, motion);
      (opens ? sorted.opening : sorted.gripping).push_back(each);
    }
    return sorted;
  }

  ShownHand run(const GraspSet& grasps) {
    ShownHand shown;
    shown.motor = hand_.motor;
    shown.motors = carriage_count(network_);
    shown.springs = !plain_.springs_mm.empty();
    if (shares_slack(network_, plain_)) shown.slack_shared_at_mm = plain_.travel_mm;
    for (const WeightedGrasp& weighted : grasps) {
      shown.grasps.push_back(
          shown_grasp(hand_, network_.fingers, pulls_in(weighted.grasp), weighted.grasp));
      shown.grasps.back().frictionless_N = frictionless_force_N(weighted.grasp);
    }
    add_force_reach(grasps, shown);
    add_greatest_force(hand_, shown.grasps, shown.demand);
    shown.demand.no_pull =
        no_pull(network_, plain_, model_.hardware.tendon, shown.demand.grasp, shown.demand.weakest);
    add_forces(shown);
    add_closing(grasps, shown);
    add_stroke_reach(shown);
    if (shown.force_reach)
      shown.force_reach->stroke_mm = reached_stroke_mm(shown, shown.force_reach->motor_N);
    if (shown.motors > 1) shown.motors_alone = closings_of_each_motor(shown.motors);
    shown.closings = shown_closings(hand_, network_.fingers);
    return shown;
  }

 private:
  HandPulls pulls_in(const Grasp& grasp) {
    return hand_pulls(network_, grasp, [&](const Grasp& alone) {
      const TensionState& state =
          require_in_range(solver_.solve(alone, Direction::pull, model_.conditions), alone);
      return SolvedGrasp{state, solver_.solved()};
    });
  }

  double frictionless_force_N(const Grasp& grasp) const {
    TensionState state;
    const HandPulls pulls = hand_pulls(network_, grasp, [&](const Grasp& alone) {
      state = tensions(network_, frictionless_, alone);
      return SolvedGrasp{state, frictionless_};
    });
    return grip_demand(ideal_hand_, network_.fingers, pulls, grasp).motor_force_N;
  }

  void add_force_reach(const GraspSet& grasps, ShownHand& shown) {
    const auto force = hand_.motor.force_N;
    if (!force) return;
    ForceReach& reach = shown.force_reach.emplace();
    reach.motor_N = *force;
    reach.share = std::numeric_limits<double>::infinity();
    for (const WeightedGrasp& weighted : grasps) {
      add_grasp(hand_, network_.fingers, weighted.grasp, pulls_in(weighted.grasp), reach);
    }
  }

  // Springs in series take their part of the stroke, and the fingers close by the rest.
  void add_stroke_reach(ShownHand& shown) const {
    const auto stroke = hand_.motor.stroke_mm;
    if (!stroke) return;
    const MotorDemand& demand = shown.demand;
    StrokeReach reach;
    reach.closed.assign(static_cast<std::size_t>(network_.fingers), 1.0);
    if (demand.stretch)
      reach.stretch_N = std::min(demand.force_N, hand_.motor.force_N.value_or(demand.force_N));
    for (const ShownWay& way : demand.ways) {
      const double stretch_mm = way.stretch.travel_mm(reach.stretch_N);
      const double left_mm = *stroke - stretch_mm;
      const bool slips_back = way.stretch.sliding_mm_N * demand.force_N > left_mm;
      if (left_mm <= 0 || (*stroke < demand.stroke_mm && slips_back)) return;
      const StrokeReach one = reach_from(way.open, hand_, network_, plain_, left_mm);
      if (one.stroke_mm + stretch_mm > reach.stroke_mm) {
        reach.stroke_mm = one.stroke_mm + stretch_mm;
        reach.stretch_mm = stretch_mm;
      }
      for (std::size_t f = 0; f < reach.closed.size(); ++f) {
        reach.closed[f] = std::min(reach.closed[f], one.closed[f]);
      }
    }
    find_last(reach);
    shown.stroke_reach = reach;
  }

  void add_forces(ShownHand& shown) {
    if (!std::isfinite(shown.demand.force_N)) return;
    for (ShownHandGrasp& grasp : shown.grasps) {
      const HandPulls pulls = pulls_in(grasp.grasp);
      for (ShownFingerForce& force : grasp.fingers) {
        const HeldForce held =
            held_force(hand_.finger(force.finger), force.pull_per_motor,
                       pulls.hardest_pull_N(force.finger, shown.demand.motors_N));
        force.force_N = held.force_N;
        force.gives = held.joint;
      }
    }
  }

  // Several motors have no one force that reaches the fingers.
  ShownWay way_from(const Grasp& open, const ShownHand& shown) {
    ShownWay way{open};
    for (const ShownHandGrasp& each : shown.grasps) {
      if (opened(each.grasp) == open) way.stretch = greatest(way.stretch, each.stretch);
    }
    Kinematics kinematics;
    Motion motion;
    way.closing = close_hand(
        hand_, network_, plain_, open, kinematics, motion,
        [&](Grasp at_end, double before_mm, double travel_mm, const std::vector<double>& closings) {
          if (*std::ranges::max_element(closings) == 0) return;
          for (int motor = 0; motor < shown.motors; ++motor) {
            way.loaded_mm[static_cast<std::size_t>(motor)] +=
                std::abs(at_end.travel(motor + 1)) * travel_mm;
          }
          if (shown.motors > 1) return;
          // How tendons behind slack share the carriage changes on the way: as in its middle.
          Mechanics there = plain_;
          there.travel_mm = before_mm + travel_mm / 2;
          solver_.set_routing(word_, network_, there);
          const HandPulls pulls = pulls_in(at_end);
          for (std::size_t f = 0; f < closings.size(); ++f) {
            const HandFinger& finger = hand_.finger(static_cast<int>(f) + 1);
            way.to_fingers_J_N +=
                working_pull(finger, pulls.fingers[f + 1]) * closings[f] * travel_mm / mm_in_m;
          }
        });
    return way;
  }

  std::vector<HandClosing> closings_of_each_motor(int motors) const {
    std::vector<HandClosing> closings;
    Kinematics kinematics;
    Motion motion;
    for (int motor = 0; motor < motors; ++motor) {
      Grasp alone{0, {static_cast<std::uint8_t>(motors), {}}, 0};
      alone.carriages.over_D[static_cast<std::size_t>(motor)] = 1;
      closings.push_back(close_hand(hand_, network_, plain_, kinematics, motion, alone));
    }
    return closings;
  }

  void add_closing(const GraspSet& grasps, ShownHand& shown) {
    MotorDemand& demand = shown.demand;
    demand.closure = 1;
    FingerArray closed;
    closed.fill(1);
    for (const Grasp& open : opened(grasps)) {
      const HandClosing& closing = demand.ways.emplace_back(way_from(open, shown)).closing;
      demand.closure = std::min(demand.closure, closing.closure);
      for (std::size_t m = 0; m < max_carriages; ++m) {
        demand.strokes_mm[m] = std::max(demand.strokes_mm[m], closing.strokes_mm[m]);
      }
      for (std::size_t f = 0; f < closed.size(); ++f) {
        closed[f] = std::min(closed[f], closing.closed[f]);
      }
    }
    if (shown.springs) count_stretch(demand);
    add_motion(hand_.motor, demand);
    for (int f = 1; f <= network_.fingers; ++f) {
      const HandFinger& finger = hand_.finger(f);
      const double share = closed[static_cast<std::size_t>(f)];
      shown.fingers.push_back({f, finger.force_N, finger.excursion_mm, share});
      demand.springs_J += spring_energy(finger, share);
    }
    add_work(shown.motors, demand);
  }

  static void add_work(int motors, MotorDemand& demand) {
    const ShownWay& way = *std::ranges::max_element(
        demand.ways, {}, [&](const ShownWay& each) { return work_J(each, demand); });
    demand.work_J = work_J(way, demand);
    if (demand.stretch) demand.series_J = way.stretch.stored_J(demand.force_N);
    if (motors > 1 || !way.stretch.is_lossless) return;
    const double to_fingers_J = demand.force_N * way.to_fingers_J_N;
    demand.friction_J = demand.work_J - demand.series_J - to_fingers_J;
    if (std::abs(demand.friction_J) <= rounding_of_work * demand.work_J) demand.friction_J = 0;
    demand.fingers_J = to_fingers_J - demand.springs_J;
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

void add_grasp(const Hand& hand, int fingers, Grasp grasp, const HandPulls& pulls,
               ForceReach& reach) {
  for (int f = 1; f <= fingers; ++f) {
    const HandFinger& finger = hand.finger(f);
    const FingerPull& pull_per_motor = pulls.fingers[static_cast<std::size_t>(f)];
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

std::optional<ShownHand> shown_hand(const Network& network, const std::string& word,
                                    const Model& model, const GraspSet& grasps) {
  const auto known = hand(model.hardware);
  const bool is_known = known && first_unknown_finger(*known, network.fingers) == 0;
  if (!is_known || network.fingers == 0) return std::nullopt;
  HandStudy study(*known, network, word, model);
  const auto [gripping, opening] = study.sorted(grasps);
  if (gripping.empty()) return std::nullopt;
  ShownHand shown = study.run(gripping);
  shown.opening = opening;
  return shown;
}

}  // namespace reeve::studies
