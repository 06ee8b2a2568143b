// Options that the user gives with a file of readings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

// Known scatter of a channel's readings, before any data are seen: from a data sheet's accuracy, a
// calibration, a dead weight.
//
//   sd² = absolute² + (relative T)²
//
// T is the tension that the sensor should read. Both parts are 0 if it is exact, such as the force
// of a weight that hangs at the far end of a bench.
struct KnownNoise {
  double relative = 0;
  double absolute_N = 0;

  double deviation(double tension_N) const;
};

// "2 % and 0.3 N", "exact".
std::string noise_text(const KnownNoise& noise);

// Noise of one column of tensions, by any of its names (column_name.hpp), or of the motor tension:
// "motor", "T1", "Ta", "at_T1".
struct ColumnNoise {
  std::string column;
  KnownNoise noise;
};

// "motor=2%", "T1=0.3N", "T1=2%+0.3N". Throws InputError.
ColumnNoise parse_column_noise(const std::string& text);

// The column with the first name is read as if it had the second.
struct ColumnMeaning {
  std::string column;
  std::string meaning;
};

// Unit of one column, or of all tensions.
struct ColumnUnit {
  std::optional<std::string> column;
  std::string unit;
};

struct ReadingOptions {
  std::vector<ColumnMeaning> map;
  std::vector<ColumnUnit> units;
  std::optional<std::string> group;  // the column whose text groups rows: a winch, an operator
  std::vector<ColumnNoise> noise{};
  // Names of the user's options, for the advice in messages: for `map` and for `units`.
  std::string map_option{};
  std::string unit_option{};
  // The option that names the column of groups.
  std::string group_option{};
  // The option that guesses the meanings of a log's columns.
  std::string guess_option{};
  // The option that names the routing of a log without such a column. Empty if it was given.
  std::string routing_option{};
};

// "Kraft Motor=motor_tension_N". Throws InputError.
ColumnMeaning parse_column_meaning(const std::string& text);
// "lbf", "T1=kgf". Throws InputError.
ColumnUnit parse_column_unit(const std::string& text);

}  // namespace reeve::readings
