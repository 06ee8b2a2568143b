#include "readings/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/recognise_series.hpp"

namespace reeve::readings {

void HeaderFaults::add(InputFault fault) {
  const std::size_t line = csv_.header().line;
  if (!fault.where) fault.where = fmt::format("{}:{}", csv_.name(), line);
  faults_.add(line, "in the header", std::move(fault));
}

void HeaderFaults::add_column(std::size_t column, std::string expected) {
  add({.what = fmt::format("column {}", column + 1),
       .value = for_message(std::string(trimmed(csv_.header().fields[column]))),
       .expected = std::move(expected)});
}

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

namespace {

class HeaderReader {
 public:
  HeaderReader(const CsvReader& csv, const std::optional<CsvRow>& units,
               const ReadingOptions& options, const FileKind& kind, HeaderFaults& faults)
      : csv_(csv),
        units_(units),
        options_(options),
        kind_(kind),
        faults_(faults),
        group_(options.group ? header_of(*options.group) : std::nullopt) {}

  HeaderColumns read() {
    for (std::size_t i = 0; i < csv_.header().fields.size(); ++i) add_column(i);
    require_options();
    return std::move(result_);
  }

 private:
  // As it is written in the file, where capitals need not be as in the option.
  std::optional<std::string> header_of(const std::string& wanted) const {
    std::vector<std::string> alike;
    for (const std::string_view field : csv_.header().fields) {
      const std::string name(trimmed(field));
      if (name == wanted) return name;
      if (lower(name) == lower(wanted)) alike.push_back(name);
    }
    return alike.size() == 1 ? std::optional(alike.front()) : std::nullopt;
  }

  void add_column(std::size_t index) {
    const std::string name(trimmed(csv_.header().fields[index]));
    DataColumn column{DataRole::no_name, name, 0, 0, {}, {}, name};
    result_.read_as.emplace_back();
    if (!name.empty()) {
      try {
        column = read(name, index);
      } catch (const InputError& error) {
        faults_.add_column(index, error.fault().expected);
        result_.has_bad_column = true;
      }
    }
    if (const auto first = same_as(column)) {
      fail_same(index, *first);
      column.role = DataRole::no_name;
      result_.has_bad_column = true;
    }
    result_.columns.push_back(std::move(column));
  }

  DataColumn read(const std::string& name, std::size_t index) {
    if (group_ == name && !has_other_meaning(name, index)) {
      return {DataRole::group, name, 0, 0, {}, {}, name};
    }
    require_short_name(name);
    const CellRange any = kind_.range(DataRole::covariate);
    DataColumn covariate{DataRole::covariate, name, any.low, any.high, {}, {}, name};
    const std::string& meaning = meaning_of(name, options_);
    const auto named = column_named(meaning);
    if (!named) return covariate;
    if (!kind_.has(named->role)) {
      if (meaning == name) return covariate;
      throw InputError({.expected = fmt::format("a meaning that columns of readings have, and "
                                                "{} is of the log of a rig",
                                                plain_name(*named))});
    }
    const std::optional<Unit> unit = unit_of(*named, name, units_, index, options_);
    if (named->needs_unit && !unit) return covariate;
    const CellRange range = kind_.range(named->role);
    DataColumn column{named->role,  name, range.low,         range.high,
                      named->place, {},   plain_name(*named)};
    column.unit = unit.value_or(own_unit(dimension_of(named->role)));
    column.unit_is_assumed = dimension_of(named->role) != Dimension::none && !unit;
    note_name(*named, name, unit);
    return column;
  }

  // The runs of a file, or its tensions, cannot be given away.
  bool has_other_meaning(const std::string& name, std::size_t index) {
    const auto named = column_named(name);
    if (!named || !kind_.has(named->role) || (named->needs_unit && !named->unit)) return false;
    faults_.add_column(index,
                       fmt::format("a column without another meaning to group rows by, and this "
                                   "is read as {}",
                                   plain_name(*named)));
    return true;
  }

  std::optional<std::size_t> same_as(const DataColumn& column) const {
    if (column.role == DataRole::no_name) return std::nullopt;
    for (std::size_t i = 0; i < result_.columns.size(); ++i) {
      const DataColumn& other = result_.columns[i];
      // Of several clocks a log has one that goes before.
      const bool has_own_name = column.role == DataRole::covariate || column.role == DataRole::time;
      const bool by_name = has_own_name ? other.name == column.name : other.place == column.place;
      if (other.role == column.role && by_name) return i;
    }
    return std::nullopt;
  }

  void fail_same(std::size_t index, std::size_t first) {
    const std::string& name = result_.columns[first].name;
    if (name != trimmed(csv_.header().fields[index])) {
      return faults_.add_column(
          index, fmt::format("one column of its meaning, and column {} '{}' has it", first + 1,
                             for_message(name)));
    }
    faults_.add({.where = {},
                 .what = fmt::format("column {} '{}': column {} has that name already", index + 1,
                                     for_message(name), first + 1)});
  }

  // Nobody may think that something was done with what the file does not have.
  void require_options() {
    const auto is_there = [&](const auto& is) {
      return std::any_of(result_.columns.begin(), result_.columns.end(), is);
    };
    const auto require_name = [&](const std::string& name, const std::string& what) {
      if (is_there([&](const DataColumn& column) { return column.name == name; })) return;
      faults_.add(
          {.what = "the header has no column", .value = for_message(name), .expected = what});
    };
    for (const ColumnMeaning& mapped : options_.map) {
      require_name(mapped.column, fmt::format("the column that means {}", mapped.meaning));
    }
    if (options_.group) require_name(group_.value_or(*options_.group), "the column of groups");
    for (const ColumnUnit& given : options_.units) {
      if (!given.column || is_there([&](const DataColumn& column) {
            return means(*given.column, column.name, column.role, column.place);
          })) {
        continue;
      }
      require_name(*given.column, fmt::format("the column that is in {}", given.unit));
    }
  }

  void note_name(const ColumnName& named, const std::string& name,
                 const std::optional<Unit>& unit) {
    const Dimension dimension = dimension_of(named.role);
    const bool assumed = dimension != Dimension::none && !unit;
    const auto in_name = unit_of_name(named, name, options_);
    const bool against_name = unit && in_name && !(*unit == *in_name);
    const bool in_plain_unit =
        named.role != DataRole::time || named.unit || (unit && unit->is_own());
    const bool as_docs_say = !assumed && in_plain_unit;
    if (is_plain(name, named) && as_docs_say && !against_name) return;
    std::string text = fmt::format("'{}' as {}", for_message(name), plain_name(named));
    if (assumed) {
      text += fmt::format(" (no unit is said: {} is assumed)", own_unit(dimension).name);
    }
    if (unit && !unit->is_own()) text += fmt::format(" (from {})", unit->name);
    if (against_name) text += fmt::format(", though its name says {}", in_name->name);
    result_.read_as.back() = std::move(text);
  }

  const CsvReader& csv_;
  const std::optional<CsvRow>& units_;
  const ReadingOptions& options_;
  const FileKind& kind_;
  HeaderFaults& faults_;
  std::optional<std::string> group_;  // the header of the column of groups
  HeaderColumns result_;
};

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 30;
  std::string list;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (name.empty() || ++count > most) continue;
    list += (list.empty() ? "" : ", ") + name;
  }
  if (count > most) list += fmt::format(", and {} more", count - most);
  return list;
}

}  // namespace

HeaderColumns read_header(const CsvReader& csv, const std::optional<CsvRow>& units,
                          const ReadingOptions& options, const FileKind& kind,
                          HeaderFaults& faults) {
  return HeaderReader(csv, units, options, kind, faults).read();
}

void make_covariate(HeaderColumns& header, std::size_t column) {
  DataColumn& at = header.columns[column];
  const CellRange any;
  at = {DataRole::covariate, at.name, any.low, any.high, {}, {}, at.name};
  header.read_as[column].clear();
}

std::vector<DataNote> header_notes(const HeaderColumns& header,
                                   const std::optional<CsvRow>& units) {
  std::vector<DataNote> notes = header.notes;
  const std::string list = list_of(header.read_as);
  if (!list.empty()) {
    notes.push_back({NoteKind::column_names, "columns are read so: " + list, {}});
  }
  if (units) {
    notes.push_back({NoteKind::passed_over,
                     "the row below the header has the columns' units, and no reading",
                     {units->line}});
  }
  return notes;
}

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
