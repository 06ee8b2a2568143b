// Effects as a person writes them: a cause, what it is about, and its size.
//
//   load_dependent_friction            exponent=0.15
//   sensor_gain[T3]                    gain=1.08
//   seized_contact[M-1-P-2-M,T1-T2]    (no parameters)
//   wrong_grasp[M-1-P-2-M]             recorded=none, actual=1
//   law[gain of T3, supply_V, linear]  a=0.02 (named_law.hpp)
//
// The first parameter is the cause's size and must be set; others shape the law, and are in the
// middle of their literature range unless they are set. `recorded` and `actual` choose among the
// grasps that a wrong grasp may be about; without them the first is taken.
#pragma once

#include <string>
#include <vector>

#include "causes/cause.hpp"
#include "core/hardware.hpp"

namespace reeve::causes {

struct Setting {
  std::string key;
  std::string value;
};

struct NamedEffect {
  std::string name;
  std::vector<Setting> settings;
};

// A property without which an experiment shows nothing of a cause.
struct Lack {
  bool Survey::*has;
  const char* why;     // "it depends on the cycle"
  const char* wanted;  // "it to be given"
};

// Returns the lack that keeps an experiment from showing the cause of this name; nullptr if there
// is none, or no such cause.
const Lack* lack(const std::string& name, const Survey& survey);

// Throws InputError that begins with the quoted name. `hardware` is the one that the effect is
// seen against.
Effect effect_of(const NamedEffect& named, const Survey& survey, const Hardware& hardware);

// "exponent = 0.15", "recorded none, really 1"; empty if there is nothing to say besides the name.
std::string size_text(const Effect& effect, const Hardware& hardware);

}  // namespace reeve::causes
