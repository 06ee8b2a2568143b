#include "catalog/hand_tables.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "catalog/hardware_tables.hpp"
#include "core/finger_guides.hpp"
#include "core/hand.hpp"

namespace reeve::catalog {
namespace {

// Core knows the ranges.
template <typename Number>
void read_number_if_given(const TomlNode& table, std::string_view key, Number& number) {
  if (const TomlNode* node = table.find(key)) number = node->finite_number();
}

void read_guide(const TomlNode& node, FingerJoint& joint) {
  const char* expected = "\"pulley\" or \"tube\"";
  const TomlNode* guide = node.find("guide");
  for (const char* key : {"mu", "wrap_deg"}) {
    if (guide == nullptr && node.find(key) != nullptr) node.require("guide", expected);
  }
  if (guide == nullptr) return;
  joint.guide = guide->text() == "pulley" ? JointGuide::pulley : JointGuide::tube;
  if (guide->text() != guide_name(joint.guide)) guide->fail_expected(expected);
  read_number_if_given(node, "mu", joint.mu);
  read_number_if_given(node, "wrap_deg", joint.wrap_deg);
}

FingerJoint read_joint(const TomlNode& node) {
  FingerJoint joint;
  node.table().allow_only({"arm_mm", "range_deg", "lever_mm", "spring_Nmm_rad", "rest_deg",
                           "held_deg", "guide", "mu", "wrap_deg", "object_deg", "phalanx_mm"});
  const auto required = [&](std::string_view key, std::string_view expected) {
    return node.require(key, expected).finite_number();
  };
  joint.arm_mm = required("arm_mm", "the tendon's moment arm about the joint, in mm");
  joint.range_deg = required("range_deg", "the joint's range of flexion, in degrees");
  joint.lever_mm = required("lever_mm", "the fingertip force's lever about the joint, in mm");
  read_number_if_given(node, "spring_Nmm_rad", joint.spring_Nmm_rad);
  read_number_if_given(node, "rest_deg", joint.rest_deg);
  read_number_if_given(node, "held_deg", joint.held_deg);
  read_number_if_given(node, "object_deg", joint.object_deg);
  read_number_if_given(node, "phalanx_mm", joint.phalanx_mm);
  read_guide(node, joint);
  return joint;
}

std::string number_line(std::string_view key, const std::optional<double>& value) {
  return value ? fmt::format("{} = {}\n", key, *value) : "";
}

// fmt's shortest form reads back as the same number.
std::string joint_toml(const FingerJoint& joint) {
  std::string text = fmt::format(
      "  {{ arm_mm = {}, range_deg = {}, lever_mm = {}, spring_Nmm_rad = {}, rest_deg = {}",
      joint.arm_mm, joint.range_deg, joint.lever_mm, joint.spring_Nmm_rad, joint.rest_deg);
  const auto add = [&](std::string_view key, const std::optional<double>& value) {
    if (value) text += fmt::format(", {} = {}", key, *value);
  };
  add("held_deg", joint.held_deg);
  if (joint.guide != JointGuide::none) {
    text += fmt::format(", guide = \"{}\"", guide_name(joint.guide));
    add("mu", joint.mu);
    add("wrap_deg", joint.wrap_deg);
  }
  add("object_deg", joint.object_deg);
  add("phalanx_mm", joint.phalanx_mm);
  return text + " },\n";
}

}  // namespace

FingerParts read_finger_parts(const TomlNode& table) {
  constexpr std::string_view expected =
      "from 1 to 16 joints, such as [{ arm_mm = 9, range_deg = 80, lever_mm = 75 }]";
  constexpr std::size_t most = 16;
  FingerParts parts;
  if (const TomlNode* joints = table.find("joints")) {
    const bool is_list = joints->kind == TomlKind::array;
    if (!is_list || joints->children.empty() || joints->children.size() > most) {
      joints->fail_expected(expected);
    }
    for (const TomlNode& joint : joints->children) parts.joints.push_back(read_joint(joint));
  }
  read_number_if_given(table, "force_N", parts.force_N);
  return parts;
}

void read_hand(const TomlNode& table, Hardware& hardware) {
  table.allow_only({"joints", "force_N"});
  hardware.finger_parts = read_finger_parts(table);
}

void read_motor(const TomlNode& table, Hardware& hardware) {
  table.allow_only({"spool_radius_mm", "close_s", "force_N", "stroke_mm"});
  read_number_if_given(table, "spool_radius_mm", hardware.motor.spool_radius_mm);
  read_number_if_given(table, "close_s", hardware.motor.close_s);
  read_number_if_given(table, "force_N", hardware.motor.force_N);
  read_number_if_given(table, "stroke_mm", hardware.motor.stroke_mm);
}

void require_joints(const TomlNode& file, const Hardware& hardware) {
  if (hand(hardware)) return;
  const auto fail = [](const TomlNode& node) {
    node.fail_at_key(
        {.what = fmt::format("{} says something of a hand, and no finger has joints", node.name),
         .expected = "joints in [hand] or in [finger.1], [finger.2], …"});
  };
  for (const char* name : {"hand", "motor"}) {
    if (const TomlNode* node = file.find(name)) fail(*node);
  }
  const TomlNode* fingers = file.find("finger");
  if (fingers == nullptr) return;
  for (const TomlNode& finger : fingers->children) {
    if (const TomlNode* force = finger.find("force_N")) fail(*force);
  }
}

std::string finger_parts_toml(const FingerParts& parts) {
  std::string text = number_line("force_N", parts.force_N);
  if (parts.joints.empty()) return text;
  text += "joints = [\n";
  for (const FingerJoint& joint : parts.joints) text += joint_toml(joint);
  return text + "]\n";
}

std::string hand_toml(const Hardware& hardware) {
  std::string text;
  if (hardware.finger_parts != FingerParts{}) {
    text += "[hand]\n" + finger_parts_toml(hardware.finger_parts) + "\n";
  }
  const MotorParts& motor = hardware.motor;
  if (motor != MotorParts{}) {
    text += "[motor]\n" + number_line("spool_radius_mm", motor.spool_radius_mm) +
            number_line("close_s", motor.close_s) + number_line("force_N", motor.force_N) +
            number_line("stroke_mm", motor.stroke_mm) + "\n";
  }
  return text;
}

}  // namespace reeve::catalog
