#include "readings/data_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "readings/rows.hpp"

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

// Read as a covariate, a column of one of these roles would make all rows mean something else.
bool matters(const ColumnName& meaning, const GuessedColumn& guess) {
  switch (meaning.role) {
    case DataRole::held:
    case DataRole::direction:
      return true;
    case DataRole::motor_tension:
      return guess.has_unit;
    case DataRole::tension:
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

// True if the cells of that column, below the row that was read last, are finger numbers or say
// none. Greater numbers are no fingers of a hand.
bool has_fingers(CsvReader rows, std::size_t column) {
  constexpr int most_fingers = 9;
  bool any = false;
  try {
    for (CsvRow row; rows.next(row);) {
      any |= read_held(trimmed(row.fields[column]), most_fingers) != Grasp{};
    }
  } catch (const InputError&) {
    return false;
  }
  return any;
}

void require_units_of_force(Header& header, const ReadingOptions& options) {
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const DataColumn& column = header.columns()[i];
    if (column.role != DataRole::covariate || is_said(column.name, options)) continue;
    const auto found = tension_in_no_unit_of_force(column.name);
    if (found && !has(header, found->meant)) fail_no_force(header, i, found->unit, options);
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

bool is_said(const std::string& column, const ReadingOptions& options) {
  return std::ranges::find(options.map, column, &ColumnMeaning::column) != options.map.end();
}

std::vector<GuessedColumn> guess_covariates(const Header& header,
                                            const std::optional<CsvRow>& units,
                                            const ReadingOptions& options) {
  std::vector<GuessedColumn> found;
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const DataColumn& column = header.columns()[i];
    found.emplace_back();
    if (column.role != DataRole::covariate || is_said(column.name, options)) continue;
    found.back() = guess_column(column.name, unit_of_column(column.name, units, i));
  }
  return found;
}

void require_said(Header& header, const CsvReader& csv, std::vector<GuessedColumn> guesses,
                  const ReadingOptions& options, bool (*is_asked)(DataRole)) {
  if (options.map_option.empty()) return;
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    GuessedColumn& guess = guesses[i];
    if (guess.may_be_held && !header.has(DataRole::held) && has_fingers(csv, i)) {
      guess.meaning = "held";
    }
    const auto meaning = try_column_named(guess.meaning);
    if (!meaning || !is_asked(meaning->role)) continue;
    if (!matters(*meaning, guess) || has(header, *meaning)) continue;
    const std::string name = for_message(guess.name);
    header.fail_column(i, fmt::format("its meaning, which may be {1}: {0} '{2}={1}', or {0} "
                                      "'{2}={2}' if it is none",
                                      options.map_option, guess.meaning, name));
  }
}

void fail_no_force(Header& header, std::size_t column, const std::string& unit,
                   const ReadingOptions& options) {
  const std::string name = for_message(header.columns()[column].name);
  std::string expected = fmt::format("a unit of force ({})", unit_names(Dimension::force));
  expected += options.map_option.empty() ? std::string(", or another name if it is no tension")
                                         : fmt::format(", or {} '{}={}' if it is no tension",
                                                       options.map_option, name, name);
  const std::string reason = guess_column(header.columns()[column].name, unit).reason;
  if (!reason.empty()) expected += "; " + reason;
  header.fail({.what = fmt::format("column {} '{}': the unit {} is no force", column + 1, name,
                                   for_message(unit)),
               .expected = std::move(expected)});
}

DataColumns read_columns(const CsvReader& csv, const std::optional<CsvRow>& units,
                         const ReadingOptions& options, FaultList& faults) {
  Header header(csv, units, options, file_of_readings, faults);
  require_noise(header, options);
  require_no_log(csv, header.columns());
  const std::vector<GuessedColumn> guessed = guess_covariates(header, units, options);
  require_columns(header, guessed, options.map_option);
  require_said(header, csv, guessed, options, [](DataRole) { return true; });
  require_units_of_force(header, options);
  require_tensions_of_deviations(header);
  return header.finish();
}

bool is_noise_of(const ColumnNoise& given, const DataColumn& column) {
  if (!is_of_sensor(column.role)) return false;
  if (column.role == DataRole::motor_tension && given.column == "motor") return true;
  return means(given.column, column);
}

}  // namespace reeve::readings
