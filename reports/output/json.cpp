#include "reports/output/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/finger_guides.hpp"
#include "core/hand.hpp"
#include "core/version.hpp"
#include "reports/model_text.hpp"

namespace reeve::reports {
namespace {

void add_if_given(Json& target, const char* key, const std::optional<double>& value) {
  if (value) target[key] = *value;
}

Json law(const ContactLaw& contact) {
  Json json{{"mu", contact.mu}, {"angle_rad", contact.angle_rad}};
  if (contact.wobble_rad_per_m > 0) {
    add_if_given(json, "length_mm", contact.length_mm);
    json["wobble_rad_per_m"] = contact.wobble_rad_per_m;
  }
  return json;
}

Json joint_json(const FingerJoint& joint) {
  Json json{{"arm_mm", joint.arm_mm},
            {"range_deg", joint.range_deg},
            {"lever_mm", joint.lever_mm},
            {"spring_Nmm_rad", joint.spring_Nmm_rad},
            {"rest_deg", joint.rest_deg}};
  add_if_given(json, "held_deg", joint.held_deg);
  if (joint.guide != JointGuide::none) {
    json["guide"] = guide_name(joint.guide);
    add_if_given(json, "mu", joint.mu);
    json["wrap_deg"] = joint.wrap_deg;
  }
  add_if_given(json, "object_deg", joint.object_deg);
  add_if_given(json, "phalanx_mm", joint.phalanx_mm);
  return json;
}

void add_parts(Json& target, const FingerParts& parts) {
  add_if_given(target, "force_N", parts.force_N);
  for (const FingerJoint& joint : parts.joints) target["joints"].push_back(joint_json(joint));
}

Json motor_json(const MotorParts& motor) {
  Json json = Json::object();
  add_if_given(json, "spool_radius_mm", motor.spool_radius_mm);
  json["close_s"] = motor.close_s;
  add_if_given(json, "force_N", motor.force_N);
  add_if_given(json, "stroke_mm", motor.stroke_mm);
  return json;
}

Json finger_json(const FingerHardware& finger) {
  Json json{{"finger", finger.finger}};
  add_if_given(json, "tip_mu", finger.tip_mu);
  add_if_given(json, "tip_angle_rad", finger.tip_angle_rad);
  add_if_given(json, "sheath_mu", finger.sheath_mu);
  add_if_given(json, "sheath_angle_rad", finger.sheath_angle_rad);
  add_if_given(json, "strand_mm", finger.strand_mm);
  add_if_given(json, "closing", finger.closing);
  add_parts(json, finger.parts);
  return json;
}

// As in the hardware file.
Json tendon_json(const TendonParts& parts) {
  Json json = Json::object();
  add_if_given(json, "EA_N", parts.EA_N);
  add_if_given(json, "travel_mm", parts.travel_mm);
  for (const TendonHardware& own : parts.own) {
    Json& tendon = json[std::to_string(own.tendon)] = Json::object();
    add_if_given(tendon, "stiffness_N_mm", own.stiffness_N_mm);
    add_if_given(tendon, "slack_mm", own.slack_mm);
  }
  return json;
}

Json score_json(const Order& order, const Score& score) {
  Json json{{"orders", order.by_score}, {"weights", Json::object()}};
  for (const ScoreTerm& term : score.terms) json["weights"][row(term.objective).name] = term.weight;
  return json;
}

}  // namespace

std::string print(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

void add_objectives(Json& target, const ObjectiveValues& values) {
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, values)) continue;
    const double given = value(values, row.objective);
    Json& family = row.of_hand ? target["hand"][row.family] : target[row.family];
    Json& place = *row.part == '\0' ? family : family[row.part];
    place = row.is_count() && std::isfinite(given) ? Json(static_cast<std::int64_t>(given))
                                                   : number(given);
  }
}

Json to_json(const Hardware& hardware) {
  Json json{{"tube", law(hardware.tube)},
            {"bearing", law(hardware.bearing)},
            {"sheath", law(hardware.sheath)},
            {"scatter",
             {{"contact_relative", hardware.scatter.relative},
              {"bearing_contact_relative", hardware.scatter.bearing_relative}}},
            {"lengths",
             {{"strand_mm", hardware.strand_mm},
              {"motor_side_mm", hardware.motor_side_mm},
              {"hand_mm", hardware.hand_mm}}}};
  if (hardware.block) json["block"] = law(*hardware.block);
  json["fingers"] = list_json(hardware.fingers, finger_json);
  json["contacts"] = list_json(hardware.contacts, [](const ContactHardware& contact) {
    Json entry{{"between", {contact.segment, contact.other_segment}}};
    add_if_given(entry, "mu", contact.mu);
    add_if_given(entry, "angle_rad", contact.angle_rad);
    return entry;
  });
  for (const SpoolHardware& spool : hardware.spools) json["spools"][spool.segment] = spool.ratio;
  if (hardware.tendon != TendonParts{}) json["tendon"] = tendon_json(hardware.tendon);
  if (!hand(hardware)) return json;
  json["hand"] = Json::object();
  add_parts(json["hand"], hardware.finger_parts);
  json["motor"] = motor_json(hardware.motor);
  return json;
}

std::string objective_names(const std::vector<Objective>& objectives) {
  return joined(objectives, ", ", [](Objective objective) { return row(objective).name; });
}

std::string order_text(const Order& order, const Score& score) {
  const std::string made_of =
      fmt::format("the weighted mean of {} (greater is better)", to_text(score));
  if (order.objectives == std::vector{Objective::score}) return "By the score, " + made_of;
  const std::string fronts = "Sorted by Pareto front (" + objective_names(order.objectives) + ")";
  return order.by_score ? fronts + ", within a front by the score, " + made_of : fronts;
}

Json to_json(const PartPrices& prices) {
  Json json{{"unit", text_or_null(prices.unit)}};
  for (const PriceRow& row : price_table()) json[row.name] = prices.*row.price;
  json["tendon_mm"] = prices.tendon_mm;
  return json;
}

void add_ends(Json& target, const Grasp& grasp) {
  if (grasp.locked != 0) target["locked"] = locked_ends(grasp);
  if (grasp.carriages.given > 0) target["carriages"] = carriage_travels(grasp);
}

Json to_json(const GraspSet& grasps) {
  return list_json(grasps, [](const WeightedGrasp& grasp) {
    Json json{{"held", held_fingers(grasp.grasp)}, {"weight", grasp.weight}};
    add_ends(json, grasp.grasp);
    return json;
  });
}

Json settings_json(const Order& order, const Score& score, const GraspSet& grasps,
                   const Model& model, std::uint64_t unconverged) {
  Json json;
  json["objectives"] =
      list_json(order.objectives, [](Objective objective) { return row(objective).name; });
  json["score"] = score_json(order, score);
  json["grasps"] = to_json(grasps);
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

// Strings have no line ends of their own in them: JSON escapes these.
void ObjectText::append_indented(const Json& json, std::string_view indent) {
  const std::string printed = json.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string_view rest = printed;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    text_ += rest.substr(0, end + 1);
    text_ += indent;
    rest.remove_prefix(end + 1);
  }
  text_ += rest;
}

void ObjectText::begin_member(std::string_view key) {
  text_ += text_.empty() ? "{\n  " : ",\n  ";
  text_ += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
  text_ += ": ";
}

void ObjectText::add(std::string_view key, const Json& value) {
  begin_member(key);
  append_indented(value, "  ");
}

void ObjectText::add_members(const Json& object) {
  for (const auto& [key, value] : object.items()) add(key, value);
}

// A text that grows by doubling is copied and takes up to twice its size.
void ObjectText::make_room(std::size_t entries, std::size_t begin, std::size_t done) {
  constexpr std::size_t told_from = 64;
  if (done != told_from || entries <= done) return;
  const std::size_t of_one = (text_.size() - begin) / done + 1;
  text_.reserve(text_.size() + of_one * 17 / 16 * (entries - done) + text_.size() - begin);
}

std::string ObjectText::text() && { return text_.empty() ? "{}\n" : std::move(text_) + "\n}\n"; }

}  // namespace reeve::reports
