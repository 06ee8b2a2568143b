#include "readings/header_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "readings/column_units.hpp"
#include "readings/words.hpp"

namespace reeve::readings {
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

}  // namespace reeve::readings
