#include "readings/units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/text.hpp"

namespace reeve::readings {
namespace {

constexpr double standard_fall = 9.80665;
constexpr double pound_kg = 0.45359237;

struct KnownUnit {
  Unit unit;
  std::array<std::string_view, 4> spellings;  // in small letters
};

// The first of each dimension is reeve's own.
constexpr std::array known_units{
    KnownUnit{{Dimension::force, "N", 1, 0}, {"n", "newton", "newtons"}},
    KnownUnit{{Dimension::force, "mN", 1e-3, 0}, {"mn"}},
    KnownUnit{{Dimension::force, "cN", 1e-2, 0}, {"cn"}},
    KnownUnit{{Dimension::force, "daN", 10, 0}, {"dan"}},
    KnownUnit{{Dimension::force, "kN", 1e3, 0}, {"kn"}},
    KnownUnit{{Dimension::force, "gf", standard_fall / 1000, 0}, {"g", "gf", "gram", "grams"}},
    KnownUnit{{Dimension::force, "kgf", standard_fall, 0}, {"kg", "kgf", "kp"}},
    KnownUnit{{Dimension::force, "lbf", pound_kg* standard_fall, 0},
              {"lb", "lbs", "lbf", "pounds"}},
    KnownUnit{{Dimension::force, "ozf", pound_kg* standard_fall / 16, 0}, {"ozf"}},
    KnownUnit{{Dimension::speed, "mm/s", 1, 0}, {"mm/s"}},
    KnownUnit{{Dimension::speed, "cm/s", 10, 0}, {"cm/s"}},
    KnownUnit{{Dimension::speed, "m/s", 1000, 0}, {"m/s"}},
    KnownUnit{{Dimension::speed, "mm/min", 1.0 / 60, 0}, {"mm/min"}},
    KnownUnit{{Dimension::speed, "m/min", 1000.0 / 60, 0}, {"m/min"}},
    KnownUnit{{Dimension::speed, "in/s", 25.4, 0}, {"in/s"}},
    KnownUnit{{Dimension::temperature, "°C", 1, 0}, {"°c", "c", "degc", "celsius"}},
    KnownUnit{{Dimension::temperature, "°F", 5.0 / 9, -160.0 / 9}, {"°f", "f", "degf"}},
    KnownUnit{{Dimension::temperature, "K", 1, -273.15}, {"k"}},
    KnownUnit{{Dimension::angle, "rad", 1, 0}, {"rad"}},
    KnownUnit{{Dimension::angle, "deg", std::numbers::pi / 180, 0}, {"deg", "°"}},
    KnownUnit{{Dimension::length, "mm", 1, 0}, {"mm"}},
    KnownUnit{{Dimension::length, "cm", 10, 0}, {"cm"}},
    KnownUnit{{Dimension::length, "m", 1000, 0}, {"m"}},
    KnownUnit{{Dimension::length, "µm", 1e-3, 0}, {"um", "µm"}},
    KnownUnit{{Dimension::length, "in", 25.4, 0}, {"in", "inch"}},
    KnownUnit{{Dimension::time, "s", 1, 0}, {"s", "sec", "seconds"}},
    KnownUnit{{Dimension::time, "ms", 1e-3, 0}, {"ms"}},
    KnownUnit{{Dimension::time, "µs", 1e-6, 0}, {"us", "µs"}},
    KnownUnit{{Dimension::time, "ns", 1e-9, 0}, {"ns"}},
    KnownUnit{{Dimension::time, "min", 60, 0}, {"min"}},
};

}  // namespace

std::string_view without_brackets(std::string_view text) {
  text = trimmed(text);
  const bool bracketed = (text.starts_with('[') && text.ends_with(']')) ||
                         (text.starts_with('(') && text.ends_with(')'));
  return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::optional<Unit> find_unit(std::string_view text, Dimension dimension) {
  text = without_brackets(text);
  if (text == "MN") return std::nullopt;  // the only one that its letters' size tells from another
  const std::string small = lower(text);
  for (const auto& [unit, spellings] : known_units) {
    if (small.empty() || unit.dimension != dimension) continue;
    if (std::find(spellings.begin(), spellings.end(), small) != spellings.end()) return unit;
  }
  return std::nullopt;
}

bool is_unit(std::string_view text) {
  return std::any_of(known_units.begin(), known_units.end(), [&](const KnownUnit& known) {
    return find_unit(text, known.unit.dimension).has_value();
  });
}

Unit own_unit(Dimension dimension) {
  for (const KnownUnit& known : known_units) {
    if (known.unit.dimension == dimension) return known.unit;
  }
  return {};
}

std::string unit_names(Dimension dimension) {
  std::string list;
  for (const KnownUnit& known : known_units) {
    if (known.unit.dimension != dimension) continue;
    list += (list.empty() ? "" : ", ") + std::string(known.unit.name);
  }
  return list;
}

const char* dimension_name(Dimension dimension) {
  constexpr std::array names{"nothing", "force", "speed", "temperature", "angle", "length", "time"};
  return names[static_cast<std::size_t>(dimension)];
}

}  // namespace reeve::readings
