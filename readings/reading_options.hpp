// What the user says about a file of readings besides what stands in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"
#include "readings/known_noise.hpp"

namespace reeve::readings {

// The column with the first name is read as if it had the second.
struct ColumnMeaning {
  std::string column;
  std::string meaning;
};

// Of one column, or of all tensions.
struct ColumnUnit {
  std::optional<std::string> column;
  std::string unit;
};

struct ReadingOptions {
  std::vector<ColumnMeaning> map;
  std::vector<ColumnUnit> units;
  std::optional<std::string> group;  // the column whose text groups rows: a winch, an operator
  std::vector<ColumnNoise> noise{};
  // What messages advise: how whoever reads the file calls `map`, and `units`.
  std::string map_option{};
  std::string unit_option{};
};

// "Kraft Motor=motor_tension_N". Throws InputError.
ColumnMeaning parse_column_meaning(const std::string& text);
// "lbf", "T1=kgf". Throws InputError.
ColumnUnit parse_column_unit(const std::string& text);

}  // namespace reeve::readings
