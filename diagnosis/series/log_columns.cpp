#include "diagnosis/series/log_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "diagnosis/data/intake/column_name.hpp"

namespace reeve::diagnosis {
namespace {

struct KnownLogColumn {
  const char* name;
  LogRole role;
};
constexpr std::array known_log_columns{KnownLogColumn{"position_mm", LogRole::position},
                                       KnownLogColumn{"speed_mm_s", LogRole::speed},
                                       KnownLogColumn{"motor_tension_N", LogRole::motor_tension},
                                       KnownLogColumn{"run", LogRole::run},
                                       KnownLogColumn{"routing", LogRole::routing},
                                       KnownLogColumn{"held", LogRole::held},
                                       KnownLogColumn{"direction", LogRole::direction}};

// T1_N, Ta_N, Th1_N, in no other spelling.
bool names_a_tension(const std::string& name) {
  const auto named = column_named(name);
  return named && named->role == DataRole::tension && !named->place.beside &&
         plain_name(*named) == name;
}

LogColumn log_column(const std::string& name) {
  if (name.empty()) throw InputError({.what = "has no name", .expected = "one"});
  if (const std::optional<double> unit = clock_unit(name)) return {LogRole::time, name, *unit};
  for (const KnownLogColumn& known : known_log_columns) {
    if (name == known.name) return {known.role, name};
  }
  if (name == "readings" || name.ends_with("_sd_N")) {
    throw InputError({.expected = "another name: readings have a column of that name, for what "
                                  "samples are averaged to"});
  }
  return {names_a_tension(name) ? LogRole::tension : LogRole::other, name};
}

void require_once(const std::vector<LogColumn>& columns, LogRole role, const std::string& where,
                  const std::string& what, const std::string& expected) {
  const auto count = std::count_if(columns.begin(), columns.end(),
                                   [&](const LogColumn& column) { return column.role == role; });
  if (count == 1) return;
  throw InputError(
      {.where = where,
       .what = fmt::format("the header has {} {}", count == 0 ? "no" : "more than one", what),
       .expected = expected});
}

// One tension alone can be compared with nothing.
void require_comparable(const std::vector<LogColumn>& columns, const std::string& where) {
  const auto count = [&](LogRole role) {
    return std::count_if(columns.begin(), columns.end(),
                         [&](const LogColumn& column) { return column.role == role; });
  };
  const auto tensions = count(LogRole::tension);
  if (tensions >= 2 || (tensions == 1 && count(LogRole::motor_tension) == 1)) return;
  throw InputError({.where = where,
                    .what = tensions == 0 ? "the header has no column of tensions"
                                          : "the header has one column of tensions",
                    .expected = "motor_tension_N and at least one such as T1_N (strand), Ta_N "
                                "(motor-side segment) or Th1_N (stretch at the hand), or two "
                                "without it"});
}

}  // namespace

std::optional<double> clock_unit(std::string_view column) {
  const auto named = try_column_named(column);
  if (!named || named->role != DataRole::time) return std::nullopt;
  return named->unit ? named->unit->factor : 1;
}

std::vector<LogColumn> read_log_columns(const CsvReader& csv) {
  const std::string where = fmt::format("{}:{}", csv.name(), csv.header().line);
  std::vector<LogColumn> columns;
  std::map<std::string, std::size_t> seen;
  for (const std::string& field : csv.header().fields) {
    const std::string name(trimmed(field));
    const std::size_t number = columns.size() + 1;
    const auto [first, is_new] = seen.emplace(name, number);
    try {
      if (!is_new && !name.empty()) {
        throw InputError(fmt::format("column {} has that name already", first->second));
      }
      columns.push_back(log_column(name));
    } catch (const InputError& error) {
      throw error.at(InputFault{
          .where = where, .what = fmt::format("column {}", number), .value = for_message(name)});
    }
  }
  require_once(columns, LogRole::time, where, "column of time",
               "one of time_s, t_s, t, time, timestamp (seconds), time_ms and t_ms");
  require_comparable(columns, where);
  return columns;
}

}  // namespace reeve::diagnosis
