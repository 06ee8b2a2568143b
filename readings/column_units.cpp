#include "readings/column_units.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/csv_number.hpp"
#include "readings/words.hpp"

namespace reeve::readings {
namespace {

bool is_number(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  return text.find_first_of(digits) == 0 ||
         (text.size() > 1 && text.find_first_of(digits, 1) == 1 &&
          (text[0] == '-' || text[0] == '+' || text[0] == '.' || text[0] == ','));
}

std::optional<Unit> unit_in_row(Dimension dimension, const std::optional<CsvRow>& units,
                                std::size_t index) {
  if (!units || is_missing(without_brackets(units->fields[index]))) return std::nullopt;
  const auto unit = find_unit(units->fields[index], dimension);
  if (unit) return unit;
  throw InputError({.expected = fmt::format("a unit of {} ({}), and line {} says '{}'",
                                            dimension_name(dimension), unit_names(dimension),
                                            units->line, for_message(units->fields[index]))});
}

std::optional<Unit> unit_in_brackets(std::string_view name, Dimension dimension) {
  for (std::size_t open = name.find_first_of("[("); open != std::string_view::npos;
       open = name.find_first_of("[(", open + 1)) {
    const std::size_t close = name.find(name[open] == '[' ? ']' : ')', open);
    if (close == std::string_view::npos) continue;
    if (auto unit = find_unit(name.substr(open, close - open + 1), dimension)) return unit;
  }
  return std::nullopt;
}

// A letter alone is a unit only as units are written, and "in" may be another word.
bool may_be_unit(std::string_view word) {
  constexpr std::string_view letters = "NgmsCFK";
  return word.size() == 1 ? letters.find(word) != std::string_view::npos : lower(word) != "in";
}

// "Kraft Motor kgf", "v_mm_s", "Kraft/kgf"; a unit alone is a name.
std::optional<Unit> unit_at_the_end(std::string_view name, Dimension dimension) {
  constexpr std::string_view parting = " _-.\t";
  const std::size_t slash = name.find('/');
  if (slash != std::string_view::npos && slash > 0) {
    if (auto unit = find_unit(name.substr(slash + 1), dimension)) return unit;
  }
  const std::size_t blank = name.find_last_of(parting);
  if (blank == std::string_view::npos || blank == 0) return std::nullopt;
  const std::string last(name.substr(blank + 1));
  const std::size_t before = name.find_last_of(parting, blank - 1);
  if (before != std::string_view::npos) {
    const std::string_view first = name.substr(before + 1, blank - before - 1);
    if (auto unit = find_unit(std::string(first) + "/" + last, dimension)) return unit;
  }
  return may_be_unit(last) ? find_unit(last, dimension) : std::nullopt;
}

// Of a name that is reeve's only by what it is said to mean.
std::optional<Unit> unit_in_foreign_name(std::string_view name, Dimension dimension) {
  const auto unit = unit_in_brackets(name, dimension);
  return unit ? unit : unit_at_the_end(name, dimension);
}

// The two may name one unit, and either may name none.
void require_one_unit(const std::optional<Unit>& in_name, const std::optional<Unit>& in_meaning) {
  if (!in_name || !in_meaning || *in_name == *in_meaning) return;
  throw InputError(
      {.expected = fmt::format("one unit: the name says {}, and the meaning that it is given {}",
                               in_name->name, in_meaning->name)});
}

struct GivenUnits {
  std::optional<Unit> all;  // of the whole file
  std::optional<Unit> own;  // of this column
};

GivenUnits given_units(const ColumnName& named, const std::string& name, Dimension dimension,
                       const ReadingOptions& options) {
  GivenUnits result;
  for (const ColumnUnit& given : options.units) {
    if (!given.column) {
      result.all = find_unit(given.unit, dimension);
    } else if (means(*given.column, name, named.role, named.place)) {
      result.own = find_unit(given.unit, dimension);
      if (result.own) continue;
      throw InputError(
          {.expected = fmt::format("a unit of {} ({}), and '{}' is given",
                                   dimension_name(dimension), unit_names(dimension), given.unit)});
    }
  }
  return result;
}

}  // namespace

const std::string& meaning_of(const std::string& name, const ReadingOptions& options) {
  for (const ColumnMeaning& mapped : options.map) {
    if (mapped.column == name) return mapped.meaning;
  }
  return name;
}

bool is_units_row(const CsvRow& header, const CsvRow& row, const ReadingOptions& options) {
  bool has_unit = false;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const std::string_view cell = without_brackets(row.fields[i]);
    if (is_number(cell)) return false;
    const auto named =
        try_column_named(meaning_of(std::string(trimmed(header.fields[i])), options));
    if (!named) continue;
    const std::string small = lower(cell);
    const bool is_text = small == "text" || small == "string";
    if (named->role == DataRole::routing && !is_missing(cell) && !is_text) return false;
    has_unit = has_unit || find_unit(cell, dimension_of(named->role)).has_value();
  }
  return has_unit;
}

bool means(const std::string& text, const std::string& name, DataRole role,
           const MeasuredPlace& place) {
  if (text == name) return true;
  const auto other = try_column_named(text);
  return other && other->role == role && other->place == place;
}

std::optional<Unit> unit_of_name(const ColumnName& named, const std::string& name,
                                 const ReadingOptions& options) {
  if (meaning_of(name, options) == name) return named.unit;
  const auto in_name = unit_in_foreign_name(name, dimension_of(named.role));
  return in_name ? in_name : named.unit;
}

std::optional<Unit> unit_of(const ColumnName& named, const std::string& name,
                            const std::optional<CsvRow>& units, std::size_t index,
                            const ReadingOptions& options) {
  const Dimension dimension = dimension_of(named.role);
  if (dimension == Dimension::none) return std::nullopt;
  const GivenUnits given = given_units(named, name, dimension, options);
  if (given.own) return given.own;
  const auto in_row = unit_in_row(dimension, units, index);
  const auto in_name = unit_of_name(named, name, options);
  require_one_unit(in_name, named.unit);
  if (in_row && in_name && !(*in_row == *in_name)) {
    throw InputError({.expected = fmt::format("one unit: the name says {}, and line {} says {}",
                                              in_name->name, units->line, in_row->name)});
  }
  const auto said = in_name ? in_name : in_row;
  return given.all && (said || !named.needs_unit) ? given.all : said;
}

}  // namespace reeve::readings
