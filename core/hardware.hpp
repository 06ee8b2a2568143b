// Friction and lengths of the parts that a tendon runs through.
//
// Every contact has a friction exponent phi = mu * theta, by its kind, or overridden for one finger
// or for one contact; to a sheath's theta its wobble adds. Lengths matter only as ratios, and only
// where a contact does not slide.
//
// Defaults: the paper's mu_t = mu_s = 0.18, mu_b = 0.001 and theta = pi; theta_s = 2 pi reproduces
// its tables I, II, III and VI (the paper does not print it).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "numerics/floors.hpp"

namespace reeve::core {

// A hand is given by the joints of its fingers and the motor that pulls them. Angles are flexions,
// 0 with the hand open. hand.hpp has the laws.

// A part that leads the tendon past a joint; finger_guides.hpp has the law.
enum class JointGuide : std::uint8_t { none, pulley, tube };

// The same arm at each strand of the finger, and in every posture.
struct FingerJoint {
  double arm_mm = 0;          // moment arm of the tendon about the joint
  double range_deg = 0;       // flexion from open to closed
  double lever_mm = 0;        // fingertip force's lever about the joint, in the posture that holds
  double spring_Nmm_rad = 0;  // return spring: torque for each radian beyond its rest
  double rest_deg = 0;        // flexion at which the spring is slack; below 0: preloaded when open
  std::optional<double> held_deg{};     // flexion in the posture that holds; see held_flexion_deg
  JointGuide guide = JointGuide::none;  // none: the tendon passes without friction
  std::optional<double> mu{};           // guide's μ; that of [bearing] or [tube] if not given
  double wrap_deg = 0;                  // wrap angle round the guide with the hand open
  std::optional<double> object_deg{};   // flexion at which an object stops the phalanx
  std::optional<double> phalanx_mm{};   // length of the phalanx behind the joint

  // The flexion at which the joint stops in closing: at the object, otherwise the whole range.
  double stop_deg() const { return object_deg.value_or(range_deg); }
  // The joint holds at its stop if no other posture is given.
  double held_flexion_deg() const { return held_deg.value_or(stop_deg()); }

  friend bool operator==(const FingerJoint&, const FingerJoint&) = default;
};

// Parts of one finger, or of all fingers that have none of their own.
struct FingerParts {
  std::vector<FingerJoint> joints{};  // listed from the palm to the tip
  std::optional<double> force_N{};    // wanted force at the fingertip

  friend bool operator==(const FingerParts&, const FingerParts&) = default;
};

struct MotorParts {
  std::optional<double> spool_radius_mm{};
  double close_s = 1;  // time in which the hand is to close
  // Limits of the motor.
  std::optional<double> force_N{};
  std::optional<double> stroke_mm{};

  friend bool operator==(const MotorParts&, const MotorParts&) = default;
};

struct ContactLaw {
  double mu = 0;         // friction coefficient, 1
  double angle_rad = 0;  // wrap angle, rad
  bool known = false;    // mu was measured: who fits measured tensions leaves it as it is
  // A sheath's bends that nobody intended grow with its length, so that
  // phi = mu (theta + K x): the "wobble" of post-tensioned tendons in their ducts.
  std::optional<double> length_mm{};  // without wobble it has no effect
  double wobble_rad_per_m = 0;

  double whole_angle_rad() const {
    constexpr double mm_per_m = 1000;
    return angle_rad + wobble_rad_per_m * length_mm.value_or(0) / mm_per_m;
  }
  double exponent() const { return mu * whole_angle_rad(); }
  friend bool operator==(const ContactLaw&, const ContactLaw&) = default;
};

struct FingerHardware {
  int finger = 0;
  std::optional<double> tip_mu;
  std::optional<double> tip_angle_rad;
  std::optional<double> sheath_mu;
  std::optional<double> sheath_angle_rad;
  std::optional<double> strand_mm;
  // Share of the tendon that this finger takes when it closes, relative to the others. Fingers with
  // joints take shares by their excursions instead.
  std::optional<double> closing;  // 1 unless given
  FingerParts parts{};

  friend bool operator==(const FingerHardware&, const FingerHardware&) = default;
};

// For the contact between two segments, named as in `reeve show` (T1, a, h1); contact_name.hpp says
// which contact a name means.
struct ContactHardware {
  std::string segment;
  std::string other_segment;
  std::optional<double> mu;
  std::optional<double> angle_rad;

  friend bool operator==(const ContactHardware&, const ContactHardware&) = default;
};

// Spool of an end of a tendon on its motor's shaft, named by the motor-side segment.
struct SpoolHardware {
  std::string segment;
  // Radius over that of the carriage's travel: the end travels ratio × D. Below 0 it is wound the
  // other way and lets its tendon out.
  double ratio = 1;

  friend bool operator==(const SpoolHardware&, const SpoolHardware&) = default;
};

// TendonHardware has the values of one tendon, by its number in the word of a routing.
struct TendonHardware {
  int tendon = 0;
  // The stiffness is that of a spring in series, at the tendon's only end at a motor. Where the
  // tendon jams, the carriage goes on by T/k, which no result counts (mechanics.hpp).
  std::optional<double> stiffness_N_mm{};
  std::optional<double> slack_mm{};  // length that its motor takes in before it pulls

  friend bool operator==(const TendonHardware&, const TendonHardware&) = default;
};

struct TendonParts {
  std::optional<double> EA_N{};       // axial stiffness of every tendon, which springs are beside
  std::optional<double> travel_mm{};  // carriage travel, which slack is a part of
  std::vector<TendonHardware> own{};

  friend bool operator==(const TendonParts&, const TendonParts&) = default;
};

// No two contacts are alike: liners are cut and glued by hand, and each bend is a little other. In
// a draw each contact's exponent is that of its kind times 1 + σ z, z standard normal and a
// function of seed, draw and the contact's place in the network alone; at least 0. What the
// hardware says of the coefficient of one finger or one contact stays.
//
// Source: the σ are judgements, as the ranges of uncertainty_ranges.hpp: cut and mounted by hand,
// contacts of one kind differ by some percent.
struct ContactScatter {
  double relative = 0.04;         // σ of tubes and sheaths
  double bearing_relative = 0.1;  // σ of bearings and of blocks' sheaves

  friend bool operator==(const ContactScatter&, const ContactScatter&) = default;
};

struct ContactDraw {
  std::uint64_t seed = 0;
  std::uint64_t draw = 0;

  friend bool operator==(const ContactDraw&, const ContactDraw&) = default;
};

// The file of a hardware, and where it says something: "finger.2.tip_mu" at "h.toml:3:1".
struct HardwareOrigin {
  std::string file;
  std::map<std::string, std::string> places;
};

struct Hardware {
  ContactLaw tube{0.18, std::numbers::pi};
  ContactLaw bearing{0.001, std::numbers::pi};
  ContactLaw sheath{0.18, 2 * std::numbers::pi};
  std::optional<ContactLaw> block{};  // floating block's sheave; the bearing's law if not given
  double strand_mm = 100;
  double motor_side_mm = 100;
  double hand_mm = 100;
  std::vector<FingerHardware> fingers;
  std::vector<ContactHardware> contacts;
  std::vector<SpoolHardware> spools{};  // spools of ends that differ from the others
  TendonParts tendon{};
  FingerParts finger_parts{};  // parts of fingers that have none of their own
  MotorParts motor{};
  ContactScatter scatter{};
  std::optional<ContactDraw> contact_draw{};       // not in files; without it exponents are nominal
  std::shared_ptr<const HardwareOrigin> origin{};  // none if it is of no file
};

// The place of an error about this key: "h.toml:3:1: hardware" if the file says something of it,
// else "h.toml: hardware", or "hardware" of no file.
std::string hardware_place(const Hardware& hardware, std::string key);
// Throws InputError where an end at a motor has a spool of its own.
void require_no_spools(const Hardware& hardware, const char* expected);
// Throws InputError where a tendon has a spring or slack.
void require_no_springs(const Hardware& hardware, const char* expected);

// Beyond any physical contact (rope three times round pine has phi = 3), and small enough that
// e^{-phi} along a whole tendon stays a number.
inline constexpr double max_exponent = 10;

// True if fingers 1 … n have the same parts, of their own or by default. Fingers are not alike if a
// contact, a spool or a tendon has values of its own, or if contacts are drawn with scatter.
bool treats_fingers_alike(const Hardware& hardware, int fingers);

// The first quantity out of its range, with its value and what was expected; nothing if the
// hardware is one that there can be.
std::optional<InputFault> fault(const Hardware& hardware);
// Throws it as an InputError.
void validate(const Hardware& hardware);

}  // namespace reeve::core
