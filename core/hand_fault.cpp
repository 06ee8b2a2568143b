#include "core/hand_fault.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace reeve::core {
namespace {

struct JointRow {
  const char* name;
  double FingerJoint::*value;
  double low;
  double high;
  const char* unit;
};
constexpr JointRow joint_rows[] = {
    {"arm_mm", &FingerJoint::arm_mm, 0.01, 1000, "mm"},
    {"range_deg", &FingerJoint::range_deg, 0.1, 360, "deg"},
    {"lever_mm", &FingerJoint::lever_mm, 0.01, 1000, "mm"},
    {"spring_Nmm_rad", &FingerJoint::spring_Nmm_rad, 0, 1e6, "N mm/rad"},
    {"rest_deg", &FingerJoint::rest_deg, -360, 360, "deg"},
};

constexpr double greatest_force_N = 1e5;

class HandFaultFinder {
 public:
  explicit HandFaultFinder(const Hardware& hardware) : hardware_(hardware) {}

  const std::optional<InputFault>& first() const { return first_; }

  void look_at(const std::string& where, const FingerParts& parts) {
    for (std::size_t j = 0; j < parts.joints.size(); ++j) {
      look_at(fmt::format("{}.joints[{}]", where, j + 1), parts.joints[j]);
    }
    range(where + ".force_N", parts.force_N, 0, greatest_force_N, "N");
  }

  void look_at(const MotorParts& motor) {
    range("motor.spool_radius_mm", motor.spool_radius_mm, 0.1, 1000, "mm");
    range("motor.close_s", motor.close_s, 0.001, 3600, "s");
    range("motor.force_N", motor.force_N, 0.001, greatest_force_N, "N");
    range("motor.stroke_mm", motor.stroke_mm, 0.001, 1e5, "mm");
  }

  void require_force(const std::string& where, const FingerParts& own, const FingerParts& common) {
    const bool has_joints = !own.joints.empty() || !common.joints.empty();
    if (first_ || !has_joints || own.force_N || common.force_N) return;
    first_ = {.where = hardware_place(hardware_, where),
              .what = fmt::format("{}: its joints are given, and no force_N", where),
              .expected = "the force wanted at the fingertip, there or in [hand]"};
  }

 private:
  void look_at(const std::string& where, const FingerJoint& joint) {
    for (const JointRow& row : joint_rows) {
      range(fmt::format("{}.{}", where, row.name), joint.*row.value, row.low, row.high, row.unit);
    }
    range(where + ".held_deg", joint.held_deg, 0, joint.range_deg, "deg");
  }

  void range(const std::string& what, const std::optional<double>& value, double low, double high,
             const char* unit) {
    if (first_ || !value || (*value >= low && *value <= high)) return;
    first_ = {.where = hardware_place(hardware_, what),
              .what = what,
              .value = fmt::format("{}", *value),
              .expected = fmt::format("a number from {} to {} {}", low, high, unit),
              .form = InputForm::equals};
  }

  const Hardware& hardware_;
  std::optional<InputFault> first_;
};

}  // namespace

std::optional<InputFault> hand_fault(const Hardware& hardware) {
  HandFaultFinder finder(hardware);
  finder.look_at("hand", hardware.finger_parts);
  for (const FingerHardware& finger : hardware.fingers) {
    const std::string where = fmt::format("finger.{}", finger.finger);
    finder.look_at(where, finger.parts);
    finder.require_force(where, finger.parts, hardware.finger_parts);
  }
  finder.look_at(hardware.motor);
  return finder.first();
}

}  // namespace reeve::core
