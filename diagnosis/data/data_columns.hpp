// What the header of a file of measured tensions says: which column holds what.
//
//   run, routing                 required
//   held, direction              the grasp and which way the carriage moves
//   motor_tension_N, speed_mm_s, cycle, temperature_C, sheath_angle_rad
//   T1_N, T2_N, …                tensions of strands; Ta_N, Tb_N, … of motor-side segments;
//                                Th1_N, … of stretches at the hand; at least one is required
//   anything else                a covariate, which the model does not know
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/network.hpp"
#include "diagnosis/data/csv.hpp"

namespace reeve::diagnosis {

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
};

struct DataColumn {
  DataRole role = DataRole::covariate;
  std::string name;
  double low = 0;  // range of its numbers; not of text
  double high = 0;
  Segment segment;  // tensions only
};

// Parallel to the fields of a row. Throws InputError.
std::vector<DataColumn> read_columns(const CsvReader& csv);

std::optional<std::size_t> find_column(const std::vector<DataColumn>& columns, DataRole role);

}  // namespace reeve::diagnosis
