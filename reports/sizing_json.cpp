#include <utility>

#include "reports/motor_words.hpp"
#include "reports/output/json.hpp"
#include "reports/output/stamp.hpp"
#include "reports/show_report.hpp"
#include "reports/sizing_report.hpp"

namespace reeve::reports {
namespace {

Json bound_json(AtBound at) {
  if (at == AtBound::no) return nullptr;
  return at == AtBound::low ? "low" : "high";
}

Json variable_json(const SizedDesign& design, std::size_t i) {
  const SizedVariable& sized = design.variables[i];
  const SizeVariable& about = sized.variable;
  Json json{{"dimension", about.name},
            {"unit", *about.unit == '\0' ? "1" : about.unit},
            {"bounds", {about.bounds.low, about.bounds.high}},
            {"before", about.nominal},
            {"sized", sized.value},
            {"at_bound", bound_json(sized.at)}};
  if (!design.together) {
    json["slope"] = nullptr;
    json["tolerance"] = nullptr;
    json["tolerance_together"] = nullptr;
    return json;
  }
  const Sensitivity& sensitivity = sized.sensitivity;
  json["slope"] = {{"less", sensitivity.slope_less}, {"more", sensitivity.slope_more}};
  json["tolerance"] = {{"less", value_or_null(sensitivity.less, number)},
                       {"more", value_or_null(sensitivity.more, number)}};
  const JointTolerance::Ways& ways = design.together->ways[i];
  json["tolerance_together"] = {{"less", ways.less}, {"more", ways.more}};
  return json;
}

// Moves of variables, those that move.
Json moves_json(const SizedDesign& design, const std::vector<double>& moves) {
  Json json = Json::array();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] == 0) continue;
    json.push_back({{"dimension", design.variables[i].variable.name}, {"by", moves[i]}});
  }
  return json;
}

Json flat_json(const SizedDesign& design, const FlatDirection& flat) {
  return {{"moves", moves_json(design, flat.moves)}, {"loss", flat.loss}};
}

Json goal_json(const SizedGoal& goal, const MotorParts& motor) {
  Json json{{"goal", goal.goal}, {"nominal_goal", goal.nominal}, {"finger_shares", goal.shares}};
  json["motor"] = motor_force_json(goal.motor, motor);
  add_objectives(json, goal.values);
  return json;
}

Json target_json(const SizedDesign& design) {
  if (!design.least_miss) return nullptr;
  return {{"met", is_met(design)},
          {"least_miss", *design.least_miss},
          {"nearest_shares", design.nearest_shares}};
}

Json together_json(const SizedDesign& design) {
  if (!design.together) return nullptr;
  return {{"factor", design.together->factor},
          {"worst", moves_json(design, design.together->worst)}};
}

Json design_json(const SizedRouting& routing) {
  const SizedDesign& design = routing.design;
  Json json{{"rank", routing.rank_after},        {"rank_before", routing.rank_before},
            {"routing", routing.word},           {"name", text_or_null(routing.name)},
            {"target", target_json(design)},     {"dimensions", Json::array()},
            {"together", together_json(design)}, {"flat", Json::array()}};
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    json["dimensions"].push_back(variable_json(design, i));
  }
  for (const FlatDirection& flat : design.flat) json["flat"].push_back(flat_json(design, flat));
  json["before"] = goal_json(design.before, design.hardware.motor);
  json["sized"] = goal_json(design.after, design.hardware.motor);
  json["hardware"] = to_json(design.hardware);
  return json;
}

Json profiles_json(const SizingReport& report) {
  Json json = Json::array();
  const SizedDesign& design = report.designs.front().design;
  const std::vector<GoalProfile>& profiles = report.details->profiles;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    json.push_back({{"dimension", design.variables[i].variable.name},
                    {"values", profiles[i].values},
                    {"goals", list_json(profiles[i].goals, number)}});
  }
  return json;
}

Json details_json(const SizingReport& report) {
  const SizingDetails& details = *report.details;
  return {{"before", to_json(details.before)},
          {"sized", to_json(details.sized)},
          {"profiles", profiles_json(report)}};
}

Json settings(const SizingReport& report) {
  const SizingOptions& options = report.options;
  Json json{{"goal", to_text(options.goal)},
            {"target_shares", options.goal.is_target() ? Json(options.goal.target) : Json(nullptr)},
            {"better", options.goal.better() == Better::higher ? "higher" : "lower"},
            {"robust", options.robust}};
  json["vary"] = list_json(options.varied, [](const VariedRange& range) {
    return Json{{"dimension", to_text(range.name)},
                {"bounds", {range.bounds.low, range.bounds.high}}};
  });
  json["equal"] =
      list_json(options.equal, [](const EqualGroup& group) { return to_text(group.name); });
  json["starts"] = options.starts;
  json["evaluations"] = options.evaluations;
  json["goal_grasps"] = to_json(goal_grasps(options));
  json["told_draws"] = options.robust ? Json(told_draws(options)) : Json(nullptr);
  json.update(settings_json(Order(options.goal.factors), options.score, options.grasps,
                            options.nominal, report.unconverged));
  const UncertaintyOptions draws{options.nominal, options.ranges,
                                 options.grasps,  Order(options.goal.factors),
                                 options.draws,   options.seed};
  json["uncertainty"] = options.robust ? to_json(draws) : Json(nullptr);
  return json;
}

}  // namespace

std::string sizing_json(const SizingReport& report) {
  Json json{{"designs", list_json(report.designs, design_json)}};
  if (report.details) json["details"] = details_json(report);
  json["partial"] = report.partial;
  json["notes"] = report.notes;
  json["settings"] = settings(report);
  json["version"] = version_json();
  return print_stamped(std::move(json));
}

}  // namespace reeve::reports
