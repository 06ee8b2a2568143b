// What the header of a logger's file says: which column holds what.
//
//   time_s, t_s, t, time, timestamp    the clock in seconds, required; time_ms, t_ms in
//                                      milliseconds
//   position_mm, speed_mm_s            how the carriage moves
//   motor_tension_N, T1_N, Ta_N, …     tensions, as in a file of readings (data_columns.hpp)
//   run, routing, held, direction      labels: text that stays for a while
//   anything else                      numbers, which are averaged, or further labels, by the
//                                      first cell that is not empty
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnosis/data/csv.hpp"

namespace reeve::diagnosis {

enum class LogRole : std::uint8_t {
  time,
  position,
  speed,
  motor_tension,
  tension,
  run,
  routing,
  held,
  direction,
  other,
};

struct LogColumn {
  LogRole role = LogRole::other;
  std::string name;
  double scale = 1;  // of its numbers to seconds; of the clock only
};

// In seconds per unit; nothing if it is no name of a clock.
std::optional<double> clock_unit(std::string_view column);

// Parallel to the fields of a row. Throws InputError.
std::vector<LogColumn> read_log_columns(const CsvReader& csv);

}  // namespace reeve::diagnosis
