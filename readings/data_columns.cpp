#include "readings/data_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "readings/guessed_column.hpp"

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

// Guesses the meanings of the covariates that the user has said nothing of.
std::vector<GuessedColumn> guesses(const Header& header, const std::optional<CsvRow>& units,
                                   const ReadingOptions& options) {
  std::vector<GuessedColumn> found;
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const DataColumn& column = header.columns()[i];
    const auto is_of_it = [&](const ColumnMeaning& said) { return said.column == column.name; };
    found.emplace_back();
    if (column.role != DataRole::covariate || std::ranges::any_of(options.map, is_of_it)) continue;
    found.back() = guess_column(column.name, unit_of_column(column.name, units, i));
  }
  return found;
}

// Read as a covariate, a column of one of these roles would make all rows mean something else.
bool matters(const ColumnName& meaning, const GuessedColumn& guess) {
  switch (meaning.role) {
    case DataRole::held:
    case DataRole::direction:
      return true;
    case DataRole::tension:
    case DataRole::motor_tension:
      return words_of(guess.name).bracketed.has_value();
    default:
      return false;
  }
}

bool has(const Header& header, const ColumnName& meaning) {
  return std::ranges::any_of(header.columns(), [&](const DataColumn& column) {
    return column.role == meaning.role && column.place == meaning.place;
  });
}

void require_said(Header& header, const std::vector<GuessedColumn>& guesses,
                  const std::string& map_option) {
  if (map_option.empty()) return;
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    const auto meaning = try_column_named(guesses[i].meaning);
    if (!meaning || !matters(*meaning, guesses[i]) || has(header, *meaning)) continue;
    const std::string name = for_message(guesses[i].name);
    header.fail_column(i, fmt::format("its meaning, which may be {1}: {0} '{2}={1}', or {0} "
                                      "'{2}={2}' if it is none",
                                      map_option, guesses[i].meaning, name));
  }
}

void require_columns(Header& header, const std::vector<GuessedColumn>& guesses,
                     const std::string& map_option) {
  const auto named = [&](const char* meaning) -> std::string {
    if (map_option.empty()) return "";
    const auto guess = std::ranges::find(guesses, meaning, &GuessedColumn::meaning);
    return fmt::format("; name it with {} '{}={}'", map_option,
                       guess == guesses.end() ? "COLUMN" : for_message(guess->name), meaning);
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
  const std::vector<GuessedColumn> guessed = guesses(header, units, options);
  require_columns(header, guessed, options.map_option);
  require_said(header, guessed, options.map_option);
  require_tensions_of_deviations(header);
  return header.finish();
}

bool is_noise_of(const ColumnNoise& given, const DataColumn& column) {
  if (!is_of_sensor(column.role)) return false;
  if (column.role == DataRole::motor_tension && given.column == "motor") return true;
  return means(given.column, column);
}

}  // namespace reeve::readings
