#include "readings/units.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "readings/column_name.hpp"

namespace reeve::readings {
namespace {

constexpr double standard_fall = 9.80665;
constexpr double pound_kg = 0.45359237;

struct Spelling {
  const char* text;  // in small letters
  Unit unit;
};

constexpr Unit gram_force{Dimension::force, "gf", standard_fall / 1000, 0};
constexpr Unit kilogram_force{Dimension::force, "kgf", standard_fall, 0};
constexpr Unit pound_force{Dimension::force, "lbf", pound_kg* standard_fall, 0};
constexpr Unit celsius{Dimension::temperature, "°C", 1, 0};
constexpr Unit fahrenheit{Dimension::temperature, "°F", 5.0 / 9, -160.0 / 9};
constexpr Unit micrometre{Dimension::length, "µm", 1e-3, 0};
constexpr Unit inch{Dimension::length, "in", 25.4, 0};
constexpr Unit full_second{Dimension::time, "s", 1, 0};
constexpr Unit microsecond{Dimension::time, "µs", 1e-6, 0};
constexpr Unit degree{Dimension::angle, "deg", std::numbers::pi / 180, 0};

// The first of each dimension is reeve's own.
constexpr std::array spellings{
    Spelling{"n", {Dimension::force, "N", 1, 0}},
    Spelling{"newton", {Dimension::force, "N", 1, 0}},
    Spelling{"newtons", {Dimension::force, "N", 1, 0}},
    Spelling{"mn", {Dimension::force, "mN", 1e-3, 0}},
    Spelling{"cn", {Dimension::force, "cN", 1e-2, 0}},
    Spelling{"dan", {Dimension::force, "daN", 10, 0}},
    Spelling{"kn", {Dimension::force, "kN", 1e3, 0}},
    Spelling{"g", gram_force},
    Spelling{"gf", gram_force},
    Spelling{"gram", gram_force},
    Spelling{"grams", gram_force},
    Spelling{"kg", kilogram_force},
    Spelling{"kgf", kilogram_force},
    Spelling{"kp", kilogram_force},
    Spelling{"lb", pound_force},
    Spelling{"lbs", pound_force},
    Spelling{"lbf", pound_force},
    Spelling{"pounds", pound_force},
    Spelling{"ozf", {Dimension::force, "ozf", pound_kg* standard_fall / 16, 0}},
    Spelling{"mm/s", {Dimension::speed, "mm/s", 1, 0}},
    Spelling{"cm/s", {Dimension::speed, "cm/s", 10, 0}},
    Spelling{"m/s", {Dimension::speed, "m/s", 1000, 0}},
    Spelling{"mm/min", {Dimension::speed, "mm/min", 1.0 / 60, 0}},
    Spelling{"m/min", {Dimension::speed, "m/min", 1000.0 / 60, 0}},
    Spelling{"in/s", {Dimension::speed, "in/s", 25.4, 0}},
    Spelling{"°c", celsius},
    Spelling{"c", celsius},
    Spelling{"degc", celsius},
    Spelling{"celsius", celsius},
    Spelling{"°f", fahrenheit},
    Spelling{"f", fahrenheit},
    Spelling{"degf", fahrenheit},
    Spelling{"k", {Dimension::temperature, "K", 1, -273.15}},
    Spelling{"rad", {Dimension::angle, "rad", 1, 0}},
    Spelling{"deg", degree},
    Spelling{"°", degree},
    Spelling{"mm", {Dimension::length, "mm", 1, 0}},
    Spelling{"cm", {Dimension::length, "cm", 10, 0}},
    Spelling{"m", {Dimension::length, "m", 1000, 0}},
    Spelling{"um", micrometre},
    Spelling{"µm", micrometre},
    Spelling{"in", inch},
    Spelling{"inch", inch},
    Spelling{"s", full_second},
    Spelling{"sec", full_second},
    Spelling{"seconds", full_second},
    Spelling{"ms", {Dimension::time, "ms", 1e-3, 0}},
    Spelling{"us", microsecond},
    Spelling{"µs", microsecond},
    Spelling{"min", {Dimension::time, "min", 60, 0}},
};

}  // namespace

std::optional<Unit> find_unit(std::string_view text, Dimension dimension) {
  text = without_brackets(text);
  if (text == "MN") return std::nullopt;  // the only one that its letters' size tells from another
  const std::string small = lower(text);
  const auto found =
      std::find_if(spellings.begin(), spellings.end(), [&](const Spelling& spelling) {
        return spelling.unit.dimension == dimension && small == spelling.text;
      });
  if (found == spellings.end()) return std::nullopt;
  return found->unit;
}

Unit own_unit(Dimension dimension) {
  for (const Spelling& spelling : spellings) {
    if (spelling.unit.dimension == dimension) return spelling.unit;
  }
  return {};
}

std::string unit_names(Dimension dimension) {
  std::string list;
  std::string last;
  for (const Spelling& spelling : spellings) {
    if (spelling.unit.dimension != dimension || last == spelling.unit.name) continue;
    last = spelling.unit.name;
    list += (list.empty() ? "" : ", ") + last;
  }
  return list;
}

const char* dimension_name(Dimension dimension) {
  switch (dimension) {
    case Dimension::none:
      return "nothing";
    case Dimension::force:
      return "force";
    case Dimension::speed:
      return "speed";
    case Dimension::temperature:
      return "temperature";
    case Dimension::angle:
      return "angle";
    case Dimension::length:
      return "length";
    case Dimension::time:
      return "time";
  }
  return "";
}

}  // namespace reeve::readings
