// Meaning of a column's name, in any spelling.
//
//   run, routing, held, direction     text
//   motor_tension, speed, cycle, temperature, sheath_angle, readings
//   time, timestamp, position, pos    of the log of a rig; a letter alone is a time as t, t_s, t_ms
//                                     or with a unit in brackets, since T_min may be a tension
//   T1, T2, …                         tensions of strands
//   Ta, Tb, … and Th1, …              of motor-side segments and of stretches at the hand; only
//                                     with a unit of force, since Ta may be a temperature
//   at_T1, …                          of the motor-side segment at that strand's sheath
//   T1_sd, Ta_sd, at_T1_sd, …         standard deviations of those, and motor_tension_sd
//
// The unit follows: T1_N, T1 [lbf], temperature_F. Its dimension must be that of the name, so that
// "T1 [°C]" is no tension.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/network.hpp"
#include "readings/units.hpp"

namespace reeve::readings {

// The words that people's names of columns are made of.
// "Motor Tension [lbf]", "motor_tension_lbf" and "MotorTension (lbf)" are the letters
// "motortension" and the unit lbf: blanks, _, - and . part words, and brackets at the end hold a
// unit, as does what follows " / " or " in ".
struct NameWords {
  std::vector<std::string> words;        // in small letters
  std::optional<std::string> bracketed;  // text in brackets, or the unit behind, as written
};

NameWords words_of(std::string_view name);
// The first `count` words as one.
std::string joined(const NameWords& name, std::size_t count);

// Limit in bytes for the name of a run, a group or a column: each appears many times in tables and
// drawings.
inline constexpr std::size_t longest_name = 200;

// Throws InputError on a longer one.
void require_short_name(std::string_view name);

enum class DataRole : std::uint8_t {
  run,
  routing,
  held,
  direction,
  motor_tension,
  speed,
  cycle,
  temperature,
  sheath_angle,
  tension,
  covariate,
  readings,   // number of samples that a row is the mean of
  deviation,  // standard deviation of these samples
  motor_deviation,
  group,  // column that the user names
  no_name,
  time,  // clock of a log, as position
  position,
};

// Segment whose tension a column holds.
struct MeasuredPlace {
  Segment segment;
  bool beside = false;  // the motor-side segment at this strand, whatever its letter

  friend bool operator==(const MeasuredPlace&, const MeasuredPlace&) = default;
};

struct ColumnName {
  DataRole role = DataRole::covariate;
  MeasuredPlace place;       // tensions and their deviations only
  std::optional<Unit> unit;  // if the name says one
  bool needs_unit = false;   // else it is a covariate
};

// Returns nothing for other names. Throws InputError on a name such as T0_N, which looks like a
// tension's and is none.
std::optional<ColumnName> column_named(std::string_view name);
// Returns nothing for a name that cannot be read, either.
std::optional<ColumnName> try_column_named(std::string_view name);

// A tension's name with another unit: "T3 [V]", "motor_tension_mA".
struct NoForce {
  ColumnName meant;
  std::string unit;  // as written
};

// Returns nothing of a name whose unit tells another quantity, such as the temperature "T3 [°C]".
std::optional<NoForce> tension_in_no_unit_of_force(std::string_view name);

// Returns the seconds in a unit of that clock; nothing if it is no name of a clock.
std::optional<double> clock_unit(std::string_view name);

Dimension dimension_of(DataRole role);
// True if cells of this role must be numbers. Covariates may turn out to be words.
bool is_of_numbers(DataRole role);
// True if a force sensor reads it. Such a sensor has a zero.
bool is_of_sensor(DataRole role);
// Returns the name as the docs write it: motor_tension_N, T1_N, at_T1_N, Ta_sd_N.
std::string plain_name(const ColumnName& name);
// True if `text`, which has this meaning, is written as in the docs. A clock has several names
// there.
bool is_plain(std::string_view text, const ColumnName& name);

}  // namespace reeve::readings
