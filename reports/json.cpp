#include "reports/json.hpp"

#include <cmath>
#include <optional>

#include "core/version.hpp"
#include "reports/model_text.hpp"

namespace reeve {
namespace {

void add_if_given(Json& target, const char* key, const std::optional<double>& value) {
  if (value) target[key] = *value;
}

Json law(const ContactLaw& contact) {
  return {{"mu", contact.mu}, {"angle_rad", contact.angle_rad}};
}

Json to_json(const FingerHardware& finger) {
  Json json{{"finger", finger.finger}};
  add_if_given(json, "tip_mu", finger.tip_mu);
  add_if_given(json, "tip_angle_rad", finger.tip_angle_rad);
  add_if_given(json, "sheath_mu", finger.sheath_mu);
  add_if_given(json, "sheath_angle_rad", finger.sheath_angle_rad);
  add_if_given(json, "strand_mm", finger.strand_mm);
  json["closing"] = finger.closing;
  return json;
}

}  // namespace

std::string print(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void add_objectives(Json& target, const ObjectiveValues& values) {
  const auto get = [&](Objective objective) { return number(value(values, objective)); };
  target["uniformity"] = {{"mean", get(Objective::uniformity_mean)},
                          {"worst", get(Objective::uniformity_worst)}};
  target["efficiency"] = {{"mean", get(Objective::efficiency_mean)},
                          {"worst", get(Objective::efficiency_worst)}};
  target["force_transmission"] = get(Objective::force_transmission);
  for (const Objective counted :
       {Objective::jams, Objective::sheaths, Objective::pulleys, Objective::knots}) {
    target[row(counted).name] = static_cast<int>(value(values, counted));
  }
  target["travel"] = get(Objective::travel);
  target["return_friction"] = get(Objective::return_friction);
}

Json to_json(const Hardware& hardware) {
  Json json{{"tube", law(hardware.tube)},
            {"bearing", law(hardware.bearing)},
            {"sheath", law(hardware.sheath)},
            {"lengths",
             {{"strand_mm", hardware.strand_mm},
              {"motor_side_mm", hardware.motor_side_mm},
              {"hand_mm", hardware.hand_mm}}}};
  json["fingers"] = Json::array();
  for (const FingerHardware& finger : hardware.fingers) json["fingers"].push_back(to_json(finger));
  json["contacts"] = Json::array();
  for (const ContactHardware& contact : hardware.contacts) {
    Json entry{{"between", {contact.segment, contact.other_segment}}};
    add_if_given(entry, "mu", contact.mu);
    add_if_given(entry, "angle_rad", contact.angle_rad);
    json["contacts"].push_back(entry);
  }
  return json;
}

std::string objective_names(const std::vector<Objective>& objectives) {
  std::string names;
  for (const Objective objective : objectives) {
    names += (names.empty() ? "" : ", ") + std::string(row(objective).name);
  }
  return names;
}

Json settings_json(const std::vector<Objective>& objectives, const GraspSet& grasps,
                   const Model& model, std::uint64_t unconverged) {
  Json json;
  json["objectives"] = Json::array();
  for (const Objective objective : objectives) json["objectives"].push_back(row(objective).name);
  json["grasps"] = Json::array();
  for (const WeightedGrasp& grasp : grasps) {
    json["grasps"].push_back({{"held", held_fingers(grasp.grasp)}, {"weight", grasp.weight}});
  }
  json["hardware"] = to_json(model.hardware);
  json["model"] = model_json(model, unconverged);
  return json;
}

Json to_json(const UncertaintyOptions& options) {
  const UncertaintyRanges& ranges = options.ranges;
  return {{"draws", options.draws},
          {"seed", options.seed},
          {"tube_mu", {ranges.tube_mu.low, ranges.tube_mu.high}},
          {"sheath_mu", {ranges.sheath_mu.low, ranges.sheath_mu.high}},
          {"bearing_mu_relative", ranges.bearing_mu_relative},
          {"sheath_angle_relative", ranges.sheath_angle_relative}};
}

std::string version_json() {
  const Version build = version();
  return build.number + " (" + build.commit + ")";
}

}  // namespace reeve
