// Units that columns may be in, and what they are in those of reeve: value = factor · x + offset.
//
//   force         N; the pound-force and the kilogram-force are those of the standard fall
//                 (9.80665 m/s²), since a scale that shows kg shows kgf
//   speed         mm/s
//   temperature   °C
//   angle         rad
//   length        mm
//   time          s
//
// Factors are exact by definition (NIST SP 811, appendix B).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

enum class Dimension : std::uint8_t { none, force, speed, temperature, angle, length, time };

struct Unit {
  Dimension dimension = Dimension::none;
  const char* name = "";
  double factor = 1;
  double offset = 0;

  double converted(double value) const { return factor * value + offset; }
  double back(double value) const { return (value - offset) / factor; }
  bool is_own() const { return factor == 1 && offset == 0; }

  friend bool operator==(const Unit& a, const Unit& b) {
    return a.dimension == b.dimension && a.factor == b.factor && a.offset == b.offset;
  }
};

// Finds a unit in any spelling (lbf, LBS, °C), with or without brackets. Returns nothing if the
// text is no unit of that dimension.
std::optional<Unit> find_unit(std::string_view text, Dimension dimension);
// True if the text is a unit of some dimension.
bool is_unit(std::string_view text);
// "[N]" → "N"; without blanks at its ends.
std::string_view without_brackets(std::string_view text);
// Returns the unit that reeve computes in.
Unit own_unit(Dimension dimension);
// "N, mN, …"
std::string unit_names(Dimension dimension);
// "force"
const char* dimension_name(Dimension dimension);

}  // namespace reeve::readings
