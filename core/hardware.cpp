#include "core/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/finger_guides.hpp"
#include "core/hand.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"

namespace reeve::core {
namespace {

struct Bounds {
  double low = 0;
  double high = 0;
  const char* unit = "";
};
constexpr Bounds coefficients{0, 10, ""};
constexpr Bounds angles{0, 1000, "rad"};
constexpr Bounds lengths{1e-3, 1e6, "mm"};
constexpr Bounds wobbles{0, 100, "rad/m"};
constexpr Bounds closing_weights{1e-3, 1e3, ""};
constexpr Bounds spool_ratios{1e-3, 1e3, ""};
constexpr Bounds axial_stiffnesses{1, 1e9, "N"};
constexpr Bounds stiffnesses{1e-3, 1e6, "N/mm"};
constexpr Bounds slacks{0, 1e6, "mm"};
constexpr Bounds fingertip_forces{0, 1e5, "N"};
constexpr Bounds spool_radii{0.1, 1000, "mm"};
constexpr Bounds closing_times{0.001, 3600, "s"};
constexpr Bounds motor_forces{0.001, 1e5, "N"};
constexpr Bounds strokes{0.001, 1e5, "mm"};
constexpr Bounds guide_coefficients{0, 1, ""};
constexpr Bounds phalanges{0.01, 1000, "mm"};

struct JointRow {
  const char* name;
  double FingerJoint::*value;
  Bounds bounds;
};
constexpr JointRow joint_rows[] = {
    {"arm_mm", &FingerJoint::arm_mm, {0.01, 1000, "mm"}},
    {"range_deg", &FingerJoint::range_deg, {0.1, 360, "deg"}},
    {"lever_mm", &FingerJoint::lever_mm, {0.01, 1000, "mm"}},
    {"spring_Nmm_rad", &FingerJoint::spring_Nmm_rad, {0, 1e6, "N mm/rad"}},
    {"rest_deg", &FingerJoint::rest_deg, {-360, 360, "deg"}},
    {"wrap_deg", &FingerJoint::wrap_deg, {0, 720, "deg"}},
};

class FaultFinder {
 public:
  explicit FaultFinder(const Hardware& hardware) : hardware_(hardware) {}

  std::optional<InputFault> first() {
    law("tube", hardware_.tube);
    law("bearing", hardware_.bearing);
    law("sheath", hardware_.sheath);
    if (hardware_.block) law("block", *hardware_.block);
    range("lengths", "strand_mm", hardware_.strand_mm, lengths);
    range("lengths", "motor_side_mm", hardware_.motor_side_mm, lengths);
    range("lengths", "hand_mm", hardware_.hand_mm, lengths);
    range("sheath", "length_mm", hardware_.sheath.length_mm, lengths);
    range("sheath", "wobble_rad_per_m", hardware_.sheath.wobble_rad_per_m, wobbles);
    look_at_fingers();
    for (const ContactHardware& contact : hardware_.contacts) look_at(contact);
    for (const SpoolHardware& spool : hardware_.spools) look_at(spool);
    look_at(hardware_.tendon);
    look_at_hand();
    return first_;
  }

 private:
  void look_at_fingers() {
    std::uint64_t seen = 0;
    for (const FingerHardware& finger : hardware_.fingers) {
      look_at(finger);
      if (first_) return;
      const std::uint64_t bit = std::uint64_t{1} << (finger.finger - 1);
      if ((seen & bit) != 0) {
        first_ = {.where = hardware_place(hardware_, fmt::format("finger.{}", finger.finger)),
                  .what = fmt::format("finger {} is given twice", finger.finger)};
      }
      seen |= bit;
    }
  }

  void look_at_hand() {
    look_at("hand", hardware_.finger_parts);
    for (const FingerHardware& finger : hardware_.fingers) {
      const std::string where = fmt::format("finger.{}", finger.finger);
      look_at(where, finger.parts);
      require_force(where, finger.parts);
    }
    range("motor", "spool_radius_mm", hardware_.motor.spool_radius_mm, spool_radii);
    range("motor", "close_s", hardware_.motor.close_s, closing_times);
    range("motor", "force_N", hardware_.motor.force_N, motor_forces);
    range("motor", "stroke_mm", hardware_.motor.stroke_mm, strokes);
  }

  static InputFault fault(std::string where, std::string what, double value, std::string expected) {
    return {.where = std::move(where),
            .what = std::move(what),
            .value = fmt::format("{}", value),
            .expected = std::move(expected),
            .form = InputForm::equals};
  }

  void range(std::string_view where, std::string_view what, const std::optional<double>& value,
             const Bounds& bounds) {
    if (first_ || !value || (*value >= bounds.low && *value <= bounds.high)) return;
    const std::string key = fmt::format("{}.{}", where, what);
    first_ = fault(hardware_place(hardware_, key), key, *value,
                   fmt::format("a number from {} to {}{}{}", bounds.low, bounds.high,
                               *bounds.unit == 0 ? "" : " ", bounds.unit));
  }

  // `part` is the contact in the finger's table that the exponent belongs to.
  void exponent(const std::string& table, std::string_view part, double phi) {
    if (first_ || phi <= max_exponent) return;
    first_ = fault(fmt::format("{}: {}{}", hardware_place(hardware_, table), table, part),
                   "mu * angle", phi, fmt::format("at most {}", max_exponent));
  }

  void law(const std::string& where, const ContactLaw& law) {
    range(where, "mu", law.mu, coefficients);
    range(where, "angle_rad", law.angle_rad, angles);
    exponent(where, "", law.exponent());
  }

  void look_at(const FingerHardware& finger) {
    if (!first_ && !(finger.finger >= 1 && finger.finger <= max_fingers)) {
      first_ = fault(hardware_place(hardware_, "finger"), "finger number", finger.finger,
                     fmt::format("a number from 1 to {}", max_fingers));
    }
    const std::string where = fmt::format("finger.{}", finger.finger);
    range(where, "tip_mu", finger.tip_mu, coefficients);
    range(where, "tip_angle_rad", finger.tip_angle_rad, angles);
    range(where, "sheath_mu", finger.sheath_mu, coefficients);
    range(where, "sheath_angle_rad", finger.sheath_angle_rad, angles);
    range(where, "strand_mm", finger.strand_mm, lengths);
    range(where, "closing", finger.closing, closing_weights);
    for (const ContactLaw& tip : {hardware_.tube, hardware_.bearing}) {
      exponent(where, " tip",
               finger.tip_mu.value_or(tip.mu) * finger.tip_angle_rad.value_or(tip.angle_rad));
    }
    ContactLaw sheath = hardware_.sheath;
    sheath.mu = finger.sheath_mu.value_or(sheath.mu);
    sheath.angle_rad = finger.sheath_angle_rad.value_or(sheath.angle_rad);
    exponent(where, " sheath", sheath.exponent());
  }

  void look_at(const ContactHardware& contact) {
    const std::string where = fmt::format("contact.{}-{}", contact.segment, contact.other_segment);
    range(where, "mu", contact.mu, coefficients);
    range(where, "angle_rad", contact.angle_rad, angles);
  }

  void look_at(const SpoolHardware& spool) {
    const Bounds backward{-spool_ratios.high, -spool_ratios.low, ""};
    range("spools", spool.segment, spool.ratio, spool.ratio < 0 ? backward : spool_ratios);
    const auto segment = segment_named(spool.segment);
    if (first_ || (segment && segment->kind == SegmentKind::motor_side)) return;
    first_ = {.where = hardware_place(hardware_, "spools." + spool.segment),
              .what = "spools",
              .value = spool.segment,
              .expected = "a motor-side segment such as a"};
  }

  void look_at(const TendonParts& parts) {
    range("tendon", "EA_N", parts.EA_N, axial_stiffnesses);
    range("tendon", "travel_mm", parts.travel_mm, lengths);
    for (const TendonHardware& tendon : parts.own) {
      const std::string where = fmt::format("tendon.{}", tendon.tendon);
      range(where, "stiffness_N_mm", tendon.stiffness_N_mm, stiffnesses);
      range(where, "slack_mm", tendon.slack_mm, slacks);
      require_beside(where + ".stiffness_N_mm", tendon.stiffness_N_mm, parts.EA_N,
                     "EA_N in [tendon]: the spring gives way beside the tendon's own EA/L");
      require_beside(where + ".slack_mm", tendon.slack_mm, parts.travel_mm,
                     "travel_mm in [tendon]: the carriage travel that slack is a part of");
    }
  }

  void look_at(const std::string& where, const FingerParts& parts) {
    for (std::size_t j = 0; j < parts.joints.size(); ++j) {
      look_at(fmt::format("{}.joints[{}]", where, j + 1), parts.joints[j]);
    }
    range(where, "force_N", parts.force_N, fingertip_forces);
    require_small_exponent(where + ".joints", parts.joints);
  }

  void look_at(const std::string& where, const FingerJoint& joint) {
    for (const JointRow& row : joint_rows) range(where, row.name, joint.*row.value, row.bounds);
    range(where, "object_deg", joint.object_deg, {0, joint.range_deg, "deg"});
    range(where, "held_deg", joint.held_deg, {0, joint.stop_deg(), "deg"});
    range(where, "mu", joint.mu, guide_coefficients);
    range(where, "phalanx_mm", joint.phalanx_mm, phalanges);
  }

  void require_small_exponent(const std::string& where, const std::vector<FingerJoint>& joints) {
    if (first_ || joints.empty()) return;
    const double exponent = closed_exponent(with_guide_coefficients(joints, hardware_));
    if (exponent <= max_exponent) return;
    first_ = {.where = hardware_place(hardware_, where),
              .what = where + ": sum of mu * wrap of the closed finger",
              .value = fmt::format("{:.4g}", exponent),
              .expected = fmt::format("at most {}", max_exponent),
              .form = InputForm::equals};
  }

  void require_force(const std::string& where, const FingerParts& own) {
    const FingerParts& common = hardware_.finger_parts;
    const bool has_joints = !own.joints.empty() || !common.joints.empty();
    if (first_ || !has_joints || own.force_N || common.force_N) return;
    first_ = {.where = hardware_place(hardware_, where),
              .what = fmt::format("{}: its joints are given, and no force_N", where),
              .expected = "the force wanted at the fingertip, there or in [hand]"};
  }

  void require_beside(const std::string& key, const std::optional<double>& value,
                      const std::optional<double>& other, const char* expected) {
    if (first_ || !value || other) return;
    first_ = fault(hardware_place(hardware_, key), key, *value, expected);
  }

  const Hardware& hardware_;
  std::optional<InputFault> first_;
};

// Its own numbers, or those of all: tip and sheath coefficients, length and share.
std::array<double, 8> coefficients_of(const Hardware& hardware, int finger) {
  const auto found =
      std::find_if(hardware.fingers.begin(), hardware.fingers.end(),
                   [&](const FingerHardware& candidate) { return candidate.finger == finger; });
  const FingerHardware own = found == hardware.fingers.end() ? FingerHardware{} : *found;
  return {own.tip_mu.value_or(hardware.tube.mu),
          own.tip_angle_rad.value_or(hardware.tube.angle_rad),
          own.tip_mu.value_or(hardware.bearing.mu),
          own.tip_angle_rad.value_or(hardware.bearing.angle_rad),
          own.sheath_mu.value_or(hardware.sheath.mu),
          own.sheath_angle_rad.value_or(hardware.sheath.angle_rad),
          own.strand_mm.value_or(hardware.strand_mm),
          own.closing.value_or(1)};
}

}  // namespace

std::string hardware_place(const Hardware& hardware, std::string key) {
  if (!hardware.origin) return "hardware";
  const auto& [file, places] = *hardware.origin;
  while (!key.empty() && !places.contains(key)) {
    const std::size_t end = key.find_last_of(".[");
    key.resize(end == std::string::npos ? 0 : end);
  }
  return (key.empty() ? file : places.at(key)) + ": hardware";
}

void require_no_spools(const Hardware& hardware, const char* expected) {
  if (hardware.spools.empty()) return;
  throw InputError({.where = hardware_place(hardware, "spools"),
                    .what = "spools",
                    .value = hardware.spools.front().segment,
                    .expected = expected});
}

void require_no_springs(const Hardware& hardware, const char* expected) {
  if (hardware.tendon.own.empty()) return;
  const std::string number = std::to_string(hardware.tendon.own.front().tendon);
  throw InputError({.where = hardware_place(hardware, "tendon." + number),
                    .what = "tendon",
                    .value = number,
                    .expected = expected});
}

std::optional<InputFault> fault(const Hardware& hardware) { return FaultFinder(hardware).first(); }

void validate(const Hardware& hardware) {
  if (const auto found = fault(hardware)) throw InputError(*found);
}

bool treats_fingers_alike(const Hardware& hardware, int fingers) {
  if (!hardware.contacts.empty() || !hardware.spools.empty() || !hardware.tendon.own.empty() ||
      hardware.contact_draw) {
    return false;
  }
  for (int finger = 2; finger <= fingers; ++finger) {
    if (coefficients_of(hardware, finger) != coefficients_of(hardware, 1)) return false;
    if (finger_parts(hardware, finger) != finger_parts(hardware, 1)) return false;
  }
  return true;
}

}  // namespace reeve::core
