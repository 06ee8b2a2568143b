#include "pages/shell/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <vector>

#include "core/finger_guides.hpp"
#include "pages/page_words.hpp"
#include "pages/shell/template.hpp"
#include "reports/data_text.hpp"
#include "reports/model_text.hpp"

namespace reeve::pages {
namespace {

std::string six_digits(double value) { return fmt::format("{:.6g}", value); }

struct HardwareRows {
  void add(const std::string& part, const char* quantity, double value, const char* unit) {
    table.add({part, quantity, six_digits(value), unit});
  }
  void add(const std::string& part, const char* quantity, const std::optional<double>& value,
           const char* unit) {
    if (value) add(part, quantity, *value, unit);
  }
  void add(const std::string& part, const ContactLaw& law) {
    add(part, "friction coefficient", law.mu, "1");
    add(part, "wrap angle", law.whole_angle_rad(), "rad");
  }

  Table table{
      {text_column("part"), text_column("quantity"), number_column("value"), text_column("unit")},
      {}};
};

// "11, 8 mm" of the joints, from the palm to the tip; "" where they have none of it.
std::string of_joints(const std::vector<FingerJoint>& joints, double FingerJoint::*quantity,
                      const char* name, const char* unit) {
  std::vector<std::string> values;
  bool any = false;
  for (const FingerJoint& joint : joints) {
    values.push_back(six_digits(joint.*quantity));
    any = any || joint.*quantity != 0;
  }
  if (!any) return "";
  return fmt::format(", {} {} {}", name, fmt::join(values, "/"), unit);
}

// ", guides tube (μ 0.1)/none"; "" without any.
std::string guides_text(const std::vector<FingerJoint>& joints) {
  if (!has_guides(joints)) return "";
  std::vector<std::string> guides;
  for (const FingerJoint& joint : joints) {
    const std::string mu = joint.mu ? fmt::format(" (μ {})", six_digits(*joint.mu)) : "";
    guides.push_back(joint.guide == JointGuide::none ? "none" : guide_name(joint.guide) + mu);
  }
  return fmt::format(", guides {}", fmt::join(guides, "/"));
}

// "2 joints, arms 11/8 mm, ranges 60/70°, levers 58/28 mm, springs 15/10 N mm/rad, wanted 10 N"
std::string finger_text(const FingerParts& parts) {
  std::string text;
  if (!parts.joints.empty()) {
    text = plural(parts.joints.size(), "joint");
    text += of_joints(parts.joints, &FingerJoint::arm_mm, "arms", "mm");
    text += of_joints(parts.joints, &FingerJoint::range_deg, "ranges", "°");
    text += of_joints(parts.joints, &FingerJoint::lever_mm, "levers", "mm");
    text += of_joints(parts.joints, &FingerJoint::spring_Nmm_rad, "springs", "N mm/rad");
    text += of_joints(parts.joints, &FingerJoint::rest_deg, "slack at", "°");
    text += guides_text(parts.joints);
  }
  if (!parts.force_N) return text;
  return fmt::format("{}{}{} N wanted at the tip", text, text.empty() ? "" : ", ",
                     six_digits(*parts.force_N));
}

std::string motor_text(const MotorParts& motor) {
  std::string text = fmt::format("closes in {} s", six_digits(motor.close_s));
  const auto add = [&](const std::optional<double>& value, const char* words, const char* unit) {
    if (value) text += fmt::format(", {} {} {}", words, six_digits(*value), unit);
  };
  add(motor.spool_radius_mm, "spool radius", "mm");
  add(motor.force_N, "can pull", "N");
  add(motor.stroke_mm, "can travel", "mm");
  return text;
}

}  // namespace

HtmlTable hardware_table(const Hardware& hardware) {
  HardwareRows rows;
  rows.add("tube", hardware.tube);
  rows.add("bearing", hardware.bearing);
  if (hardware.block) rows.add("floating block", *hardware.block);
  rows.add("sheath", hardware.sheath);
  for (const FingerHardware& finger : hardware.fingers) {
    const std::string part = fmt::format("finger {}", finger.finger);
    rows.add(part, "friction coefficient at the tip", finger.tip_mu, "1");
    rows.add(part, "wrap angle at the tip", finger.tip_angle_rad, "rad");
    rows.add(part, "friction coefficient of its sheaths", finger.sheath_mu, "1");
    rows.add(part, "wrap angle of its sheaths", finger.sheath_angle_rad, "rad");
    rows.add(part, "length of a strand", finger.strand_mm, "mm");
    rows.add(part, "closing, relative to the others", finger.closing, "1");
  }
  for (const ContactHardware& contact : hardware.contacts) {
    const std::string part = contact.segment + "-" + contact.other_segment;
    rows.add(part, "friction coefficient", contact.mu, "1");
    rows.add(part, "wrap angle", contact.angle_rad, "rad");
  }
  rows.add("strand", "length", hardware.strand_mm, "mm");
  rows.add("motor-side segment", "length", hardware.motor_side_mm, "mm");
  rows.add("other segment at the hand", "length", hardware.hand_mm, "mm");
  return {"hardware-table", "Hardware", std::move(rows.table)};
}

std::string hand_text(const Hardware& hardware) {
  std::vector<std::string> texts;
  const auto add = [&](const std::string& whose, const FingerParts& parts) {
    const std::string text = finger_text(parts);
    if (!text.empty()) texts.push_back(whose + ": " + text);
  };
  for (const FingerHardware& finger : hardware.fingers) {
    add(fmt::format("finger {}", finger.finger), finger.parts);
  }
  add(texts.empty() ? "every finger" : "other fingers", hardware.finger_parts);
  if (texts.empty()) return "";
  texts.push_back("motor: " + motor_text(hardware.motor));
  return fmt::format("{}", fmt::join(texts, "; "));
}

HtmlTable grasp_table(const GraspSet& grasps) {
  Table table{{text_column("grasp"), number_column("weight")}, {}};
  for (const WeightedGrasp& grasp : grasps) {
    table.add({grasp_words(grasp.grasp), six_digits(grasp.weight)});
  }
  return {"grasps-table", "Grasps, and their weights in the means", std::move(table)};
}

std::string settings_html(const Model& model, std::uint64_t unconverged, const GraspSet& grasps,
                          const std::string& command, const std::string& more) {
  Json lines = Json::array();
  for (const DocumentLine& line : model_lines(model, unconverged))
    lines.push_back({{"text", line.text}});
  return render("settings.mustache", {{"model", lines},
                                      {"grasps", html(grasp_table(grasps))},
                                      {"hardware", html(hardware_table(model.hardware))},
                                      {"hand", hand_text(model.hardware)},
                                      {"more", more},
                                      {"command", command}});
}

}  // namespace reeve::pages
