#include "readings/log/guessed_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "readings/columns.hpp"
#include "readings/csv.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t shown_rows = 5;

// A row of units below names that are still unknown.
bool has_units_alone(const CsvRow& row) {
  bool any = false;
  for (const std::string& field : row.fields) {
    const std::string_view cell = without_brackets(field);
    if (cell.find_first_of("0123456789+-") == 0) return false;
    any = any || is_unit(cell);
  }
  return any;
}

// Returns nothing for a column that reeve takes for a covariate.
std::optional<std::string> known_meaning(const std::string& name, const std::string& unit,
                                         const ReadingOptions& options) {
  const auto named = try_column_named(meaning_of(name, options));
  if (!named || (named->needs_unit && !named->unit && !find_unit(unit, Dimension::force))) {
    return std::nullopt;
  }
  return plain_name(*named);
}

// Returns the meaning without its unit: "motor_tension" of "motor_tension_N", which "motor_tension"
// means too.
std::string without_unit(const std::string& meaning) {
  for (const std::string_view unit : {"_mm_s", "_mm", "_N", "_s", "_C", "_rad"}) {
    if (meaning.ends_with(unit)) return meaning.substr(0, meaning.size() - unit.size());
  }
  return meaning;
}

GuessedColumn column_of(const std::string& name, const std::string& unit,
                        const ReadingOptions& options) {
  if (const auto known = known_meaning(name, unit, options)) {
    return {name, without_unit(*known), GuessKind::known, ""};
  }
  return guess_column(name, unit);
}

// Two columns of one meaning: one that is known goes before a guess, the first before the others.
void part_equals(std::vector<GuessedColumn>& columns) {
  for (GuessedColumn& column : columns) {
    if (column.kind != GuessKind::guessed) continue;
    for (const GuessedColumn& other : columns) {
      const bool goes_before = other.kind == GuessKind::known || &other < &column;
      if (&other == &column || other.meaning != column.meaning || !goes_before) continue;
      column = {
          column.name, "", GuessKind::unknown,
          fmt::format("it would be {}, and so is '{}'", column.meaning, for_message(other.name))};
      break;
    }
  }
}

}  // namespace

bool LogGuess::has(const std::string& meaning) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const GuessedColumn& column) { return column.meaning == meaning; });
}

LogGuess guess_columns(const std::filesystem::path& path, const ReadingOptions& options) {
  CsvReader csv = CsvReader::open(path);
  LogGuess result;
  result.separator = csv.separator();
  result.titles = csv.titles();
  FaultList faults;
  Beginning beginning = read_beginning(csv, options, faults);
  if (beginning.first && has_units_alone(*beginning.first)) {
    beginning.units = std::exchange(beginning.first, std::nullopt);
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < csv.header().fields.size(); ++i) {
    const std::string name(trimmed(csv.header().fields[i]));
    if (name.empty()) continue;
    places.push_back(i);
    result.columns.push_back(column_of(name, unit_of_column(name, beginning.units, i), options));
  }
  part_equals(result.columns);
  result.map = options.map;
  for (const GuessedColumn& column : result.columns) {
    if (column.kind == GuessKind::guessed) result.map.push_back({column.name, column.meaning});
  }
  CsvRow row;
  const auto keep = [&](const CsvRow& shown) {
    result.first_rows.emplace_back();
    for (const std::size_t place : places) result.first_rows.back().push_back(shown.fields[place]);
  };
  if (beginning.first) keep(*beginning.first);
  while (!beginning.is_broken && result.first_rows.size() < shown_rows && csv.next(row)) keep(row);
  return result;
}

}  // namespace reeve::readings
