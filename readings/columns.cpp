#include "readings/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

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

// Returns what the column's name says, or else the meaning that it is given.
std::optional<Unit> unit_of_name(const ColumnName& named, const std::string& name,
                                 const ReadingOptions& options) {
  if (meaning_of(name, options) == name) return named.unit;
  const Dimension dimension = dimension_of(named.role);
  auto in_name = unit_in_brackets(name, dimension);
  if (!in_name) in_name = unit_at_the_end(name, dimension);
  return in_name ? in_name : named.unit;
}

// The two may be one unit, and either may be missing.
void require_one_unit(const std::optional<Unit>& in_name, const std::optional<Unit>& other,
                      const std::string& other_says) {
  if (!in_name || !other || *in_name == *other) return;
  throw InputError({.expected = fmt::format("one unit: the name says {}, and {} {}", in_name->name,
                                            other_says, other->name)});
}

// Returns the unit that the user gives to this column alone.
std::optional<Unit> own_given_unit(const DataColumn& column, const ReadingOptions& options) {
  const Dimension dimension = dimension_of(column.role);
  std::optional<Unit> own;
  for (const ColumnUnit& given : options.units) {
    if (!given.column || !means(*given.column, column)) continue;
    own = find_unit(given.unit, dimension);
    if (own) continue;
    throw InputError(
        {.expected = fmt::format("a unit of {} ({}), and '{}' is given", dimension_name(dimension),
                                 unit_names(dimension), given.unit)});
  }
  return own;
}

// … and to the whole file.
std::optional<Unit> given_unit_of_all(Dimension dimension, const ReadingOptions& options) {
  std::optional<Unit> all;
  for (const ColumnUnit& given : options.units) {
    if (!given.column) all = find_unit(given.unit, dimension);
  }
  return all;
}

// Returns nothing if no unit is given. Throws InputError that says what was expected.
std::optional<Unit> unit_of(const DataColumn& column, const ColumnName& named,
                            const std::optional<Unit>& in_name, const std::optional<CsvRow>& units,
                            std::size_t index, const ReadingOptions& options) {
  const Dimension dimension = dimension_of(named.role);
  if (dimension == Dimension::none) return std::nullopt;
  if (const auto own = own_given_unit(column, options)) return own;
  const auto in_row = unit_in_row(dimension, units, index);
  require_one_unit(in_name, named.unit, "the meaning that it is given");
  if (in_row) require_one_unit(in_name, in_row, fmt::format("line {} says", units->line));
  const auto said = in_name ? in_name : in_row;
  const auto all = given_unit_of_all(dimension, options);
  return all && (said || !named.needs_unit) ? all : said;
}

// Returns the name as it is written in the file, where capitals need not be as in the option.
std::optional<std::string> header_of(const std::string& wanted, const CsvRow& header) {
  std::vector<std::string> alike;
  for (const std::string_view field : header.fields) {
    const std::string name(trimmed(field));
    if (name == wanted) return name;
    if (lower(name) == lower(wanted)) alike.push_back(name);
  }
  return alike.size() == 1 ? std::optional(alike.front()) : std::nullopt;
}

}  // namespace

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

std::string titles_text(const std::vector<CsvComment>& titles) {
  std::string text = titles.size() == 1 ? "a title above the header is not read: "
                                        : "titles above the header are not read: ";
  constexpr std::size_t most = 5;
  const std::size_t told = std::min(titles.size(), most);
  for (std::size_t i = 0; i < told; ++i) {
    text += fmt::format("{}'{}'", i == 0 ? "" : ", ", for_message(titles[i].text));
  }
  if (told < titles.size()) text += fmt::format(" and {} more", titles.size() - told);
  return text;
}

std::optional<std::size_t> find_column(const std::vector<DataColumn>& columns, DataRole role) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].role == role) return i;
  }
  return std::nullopt;
}

bool means(const std::string& text, const DataColumn& column) {
  if (text == column.name) return true;
  const auto other = try_column_named(text);
  return other && other->role == column.role && other->place == column.place;
}

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

Header::Header(const CsvReader& csv, const std::optional<CsvRow>& units,
               const ReadingOptions& options, const FileKind& kind, FaultList& faults)
    : csv_(csv), units_(units), options_(options), kind_(kind), faults_(faults) {
  if (options.group) group_ = header_of(*options.group, csv.header());
  for (std::size_t i = 0; i < csv.header().fields.size(); ++i) add_column(i);
  require_options();
}

void Header::fail(InputFault fault) {
  const std::size_t line = csv_.header().line;
  if (!fault.where) fault.where = fmt::format("{}:{}", csv_.name(), line);
  faults_.add(line, "in the header", std::move(fault));
}

void Header::fail_column(std::size_t column, std::string expected) {
  fail({.what = fmt::format("column {}", column + 1),
        .value = for_message(trimmed(csv_.header().fields[column])),
        .expected = std::move(expected)});
}

void Header::require_one(std::size_t column, std::ptrdiff_t given, const std::string& kind) {
  if (given > 1) fail_column(column, fmt::format("one {}, and {} are given", kind, given));
}

void Header::note_covariate(std::string text) {
  notes_.push_back({NoteKind::covariate, std::move(text), {}});
}

void Header::make_covariate(std::size_t column) {
  const std::string name = columns_[column].name;
  columns_[column] = {DataRole::covariate, name, name};
  read_as_[column].clear();
}

void Header::note_titles() {
  if (csv_.titles().empty()) return;
  DataNote note{NoteKind::passed_over, titles_text(csv_.titles()), {}};
  for (const CsvComment& title : csv_.titles()) note.lines.push_back(title.line);
  notes_.push_back(std::move(note));
}

DataColumns Header::finish() {
  constexpr std::size_t most = 30;
  note_titles();
  std::erase(read_as_, "");
  if (!read_as_.empty()) {
    const std::size_t more = read_as_.size() - std::min(read_as_.size(), most);
    read_as_.resize(read_as_.size() - more);
    notes_.push_back({NoteKind::column_names,
                      fmt::format("columns are read so: {}", fmt::join(read_as_, ", "))});
    if (more > 0) notes_.back().text += fmt::format(", and {} more", more);
  }
  if (units_) {
    notes_.push_back({NoteKind::passed_over,
                      "the row below the header has the columns' units, and no reading",
                      {units_->line}});
  }
  return {std::move(columns_), std::move(notes_)};
}

void Header::add_column(std::size_t index) {
  const std::string name(trimmed(csv_.header().fields[index]));
  DataColumn column{DataRole::no_name, name, name};
  read_as_.emplace_back();
  if (!name.empty()) {
    try {
      column = read(name, index);
    } catch (const InputError& error) {
      fail_column(index, error.fault().expected);
      has_bad_column_ = true;
    }
  }
  if (const auto first = same_as(column)) {
    fail_same(index, *first);
    column.role = DataRole::no_name;
    has_bad_column_ = true;
  }
  columns_.push_back(std::move(column));
}

DataColumn Header::read(const std::string& name, std::size_t index) {
  if (group_ == name && !has_other_meaning(name, index)) return {DataRole::group, name, name};
  require_short_name(name);
  const DataColumn covariate{DataRole::covariate, name, name};
  const std::string& meaning = meaning_of(name, options_);
  const auto named = column_named(meaning);
  if (!named) return covariate;
  if (!kind_.has(named->role)) {
    if (meaning == name) return covariate;
    throw InputError({.expected = fmt::format("a meaning that columns of readings have, and "
                                              "{} is of the log of a rig",
                                              plain_name(*named))});
  }
  DataColumn column{named->role, name, plain_name(*named), kind_.range(named->role), named->place};
  const auto in_name = unit_of_name(*named, name, options_);
  const auto unit = unit_of(column, *named, in_name, units_, index, options_);
  if (named->needs_unit && !unit) return covariate;
  const Dimension dimension = dimension_of(named->role);
  column.unit = unit.value_or(own_unit(dimension));
  column.unit_is_assumed = dimension != Dimension::none && !unit;
  read_as_.back() = told(column, *named, in_name);
  return column;
}

// The runs of a file, or its tensions, cannot be given away.
bool Header::has_other_meaning(const std::string& name, std::size_t index) {
  const auto named = column_named(name);
  if (!named || !kind_.has(named->role) || (named->needs_unit && !named->unit)) return false;
  fail_column(index, fmt::format("a column without another meaning to group rows by, and this "
                                 "is read as {}",
                                 plain_name(*named)));
  return true;
}

std::optional<std::size_t> Header::same_as(const DataColumn& column) const {
  if (column.role == DataRole::no_name) return std::nullopt;
  // A log may have several clocks; one of them is used.
  const bool by_name = column.role == DataRole::covariate || column.role == DataRole::time;
  const auto same = std::find_if(columns_.begin(), columns_.end(), [&](const DataColumn& other) {
    return other.role == column.role &&
           (by_name ? other.name == column.name : other.place == column.place);
  });
  if (same == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(same - columns_.begin());
}

void Header::fail_same(std::size_t index, std::size_t first) {
  const std::string& name = columns_[first].name;
  if (name != trimmed(csv_.header().fields[index])) {
    return fail_column(index, fmt::format("one column of its meaning, and column {} '{}' has it",
                                          first + 1, for_message(name)));
  }
  fail({.what = fmt::format("column {} '{}': column {} has that name already", index + 1,
                            for_message(name), first + 1)});
}

// The user must not think that a missing column had an effect.
void Header::require_options() {
  const auto require_there = [&](const std::string& name, bool is_there, const std::string& what) {
    if (is_there) return;
    fail({.what = "the header has no column", .value = for_message(name), .expected = what});
  };
  const auto is_there = [&](const std::string& name) {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const DataColumn& column) { return column.name == name; });
  };
  for (const auto& [column, meaning] : options_.map) {
    require_there(column, is_there(column),
                  fmt::format("the column that means {}{}", meaning, nearest_column(column)));
  }
  if (options_.group) {
    const std::string& group = group_ ? *group_ : *options_.group;
    require_there(group, is_there(group), "the column of groups" + nearest_column(group));
  }
  for (const ColumnUnit& given : options_.units) {
    if (!given.column) continue;
    const bool is_meant =
        std::any_of(columns_.begin(), columns_.end(),
                    [&](const DataColumn& column) { return means(*given.column, column); });
    require_there(
        *given.column, is_meant,
        fmt::format("the column that is in {}{}", given.unit, nearest_column(*given.column)));
  }
  require_each_once();
}

void Header::require_each_once() {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const DataColumn& column = columns_[i];
    require_one(i, std::ranges::count(options_.map, column.name, &ColumnMeaning::column),
                "meaning");
    require_one(i,
                std::ranges::count_if(options_.units,
                                      [&](const ColumnUnit& unit) {
                                        return unit.column && means(*unit.column, column);
                                      }),
                "unit");
  }
  const auto of_all =
      std::ranges::count_if(options_.units, [](const ColumnUnit& unit) { return !unit.column; });
  if (of_all < 2) return;
  fail({.what = "the unit of all tensions",
        .expected = fmt::format("one unit, and {} are given", of_all)});
}

std::string Header::nearest_column(const std::string& name) const {
  std::vector<std::string> names;
  for (const DataColumn& column : columns_) names.push_back(column.name);
  return did_you_mean(name, names);
}

void Header::take_times_of_day(std::size_t clock) {
  columns_[clock].unit_is_assumed = false;
  read_as_[clock] =
      fmt::format("'{}' as time_s (from times of day)", for_message(columns_[clock].name));
}

// "" if the column is read as docs say.
std::string Header::told(const DataColumn& column, const ColumnName& named,
                         const std::optional<Unit>& in_name) const {
  const bool is_said = !column.unit_is_assumed;
  const bool against_name = is_said && in_name && !(column.unit == *in_name);
  // A clock may be in several units there, but says it.
  const bool in_plain_unit =
      named.role != DataRole::time || named.unit || (is_said && column.unit.is_own());
  if (is_plain(column.name, named) && is_said && in_plain_unit && !against_name) return "";
  std::string text = fmt::format("'{}' as {}", for_message(column.name), column.meaning);
  if (!is_said) text += fmt::format(" (no unit is said: {} is assumed)", column.unit.name);
  if (!column.unit.is_own()) text += fmt::format(" (from {})", column.unit.name);
  if (against_name) text += fmt::format(", though its name says {}", in_name->name);
  return text;
}

}  // namespace reeve::readings
