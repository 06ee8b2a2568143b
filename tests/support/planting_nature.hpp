// The tensions of planted data follow effects that the nominal model does not know.
//
// A contact with exponent phi lets T_low = T_high e^{-phi} through where it slides, and at least
// that much where it does not. With T_high the larger of its two tensions in newton,
//
//     tube, sheath   phi = mu theta w(v) w(N) w(t) (T_high / 10 N)^{-gamma},  less F_b
//                    w(v) = 1 + beta ln(v / 10 mm/s)     w(N) = 1 + beta (1 - e^{-N/N0})
//                    w(t) = 1 - k (t - 20 degC)          a factor below 0 is 0
//                    and w = 1 + h releasing
//     bearing        phi = mu theta,                less F_d + c max(0, T_high - T_0)
//
// "less F": T_low = T_high e^{-phi} - F, not below 0. All of it is an exponent that depends on
// T_high, phi' = -ln(e^{-phi} - F / T_high), and the tensions are a fixed point: solved by the
// independent reference model again and again, with the exponents of the last tensions.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/reference_model.hpp"

namespace reeve::testing {

// Of one reading. What is not known does not act.
struct Condition {
  std::string word;
  std::set<int> held;
  ReferenceDirection direction = ReferenceDirection::pull;
  double motor_tension_N = 0;
  std::optional<double> speed_mm_s, cycle, temperature_C;
  std::map<ContactName, double> exponent_factor;  // what mounting did to the contacts
};

// Rows of that routing that are recorded in one grasp are measured in another.
struct WrongGrasp {
  std::string word;
  std::set<int> recorded, actual;
};

// Named by its two segments in walk order: a-T1 (planting_seizure.hpp).
struct SeizedContact {
  std::string word;
  std::string contact;
};

struct Nature {
  double tube_mu = 0.18, bearing_mu = 0.001, sheath_mu = 0.18;
  double load_exponent = 0;                 // gamma, 1
  double speed_slope = 0;                   // beta of w(v), 1
  double wear_change = 0;                   // beta of w(N), 1
  double wear_cycles = 500;                 // N0
  double temperature_slope_per_K = 0;       // k
  double release_change = 0;                // h
  double bending_force_N = 0;               // F_b
  double drag_force_N = 0;                  // F_d
  double drag_slope = 0, drag_onset_N = 0;  // c and T_0
  std::map<int, double> sheath_change_rad;  // by the finger that a sheath leads to
  std::vector<WrongGrasp> wrong_grasps;
  std::vector<SeizedContact> seized;  // at most one for a routing
};

// In newton, by segment name. Throws std::runtime_error if the fixed point is not reached.
std::map<std::string, double> planted_tensions(const Nature& nature, const Condition& recorded);

// Whether bending or drag leaves a stretch of tendon slack: what lies behind it, towards another
// motor-side segment, has no tension that the laws would determine.
bool goes_slack(const Nature& nature, const Condition& recorded);

// The paper's hardware, by which everything nominal is meant.
ReferenceHardware nominal_hardware();

}  // namespace reeve::testing
