#include "readings/reading_options.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"

namespace reeve::readings {
namespace {

// A unit has no '=', and no name that reeve knows has one; a name in a file may.
std::optional<ColumnMeaning> split_at_last_equals(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) return std::nullopt;
  const std::string_view all = text;
  return ColumnMeaning{std::string(trimmed(all.substr(0, equals))),
                       std::string(trimmed(all.substr(equals + 1)))};
}

}  // namespace

ColumnMeaning parse_column_meaning(const std::string& text) {
  auto parts = split_at_last_equals(text);
  if (!parts || parts->column.empty() || !column_named(parts->meaning)) {
    throw InputError({.value = text,
                      .expected = "a column of the file, '=', and a name that reeve knows, such as "
                                  "'Kraft Motor=motor_tension_N'"});
  }
  return *parts;
}

ColumnUnit parse_column_unit(const std::string& text) {
  const auto parts = split_at_last_equals(text);
  ColumnUnit result{{}, text};
  if (parts) result = {parts->column, parts->meaning};
  const auto is_of = [&](Dimension dimension) {
    return find_unit(result.unit, dimension).has_value();
  };
  const bool is_unit =
      is_of(Dimension::force) ||
      (parts && (is_of(Dimension::speed) || is_of(Dimension::temperature) ||
                 is_of(Dimension::angle) || is_of(Dimension::length) || is_of(Dimension::time)));
  if (!is_unit || (parts && parts->column.empty())) {
    throw InputError({.value = text,
                      .expected = "a unit of force (" + unit_names(Dimension::force) +
                                  "), or a column, '=' and its unit, such as T1=kgf"});
  }
  return result;
}

}  // namespace reeve::readings
