// The words that people's names of columns are made of.
//
// "Motor Tension [lbf]", "motor_tension_lbf" and "MotorTension (lbf)" are the letters
// "motortension" and the unit lbf: blanks, _, - and . part words, and brackets at the end hold a
// unit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

struct NameWords {
  std::vector<std::string> words;        // in small letters
  std::optional<std::string> bracketed;  // as written
};

NameWords words_of(std::string_view name);
// The first `count` words as one.
std::string joined(const NameWords& name, std::size_t count);

// "[N]" → "N"; without blanks at its ends.
std::string_view without_brackets(std::string_view text);

std::string lower(std::string_view text);

// In bytes, of a run, a group or a column: each stands many times in tables and drawings.
inline constexpr std::size_t longest_name = 200;

// Throws InputError on a longer one.
void require_short_name(std::string_view name);

}  // namespace reeve::readings
