#include "readings/data_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "readings/column_units.hpp"
#include "readings/header_columns.hpp"
#include "readings/log/recognise_series.hpp"

namespace reeve::readings {
namespace {

using Columns = std::vector<DataColumn>;

// The greatest numbers are far above any rig: they catch a slipped decimal mark, and keep sums of
// squares finite. An angle of 100 rad is sixteen turns of a sheath; more is likely in degrees.
CellRange range_of(DataRole role) {
  switch (role) {
    case DataRole::motor_tension:
    case DataRole::tension:
      return {-1e9, 1e9};
    case DataRole::deviation:
    case DataRole::motor_deviation:
    case DataRole::speed:
      return {0, 1e9};
    case DataRole::cycle:
      return {0, 1e15};
    case DataRole::readings:
      return {1, 1e15};
    case DataRole::temperature:
      return {-273.15, 1e4};
    case DataRole::sheath_angle:
      return {0, 100};
    default:
      return {};
  }
}

// When and where the carriage was is a covariate of a reading.
bool is_of_readings(DataRole role) { return role != DataRole::time && role != DataRole::position; }

constexpr FileKind file_of_readings{is_of_readings, range_of};

// Nobody may think that something was done with what the file does not have.
void require_noise(const Columns& columns, const ReadingOptions& options, HeaderFaults& faults) {
  for (const ColumnNoise& given : options.noise) {
    const bool is_there =
        std::any_of(columns.begin(), columns.end(),
                    [&](const DataColumn& column) { return is_noise_of(given, column); });
    if (is_there) continue;
    faults.add({.what = "the header has no column of tensions",
                .value = for_message(given.column),
                .expected = "the column whose noise is given"});
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto given =
        std::count_if(options.noise.begin(), options.noise.end(),
                      [&](const ColumnNoise& noise) { return is_noise_of(noise, columns[i]); });
    if (given > 1) faults.add_column(i, fmt::format("one noise, and {} are given", given));
  }
}

void require(const Columns& columns, DataRole role, const std::string& column,
             const std::string& expected, HeaderFaults& faults) {
  if (find_column(columns, role)) return;
  faults.add({.what = "the header has no column " + column, .expected = expected});
}

void require_columns(const HeaderColumns& header, HeaderFaults& faults) {
  require(header.columns, DataRole::run, "'run'", "a name or number for each run", faults);
  require(header.columns, DataRole::routing, "'routing'", "a routing in each row", faults);
  // It may be the one that cannot be read.
  if (header.has_bad_column) return;
  require(header.columns, DataRole::tension, "of tensions",
          "at least one such as T1_N (strand), Ta_N (motor-side segment) or Th1_N (stretch at "
          "the hand)",
          faults);
}

void require_tensions_of_deviations(const Columns& columns, HeaderFaults& faults) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const DataColumn& column = columns[i];
    if (column.role == DataRole::motor_deviation &&
        !find_column(columns, DataRole::motor_tension)) {
      faults.add_column(i, "the column motor_tension_N beside it");
    }
    if (column.role != DataRole::deviation) continue;
    const bool has_tension =
        std::any_of(columns.begin(), columns.end(), [&](const DataColumn& other) {
          return other.role == DataRole::tension && other.place == column.place;
        });
    if (has_tension) continue;
    faults.add_column(i, fmt::format("the column {} beside it",
                                     plain_name({DataRole::tension, column.place, {}, false})));
  }
}

}  // namespace

DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults) {
  HeaderFaults at_header(csv, faults);
  HeaderColumns header = read_header(csv, units, options, file_of_readings, at_header);
  require_noise(header.columns, options, at_header);
  require_no_log(csv, header.columns);
  require_columns(header, at_header);
  require_tensions_of_deviations(header.columns, at_header);
  return {std::move(header.columns), header_notes(header, units)};
}

bool is_noise_of(const ColumnNoise& given, const DataColumn& column) {
  if (!is_of_sensor(column.role)) return false;
  if (column.role == DataRole::motor_tension && given.column == "motor") return true;
  return means(given.column, column.name, column.role, column.place);
}

std::optional<std::size_t> find_column(const std::vector<DataColumn>& columns, DataRole role) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].role == role) return i;
  }
  return std::nullopt;
}

}  // namespace reeve::readings
