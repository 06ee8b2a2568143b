#include "reports/document/chosen_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::reports {
namespace {

std::size_t column_of(const Table& table, const std::string& wanted) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (key(table.columns[i]) == wanted) return i;
  }
  std::vector<std::string> there;
  for (const TableColumn& column : table.columns) there.push_back(key(column));
  throw InputError({.what = "columns",
                    .value = wanted,
                    .expected = fmt::format("any of {}{}", fmt::join(there, ", "),
                                            did_you_mean(wanted, there))});
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

[[noreturn]] void fail(const std::string& text, const std::string& name,
                       const std::vector<std::string>& known,
                       const std::vector<MissingColumns>& missing) {
  InputFault fault{
      .where = fmt::format("columns '{}'", text),
      .what = fmt::format("there is no column '{}'", name),
      .expected = fmt::format("any of {}{}", fmt::join(known, ", "), did_you_mean(name, known)),
      .form = InputForm::unknown};
  for (const MissingColumns& others : missing) {
    if (!holds(others.names, name)) continue;
    fault.expected = others.with + ", with which there is one";
    break;
  }
  throw InputError(std::move(fault));
}

}  // namespace

std::string key(const TableColumn& column) {
  return column.key.empty() ? column.heading : column.key;
}

Table with_columns(const Table& table, const std::vector<std::string>& keys) {
  std::vector<std::size_t> places;
  for (const std::string& wanted : keys) places.push_back(column_of(table, wanted));
  Table result = columns_at(table, places);
  result.chosen = true;
  for (TableColumn& column : result.columns) column.dispensable = 0;
  return result;
}

std::vector<std::string> parse_columns(const std::string& text,
                                       const std::vector<std::string>& known,
                                       const std::vector<MissingColumns>& missing) {
  std::vector<std::string> chosen;
  for (const std::string& item : comma_separated(text)) {
    const std::string name(trimmed(item));
    if (name.empty()) {
      throw InputError({.where = fmt::format("columns '{}'", text),
                        .what = "nothing stands before or behind a comma",
                        .expected = "a name of a column there, or no comma",
                        .form = InputForm::unknown});
    }
    if (!holds(known, name)) fail(text, name, known, missing);
    if (holds(chosen, name)) {
      throw InputError({.where = fmt::format("columns '{}'", text),
                        .what = fmt::format("'{}' is there twice", name)});
    }
    chosen.push_back(name);
  }
  return chosen;
}

}  // namespace reeve::reports
