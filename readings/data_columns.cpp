#include "readings/data_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace reeve::readings {
namespace {

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

// The time and the position of the carriage are covariates of a reading.
bool is_of_readings(DataRole role) { return role != DataRole::time && role != DataRole::position; }

constexpr FileKind file_of_readings{is_of_readings, range_of};

// The user must not think that a missing column had an effect.
void require_noise(Header& header, const ReadingOptions& options) {
  const ColumnList& columns = header.columns();
  for (const ColumnNoise& given : options.noise) {
    const bool is_there =
        std::any_of(columns.begin(), columns.end(),
                    [&](const DataColumn& column) { return is_noise_of(given, column); });
    if (is_there) continue;
    header.fail({.what = "the header has no column of tensions",
                 .value = for_message(given.column),
                 .expected = "the column whose noise is given"});
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto is_meant = [&](const ColumnNoise& noise) { return is_noise_of(noise, columns[i]); };
    header.require_one(i, std::ranges::count_if(options.noise, is_meant), "noise");
  }
}

// A header that has a clock and neither run nor routing is a logger's.
void require_no_log(const CsvReader& csv, const ColumnList& columns) {
  if (find_column(columns, DataRole::run) || find_column(columns, DataRole::routing)) return;
  for (const DataColumn& column : columns) {
    if (!clock_unit(column.name)) continue;
    throw InputError(
        {.where = fmt::format("{}:{}", csv.name(), csv.header().line),
         .what = fmt::format("the header has a clock ('{}'), and neither 'run' nor 'routing'",
                             column.name),
         .expected = "steady readings; of a logger's time series, reeve import makes them"});
  }
}

void require(Header& header, DataRole role, const std::string& column,
             const std::string& expected) {
  if (header.has(role)) return;
  header.fail({.what = "the header has no column " + column, .expected = expected});
}

void require_columns(Header& header, const std::string& map_option) {
  const auto named = [&](const char* meaning) {
    return map_option.empty() ? ""
                              : fmt::format("; name it with {} 'COLUMN={}'", map_option, meaning);
  };
  require(header, DataRole::run, "'run'", "a name or number for each run" + named("run"));
  require(header, DataRole::routing, "'routing'", "a routing in each row" + named("routing"));
  if (header.has_bad_column()) return;
  require(header, DataRole::tension, "of tensions",
          "at least one such as T1_N (strand), Ta_N (motor-side segment) or Th1_N (stretch at "
          "the hand)");
}

void require_tensions_of_deviations(Header& header) {
  const ColumnList& columns = header.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const DataColumn& column = columns[i];
    if (column.role == DataRole::motor_deviation && !header.has(DataRole::motor_tension)) {
      header.fail_column(i, "the column motor_tension_N beside it");
    }
    if (column.role != DataRole::deviation) continue;
    const bool has_tension =
        std::any_of(columns.begin(), columns.end(), [&](const DataColumn& other) {
          return other.role == DataRole::tension && other.place == column.place;
        });
    if (has_tension) continue;
    header.fail_column(i, fmt::format("the column {} beside it",
                                      plain_name({DataRole::tension, column.place, {}, false})));
  }
}

}  // namespace

DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults) {
  Header header(csv, units, options, file_of_readings, faults);
  require_noise(header, options);
  require_no_log(csv, header.columns());
  require_columns(header, options.map_option);
  require_tensions_of_deviations(header);
  return header.finish();
}

bool is_noise_of(const ColumnNoise& given, const DataColumn& column) {
  if (!is_of_sensor(column.role)) return false;
  if (column.role == DataRole::motor_tension && given.column == "motor") return true;
  return means(given.column, column);
}

}  // namespace reeve::readings
