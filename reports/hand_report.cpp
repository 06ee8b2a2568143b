#include "reports/hand_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/motor_sides.hpp"
#include "core/text.hpp"
#include "reports/motor_words.hpp"

namespace reeve::reports {
namespace {

Table force_table(const ShownHand& hand) {
  Table table{{text_column("held")}, {}};
  for (const ShownHandFinger& finger : hand.fingers) {
    table.columns.push_back(number_column(fmt::format("finger {}", finger.finger), "N/N"));
  }
  for (int motor = 1; motor <= hand.motors; ++motor) {
    table.columns.push_back(number_column(hand.motors > 1 ? motor_name(motor) : "motor", "N"));
  }
  table.columns.push_back(number_column("limiting finger"));
  table.columns.push_back(number_column("frictionless", "N"));
  for (const ShownHandGrasp& grasp : hand.grasps) {
    std::vector<std::string> cells{to_text(grasp.grasp)};
    for (const ShownFingerForce& force : grasp.fingers) cells.push_back(fixed(force.per_motor_N));
    for (int motor = 1; motor <= hand.motors; ++motor) {
      cells.push_back(fixed(grasp.motors_N[static_cast<std::size_t>(motor) - 1], 1));
    }
    cells.push_back(fmt::format("finger {}", grasp.weakest));
    cells.push_back(fixed(grasp.frictionless_N, 1));
    table.add(std::move(cells));
  }
  return table;
}

// Returns the least value of the finger at this place, over the grasps.
template <typename Get>
double least_force(const ShownHand& hand, std::size_t place, Get get) {
  double least = get(hand.grasps.front().fingers[place]);
  for (const ShownHandGrasp& grasp : hand.grasps) {
    least = std::min(least, get(grasp.fingers[place]));
  }
  return least;
}

Table finger_table(const ShownHand& hand) {
  Table table{{number_column("finger"), number_column("excursion", "mm"),
               number_column("closes, %"), number_column("wanted", "N")},
              {}};
  const bool has_force = std::isfinite(hand.demand.force_N);
  if (has_force) {
    table.columns.push_back(
        hand.motors > 1 ? number_column("at motor forces", "N")
                        : number_column(fmt::format("at {} N", fixed(hand.demand.force_N, 1))));
  }
  const std::optional<double> limit = hand.motor.force_N;
  if (limit) table.columns.push_back(number_column(fmt::format("at {:.4g} N", *limit)));
  for (std::size_t f = 0; f < hand.fingers.size(); ++f) {
    const ShownHandFinger& finger = hand.fingers[f];
    const auto at_demand = [](const ShownFingerForce& force) { return force.force_N; };
    const auto at_limit = [](const ShownFingerForce& force) { return *force.at_limit_N; };
    std::vector<std::string> cells{std::to_string(finger.finger), fixed(finger.excursion_mm, 1),
                                   fixed(100 * finger.closed, 1), fixed(finger.wanted_N, 1)};
    if (has_force) cells.push_back(fixed(least_force(hand, f, at_demand), 2));
    if (limit) cells.push_back(fixed(least_force(hand, f, at_limit), 2));
    table.add(std::move(cells));
  }
  return table;
}

Table alone_table(const ShownHand& hand) {
  Table table{{text_column("motor"), number_column("stroke", "mm")}, {}};
  for (const ShownHandFinger& finger : hand.fingers) {
    table.columns.push_back(number_column(fmt::format("finger {}", finger.finger)));
  }
  for (std::size_t motor = 0; motor < hand.motors_alone.size(); ++motor) {
    const HandClosing& closing = hand.motors_alone[motor];
    std::vector<std::string> cells{motor_name(static_cast<int>(motor) + 1),
                                   fixed(closing.strokes_mm[motor], 1)};
    for (const ShownHandFinger& finger : hand.fingers) {
      cells.push_back(fixed(100 * closing.closed[static_cast<std::size_t>(finger.finger)], 1));
    }
    table.add(std::move(cells));
  }
  return table;
}

Json alone_json(const ShownHand& hand) {
  Json json = Json::array();
  for (const HandClosing& closing : hand.motors_alone) {
    const std::size_t motor = json.size();
    json.push_back({{"motor", motor + 1},
                    {"stroke_mm", number(closing.strokes_mm[motor])},
                    {"closed", list_json(hand.fingers, [&](const ShownHandFinger& finger) {
                       return closing.closed[static_cast<std::size_t>(finger.finger)];
                     })}});
  }
  return json;
}

std::string no_pull_words(NoPull no_pull, int motors) {
  std::string blocked = motors > 1 ? "its carriages are blocked" : "the carriage is blocked";
  switch (no_pull) {
    case NoPull::blocked:
      break;
    case NoPull::opposed:
      return "its extensor holds it back";
    case NoPull::blocked_at_springs:
      return blocked + ", if springs in series do not stretch";
    case NoPull::ends_locked:
      return "its ends at motors are locked";
    case NoPull::ends_stand_still:
      return motors > 1 ? "its carriages stand still" : "the carriage stands still";
    case NoPull::still_slack:
      return "its tendon is still slack after the whole carriage travel";
  }
  return blocked;
}

const char* unstretched(const ShownHand& hand) {
  return hand.leaves_out_springs() ? ", if springs in series do not stretch" : "";
}

std::string slack_text(const ShownHand& hand) {
  if (!hand.slack_shared_at_mm) return "";
  return fmt::format(", with the shares of tendons with slack at a carriage travel of {:.4g} mm",
                     *hand.slack_shared_at_mm);
}

void add_force_lines(const ShownHand& hand, std::vector<DocumentLine>& lines) {
  const MotorDemand& demand = hand.demand;
  if (!std::isfinite(demand.force_N)) {
    lines.push_back({fmt::format("No motor force is enough: with held {} finger {} gets no pull, "
                                 "since {}",
                                 to_text(demand.grasp), demand.weakest,
                                 no_pull_words(demand.no_pull, hand.motors)),
                     true});
    return;
  }
  if (demand.force_N == 0) {
    lines.push_back({"Motor force 0 N: no finger is to press, and no spring is to be overcome"});
    return;
  }
  lines.push_back({fmt::format(
      "Nominal motor force {:.4g} N{}{}: finger {} sets it, at its joint {}, with "
      "held {}. Friction costs {} of it: without, {:.4g} N would do",
      demand.force_N, unstretched(hand), slack_text(hand), demand.weakest, demand.joint + 1,
      to_text(demand.grasp), percent(demand.friction_cost()), demand.frictionless_N)});
}

std::string stretch_text(const MotorDemand& demand) {
  if (!demand.stretch) return "";
  return fmt::format(". Springs in series take {:.4g} mm of it, at {:.4g} N", demand.stretch_mm(),
                     demand.force_N);
}

std::string series_text(const MotorDemand& demand) {
  if (!demand.stretch) return "";
  return fmt::format(", springs in series {:.3g} J", demand.series_J);
}

std::string rest_text(const MotorDemand& demand, int motors) {
  if (motors > 1) return "";
  if (std::isnan(demand.friction_J)) {
    return ", and friction and fingers are not told apart, since several ends hang on the motor "
           "beside springs in series";
  }
  return fmt::format(", friction takes {:.3g} J, and {:.3g} J are left to the fingers",
                     demand.friction_J, demand.fingers_J);
}

void add_motion_lines(const ShownHand& hand, std::vector<DocumentLine>& lines) {
  const MotorDemand& demand = hand.demand;
  if (!demand.can_move()) {
    lines.push_back({hand.motors > 1
                         ? "No stroke: a carriage is blocked"
                         : "No stroke: the carriage is blocked, and no finger can close",
                     true});
    return;
  }
  lines.push_back({fmt::format("Stroke {:.4g} mm in {:.4g} s{}: {:.4g} mm/s{}", demand.stroke_mm,
                               hand.motor.close_s, unstretched(hand), demand.speed_mm_s,
                               stretch_text(demand))});
  if (demand.closure < 1) {
    lines.push_back(
        {fmt::format("{}: the last finger stands at {} of its range",
                     hand.motors > 1 ? "The hand is not closed then"
                                     : "The carriage is then blocked, and the hand not closed",
                     percent(demand.closure)),
         true});
  }
  if (!std::isfinite(demand.force_N)) return;
  lines.push_back(
      {fmt::format("Work at most {:.3g} J{}, {} {:.3g} J{}{}; power at most {:.3g} W",
                   demand.work_J, unstretched(hand),
                   demand.springs_J < 0 ? "to which the springs add" : "of which the springs keep",
                   std::abs(demand.springs_J), series_text(demand), rest_text(demand, hand.motors),
                   demand.power_W)});
  if (!demand.torque_Nm) return;
  lines.push_back({fmt::format("At a spool radius of {:.4g} mm: {:.3g} N m, {:.3g} rpm",
                               *hand.motor.spool_radius_mm, *demand.torque_Nm, *demand.spool_rpm)});
}

// ": finger 2 closes least"; nothing where all close alike.
std::string last_text(const StrokeReach& reach) {
  if (reach.last.size() == reach.closed.size()) return "";
  if (reach.last.size() == 1) return fmt::format(": finger {} closes least", reach.last.front());
  return fmt::format(": fingers {} close least", fmt::join(reach.last, ", "));
}

std::string springs_in_stroke(const ShownHand& hand) {
  if (hand.leaves_out_springs()) return ", if springs in series do not stretch,";
  if (!hand.demand.stretch) return "";
  return fmt::format(", of which springs in series take {:.4g} mm at {:.4g} N,",
                     hand.stroke_reach->stretch_mm, hand.stroke_reach->stretch_N);
}

// ", at a stroke of 227.9 mm"; nothing where springs in series take none of it.
std::string stroke_of_reach(const ShownHand& hand) {
  if (!hand.springs || !hand.force_reach->stroke_mm) return "";
  return fmt::format(", at a stroke of {:.4g} mm", *hand.force_reach->stroke_mm);
}

// Adds lines on the given motor: its fingertip forces, and its closure if the stroke is too short.
void add_reach_lines(const ShownHand& hand, std::vector<DocumentLine>& lines) {
  if (hand.force_reach && hand.force_reach->weakest > 0) {
    const ForceReach& reach = *hand.force_reach;
    const std::string where = fmt::format("finger {} is the weakest, at its joint {}, with held {}",
                                          reach.weakest, reach.joint + 1, to_text(reach.grasp));
    lines.push_back(
        {reach.share > 0
             ? fmt::format(
                   "With {:.4g} N the fingers press with {} of all wanted forces or more, at "
                   "the nominal coefficients{}: {}, {:.3g} N",
                   reach.motor_N, percent(reach.share), stroke_of_reach(hand), where, reach.force_N)
             : fmt::format("With {:.4g} N not every finger closes and presses: {}", reach.motor_N,
                           where)});
  }
  if (hand.motor.stroke_mm && !hand.stroke_reach) {
    lines.push_back(
        {fmt::format("With {:.4g} mm of stroke it is not known how far the hand closes: "
                     "springs in series take all of it, or tendon slips back at them",
                     *hand.motor.stroke_mm),
         true});
  }
  if (!hand.stroke_reach) return;
  const StrokeReach& reach = *hand.stroke_reach;
  if (reach.closure < hand.demand.closure) {
    lines.push_back({fmt::format("With {:.4g} mm of stroke{} the hand closes to {} of its range{}",
                                 *hand.motor.stroke_mm, springs_in_stroke(hand),
                                 percent(reach.closure), last_text(reach))});
  }
}

Json force_reach_json(const ForceReach& reach) {
  Json json{{"motor_N", reach.motor_N},
            {"share_of_wanted", number(reach.share)},
            {"stroke_mm", value_or_null(reach.stroke_mm, number)}};
  if (reach.weakest == 0) {
    json["weakest"] = nullptr;
    return json;
  }
  json["weakest"] = {{"finger", reach.weakest},
                     {"joint", reach.joint + 1},
                     {"held", held_fingers(reach.grasp)},
                     {"force_N", reach.force_N}};
  return json;
}

Json stroke_reach_json(const StrokeReach& reach) {
  return {{"stroke_mm", reach.stroke_mm}, {"closure", reach.closure}, {"closed", reach.closed}};
}

Json hand_finger_json(const ShownHandFinger& finger) {
  return {{"finger", finger.finger},
          {"wanted_N", finger.wanted_N},
          {"excursion_mm", finger.excursion_mm},
          {"closed", finger.closed}};
}

Json force_json(const ShownFingerForce& force, bool has_force) {
  return {{"finger", force.finger},
          {"pull_per_motor", number(force.pull_per_motor.sum_N())},
          {"force_per_motor", number(force.per_motor_N)},
          {"asks_motor_N", number(force.asks_motor_N)},
          {"force_N", has_force ? number(force.force_N) : Json(nullptr)},
          {"joint", has_force ? Json(force.gives + 1) : Json(nullptr)},
          {"force_at_limit_N", value_or_null(force.at_limit_N, number)}};
}

Json grasps_json(const ShownHand& hand) {
  const bool has_force = std::isfinite(hand.demand.force_N);
  const auto of_finger = [&](const ShownFingerForce& force) {
    return force_json(force, has_force);
  };
  return list_json(hand.grasps, [&](const ShownHandGrasp& grasp) {
    Json json{{"held", held_fingers(grasp.grasp)},
              {"motor_force_N", number(grasp.motor_force_N)},
              {"frictionless_N", number(grasp.frictionless_N)},
              {"weakest", grasp.weakest},
              {"fingers", list_json(grasp.fingers, of_finger)}};
    add_ends(json, grasp.grasp);
    return json;
  });
}

Json motor_json(const ShownHand& hand) {
  const MotorDemand& demand = hand.demand;
  const auto of_motion = [&](double value) {
    return demand.can_move() ? number(value) : Json(nullptr);
  };
  Json json{
      {"force_N", number(demand.force_N)},
      {"frictionless_N", number(demand.frictionless_N)},
      {"friction_cost", number(demand.friction_cost())},
      {"weakest",
       {{"finger", demand.weakest},
        {"joint", demand.joint + 1},
        {"held", held_fingers(demand.grasp)}}},
      {"stroke_mm", of_motion(demand.stroke_mm)},
      {"closure", demand.closure},
      {"speed_mm_s", of_motion(demand.speed_mm_s)},
      {"power_W", number(demand.power_W)},
      {"work_J", number(demand.work_J)},
      {"springs_J", number(demand.springs_J)},
      {"friction_J", number(demand.friction_J)},
      {"fingers_J", number(demand.fingers_J)},
      {"torque_Nm", value_or_null(demand.torque_Nm, number)},
      {"spool_rpm", demand.can_move() ? value_or_null(demand.spool_rpm, number) : Json(nullptr)},
      {"drawn", motor_force_json(hand.drawn, hand.motor)},
      {"force_reach", value_or_null(hand.force_reach, force_reach_json)},
      {"stroke_reach", value_or_null(hand.stroke_reach, stroke_reach_json)}};
  if (hand.slack_shared_at_mm) json["slack_shared_at_mm"] = *hand.slack_shared_at_mm;
  if (hand.springs) {
    const bool is_counted = demand.stretch.has_value();
    json["stretch_mm"] = is_counted ? number(demand.stretch_mm()) : Json(nullptr);
    json["series_springs_J"] = is_counted ? number(demand.series_J) : Json(nullptr);
  }
  return json;
}

}  // namespace

std::vector<Section> hand_sections(const ShownHand& hand) {
  std::vector<DocumentLine> lines;
  if (!hand.opening.empty()) {
    lines.push_back({fmt::format("Without {}, with which fingers open: nothing is gripped then",
                                 to_text(hand.opening))});
  }
  add_force_lines(hand, lines);
  append(lines, motor_lines(hand.drawn, hand.motor));
  add_motion_lines(hand, lines);
  add_reach_lines(hand, lines);
  std::vector<Section> sections{
      {"Hand, pulling: fingertip force per newton of motor tension, springs aside, and the motor\n"
       "tension that meets all wanted forces",
       force_table(hand),
       {}},
      {"Hand, pulling: fingers, and the least force at their tips in any of these grasps",
       finger_table(hand), lines}};
  if (hand.motors > 1) {
    sections.push_back(
        {"Hand: how far fingers close by each motor alone, %, the other carriages standing still",
         alone_table(hand),
         {}});
  }
  append(sections, closing_sections(hand.closings));
  return sections;
}

void add_hand(Json& target, const ShownHand& hand) {
  target["fingers"] = list_json(hand.fingers, hand_finger_json);
  target["grasps"] = grasps_json(hand);
  target["motor"] = motor_json(hand);
  if (hand.motors > 1) target["motors_alone"] = alone_json(hand);
  if (!hand.closings.empty()) target["closings"] = closings_json(hand.closings);
}

}  // namespace reeve::reports
