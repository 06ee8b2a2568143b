// A third way to the tensions of a mechanism: pulling the carriage in small steps.
//
// Every segment starts with the same small tension, that of one step. Each step moves the carriage
// by D / steps and closes the fingers by (1 - eps) dl / steps; from x of the step before
//
//   L_i T_i = x_i + e_i + sum of slips + C_i z,   sum_i C_ib T_i = 0,
//   a contact slips only at the edge of its cone, to the side of the greater tension,
//
// all contacts and blocks together (Newton on the piecewise linear whole). The z of the blocks are
// not taken from the kinematics, but left to the balances. What the start leaves fades as 1 /
// steps.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tests/support/reference_model.hpp"

namespace reeve::testing {

// At D = 1 and EA = 1.
struct LoadedPull {
  std::map<std::string, double> tension;  // by segment name
  double motor = 0;
};
// The tendons take up `take_up`, eps, of the travel: not only in the limit of stiff tendons.
LoadedPull loaded_pull(const std::string& word, const std::set<int>& held,
                       const ReferenceHardware& hardware, int steps, double take_up);

// By segment name; the motor-side segments sum to 1. Throws std::invalid_argument as the reference
// model does and where the grasp jams, std::logic_error where a tendon goes slack and where a step
// finds no state: the Newton steps of one in twenty mechanisms, mostly with loops, chase each
// other.
std::map<std::string, double> loaded_tensions(const std::string& word, const std::set<int>& held,
                                              const ReferenceHardware& hardware, int steps);

}  // namespace reeve::testing
