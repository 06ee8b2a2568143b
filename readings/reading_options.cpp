#include "readings/reading_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"

namespace reeve::readings {
namespace {

struct ColumnAndValue {
  std::string column;
  std::string value;
};

// A unit has no '=', and no name that reeve knows has one; a name in a file may.
std::optional<ColumnAndValue> split_at_last_equals(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos) return std::nullopt;
  return ColumnAndValue{std::string(trimmed(text.substr(0, equals))),
                        std::string(trimmed(text.substr(equals + 1)))};
}

// Beyond this a share says nothing of the tension.
constexpr double most_percent = 100;
constexpr double most_N = 1e9;

[[noreturn]] void fail(const std::string& what, std::string_view value,
                       const std::string& expected) {
  throw InputError({.what = what, .value = std::string(value), .expected = expected});
}

// "2%" or "0.3N"; false of what is neither.
bool add_part(std::string_view part, KnownNoise& noise) {
  const bool relative = part.ends_with('%');
  const bool has_unit = relative || part.ends_with('N');
  const auto value = number_in(trimmed(part.substr(0, part.size() - (has_unit ? 1 : 0))));
  if (!value) return false;
  if (!has_unit)
    fail("noise without a unit", part, "a share with %, or a force with N, such as 0.5N");
  const double most = relative ? most_percent : most_N;
  if (*value < 0) fail("a standard deviation below 0", part, "0 or more");
  if (*value > most) {
    fail("a standard deviation", part,
         relative ? fmt::format("at most {:g}%, beyond which a reading says nothing", most)
                  : fmt::format("at most {:g}N", most));
  }
  (relative ? noise.relative : noise.absolute_N) = relative ? *value / 100 : *value;
  return true;
}

bool read_parts(std::string_view text, KnownNoise& noise) {
  const std::size_t plus = text.find('+');
  if (plus == std::string_view::npos) return add_part(trimmed(text), noise);
  const std::string_view first = trimmed(text.substr(0, plus));
  const std::string_view second = trimmed(text.substr(plus + 1));
  return first.ends_with('%') != second.ends_with('%') && add_part(first, noise) &&
         add_part(second, noise);
}

}  // namespace

double KnownNoise::deviation(double tension_N) const {
  return std::hypot(absolute_N, relative * tension_N);
}

std::string noise_text(const KnownNoise& noise) {
  const std::string relative = fmt::format("{:g} %", 100 * noise.relative);
  const std::string absolute = fmt::format("{:g} N", noise.absolute_N);
  if (noise.relative == 0) return noise.absolute_N == 0 ? "exact" : absolute;
  return noise.absolute_N == 0 ? relative : relative + " and " + absolute;
}

ColumnMeaning parse_column_meaning(const std::string& text) {
  const auto parts = split_at_last_equals(text);
  const bool is_none = parts && parts->column == parts->value;  // it is what its name says
  if (!parts || parts->column.empty() || (!is_none && !column_named(parts->value))) {
    throw InputError({.value = text,
                      .expected = "a column of the file, '=', and a name that reeve knows, such as "
                                  "'Kraft Motor=motor_tension_N'"});
  }
  return {parts->column, parts->value};
}

ColumnUnit parse_column_unit(const std::string& text) {
  const auto parts = split_at_last_equals(text);
  if (parts && !parts->column.empty() && is_unit(parts->value)) {
    return {parts->column, parts->value};
  }
  if (!parts && find_unit(text, Dimension::force)) return {{}, text};
  throw InputError({.value = text,
                    .expected = "a unit of force (" + unit_names(Dimension::force) +
                                "), or a column, '=' and its unit, such as T1=kgf"});
}

ColumnNoise parse_column_noise(const std::string& text) {
  const auto parts = split_at_last_equals(text);
  KnownNoise noise;
  const auto is_read = [&] {
    try {
      return read_parts(parts->value, noise);
    } catch (const InputError& error) {
      throw error.at(fmt::format("'{}'", text));
    }
  };
  if (!parts || parts->column.empty() || !is_read()) {
    throw InputError({.value = text,
                      .expected =
                          "a column of tensions or 'motor', '=', and the standard deviation "
                          "of a reading, such as T1=2%, motor=0.5N or T1=2%+0.3N"});
  }
  return {parts->column, noise};
}

}  // namespace reeve::readings
