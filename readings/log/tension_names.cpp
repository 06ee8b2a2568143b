#include "readings/log/tension_names.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "readings/units.hpp"
#include "readings/words.hpp"

namespace reeve::readings {
namespace {

bool is_known_unit(std::string_view text) {
  constexpr std::array dimensions{Dimension::force,  Dimension::speed, Dimension::temperature,
                                  Dimension::length, Dimension::angle, Dimension::time};
  return std::any_of(dimensions.begin(), dimensions.end(),
                     [&](Dimension dimension) { return find_unit(text, dimension).has_value(); });
}

}  // namespace

std::optional<ColumnName> tension_in_no_unit_of_force(std::string_view name) {
  const NameWords words = words_of(name);
  if (!words.bracketed || is_known_unit(*words.bracketed)) return std::nullopt;
  const std::string before(name.substr(0, name.find_last_of("[(")));
  const auto named = try_column_named(before + "[N]");
  return named && is_of_sensor(named->role) ? named : std::nullopt;
}

}  // namespace reeve::readings
