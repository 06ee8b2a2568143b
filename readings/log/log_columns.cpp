#include "readings/log/log_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "readings/data_columns.hpp"

namespace reeve::readings {
namespace {

// Far above any rig, and squares of them stay numbers; of a clock, a date in microseconds.
CellRange range_in_log(DataRole role) {
  switch (role) {
    case DataRole::time:
      return {-1e15, 1e15};
    case DataRole::motor_tension:
    case DataRole::tension:
    case DataRole::position:
    case DataRole::speed:
      return {-1e9, 1e9};
    default:
      return {};
  }
}

constexpr FileKind log_of_a_rig{[](DataRole) { return true; }, range_in_log};

// True for the roles of averaged rows, which samples do not have.
bool is_of_means(DataRole role) {
  return role == DataRole::readings || role == DataRole::deviation ||
         role == DataRole::motor_deviation;
}

// True if samples need it for more than an average or a cut where it changes.
bool is_used(const DataColumn& column) {
  switch (column.role) {
    case DataRole::tension:
      return !column.place.beside;  // its segment is a matter of the routing
    case DataRole::cycle:
    case DataRole::temperature:
    case DataRole::sheath_angle:
      return false;
    default:
      return true;
  }
}

// Rank of a clock, greatest first: named by the user, named as in the docs, other names with a
// unit, other names.
int rank_of_clock(const DataColumn& column) {
  const auto named = try_column_named(column.name);
  if (!named || named->role != DataRole::time) return 3;
  if (is_plain(column.name, *named)) return 2;
  return named->unit ? 1 : 0;
}

constexpr const char* clock_names =
    "one of time_s, t_s, t, time, timestamp (seconds), time_ms and t_ms";

std::string names_of(const ColumnList& columns) {
  constexpr std::size_t most = 10;
  std::string list;
  std::size_t count = 0;
  for (const DataColumn& column : columns) {
    if (column.name.empty() || ++count > most) continue;
    list += fmt::format("{}'{}'", list.empty() ? "" : ", ", for_message(column.name));
  }
  if (count > most) list += fmt::format(", and {} more", count - most);
  return list;
}

// Returns the advice that leads from a column which is there under another name to its meaning.
std::string way_to_meaning(const ReadingOptions& options, const std::string& meaning) {
  std::string text;
  if (!options.map_option.empty()) {
    text = fmt::format("; name it with {} 'COLUMN={}'", options.map_option, meaning);
  }
  if (!options.guess_option.empty()) {
    text += fmt::format("; {} proposes a meaning for each column", options.guess_option);
  }
  return text;
}

std::string clock_or_its_name(const ColumnList& columns, const ReadingOptions& options) {
  const std::string names = names_of(columns);
  if (options.map_option.empty() || names.empty()) return clock_names;
  return fmt::format("{}; it has {}{}", clock_names, names, way_to_meaning(options, "time_s"));
}

void choose_clock(Header& header, const std::optional<CsvRow>& first,
                  const ReadingOptions& options) {
  const ColumnList& columns = header.columns();
  int highest = 0;
  for (const DataColumn& column : columns) {
    if (column.role == DataRole::time) highest = std::max(highest, rank_of_clock(column));
  }
  std::size_t clocks = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].role != DataRole::time) continue;
    if (rank_of_clock(columns[i]) < highest) {
      header.make_covariate(i);
    } else {
      ++clocks;
      if (first && !first->ragged && wall_time(trimmed(first->fields[i])))
        header.take_times_of_day(i);
    }
  }
  if (clocks == 1) return;
  header.fail({.what = fmt::format("the header has {} column of time",
                                   clocks == 0 ? "no" : "more than one"),
               .expected = clocks == 0 ? clock_or_its_name(columns, options) : clock_names});
}

void refuse_columns_of_means(Header& header) {
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    if (!is_of_means(header.columns()[i].role)) continue;
    header.fail_column(i,
                       "another name: readings have a column of that name, for what "
                       "samples are averaged to");
    header.set_role(i, DataRole::no_name);
  }
}

// One tension alone can be compared with nothing.
void require_comparable(Header& header, const ReadingOptions& options) {
  if (header.has_bad_column()) return;
  const ColumnList& columns = header.columns();
  const auto tensions = std::count_if(columns.begin(), columns.end(), [](const DataColumn& column) {
    return column.role == DataRole::tension;
  });
  if (tensions >= 2 || (tensions == 1 && header.has(DataRole::motor_tension))) return;
  header.fail({.what = tensions == 0 ? "the header has no column of tensions"
                                     : "the header has one column of tensions",
               .expected = "motor_tension_N and at least one such as T1_N (strand), Ta_N "
                           "(motor-side segment) or Th1_N (stretch at the hand), or two "
                           "without it" +
                           way_to_meaning(options, "T1_N")});
}

void require_routing(Header& header, const ReadingOptions& options) {
  if (options.routing_option.empty() || header.has(DataRole::routing)) return;
  header.fail({.what = "the header has no column 'routing'",
               .expected = fmt::format("a routing such as M-1-T-2-F in each row, or given by {}",
                                       options.routing_option)});
}

constexpr std::array words_of_motion{"position", "pos",          "speed", "velocity",
                                     "vel",      "displacement", "travel"};

// True if the name has such a word: "position_rev", "Carriage speed".
bool says_motion(std::string_view name) {
  const NameWords words = words_of(name);
  return std::any_of(words.words.begin(), words.words.end(), [](const std::string& word) {
    return std::find(words_of_motion.begin(), words_of_motion.end(), word) != words_of_motion.end();
  });
}

// True of "x_mm", "Weg [mm]".
bool has_unit_of_motion(std::string_view name) {
  const auto is_speed = [](const std::string& text) {
    return find_unit(text, Dimension::speed).has_value();
  };
  const NameWords words = words_of(name);
  if (words.bracketed) {
    return is_speed(*words.bracketed) || find_unit(*words.bracketed, Dimension::length);
  }
  const std::size_t count = words.words.size();
  if (count < 2) return false;
  const std::string& last = words.words[count - 1];
  // A lone m or in may be another word.
  const bool is_length = last == "mm" || last == "cm";
  return is_length || (count > 2 && is_speed(words.words[count - 2] + "/" + last));
}

// Without a motion other samples are steady than with one, so that none may be missed.
void require_no_missed_motion(Header& header) {
  if (header.has(DataRole::position) || header.has(DataRole::speed)) return;
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const DataColumn& column = header.columns()[i];
    if (column.role != DataRole::covariate) continue;
    if (says_motion(column.name)) {
      header.fail_column(
          i, fmt::format("the carriage's position with a unit of length ({}), its speed with one "
                         "of speed ({}), or another name if it is neither",
                         unit_names(Dimension::length), unit_names(Dimension::speed)));
    } else if (has_unit_of_motion(column.name)) {
      header.note_covariate(
          fmt::format("column '{}' is in a unit of length or speed: it is not read as the "
                      "carriage's position or speed, which are position_mm and speed_mm_s",
                      for_message(column.name)));
    }
  }
}

// Without the motor tension other samples are steady than with it, and what is left are shares. Of
// another tension it is enough to say that readings will not have it.
void require_no_missed_tension(Header& header, const ReadingOptions& options) {
  const std::string units = unit_names(Dimension::force);
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    const DataColumn& column = header.columns()[i];
    if (column.role != DataRole::covariate || is_said(column.name, options)) continue;
    const auto meant = tension_in_no_unit_of_force(column.name);
    if (!meant) continue;
    if (meant->meant.role == DataRole::motor_tension && !header.has(DataRole::motor_tension)) {
      fail_no_force(header, i, meant->unit, options);
      continue;
    }
    header.note_covariate(
        fmt::format("column '{}' has the name of a tension and no unit of force ({}): it is "
                    "averaged as it is, and readings do not have it as {}",
                    for_message(column.name), units, plain_name(meant->meant)));
  }
}

}  // namespace

DataColumns read_log_columns(const CsvReader& csv, const Beginning& beginning,
                             const ReadingOptions& options, FaultList& faults) {
  const std::optional<CsvRow>& units = beginning.units;
  Header header(csv, units, options, log_of_a_rig, faults);
  choose_clock(header, beginning.first, options);
  refuse_columns_of_means(header);
  for (std::size_t i = 0; i < header.columns().size(); ++i) {
    if (!is_used(header.columns()[i])) header.set_role(i, DataRole::covariate);
  }
  require_comparable(header, options);
  require_routing(header, options);
  require_no_missed_motion(header);
  require_no_missed_tension(header, options);
  require_said(header, csv, guess_covariates(header, units, options), options, [](DataRole role) {
    return role == DataRole::motor_tension || role == DataRole::held;
  });
  return header.finish();
}

}  // namespace reeve::readings
