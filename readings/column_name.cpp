#include "readings/column_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::readings {

namespace {

struct KnownName {
  const char* letters;
  const char* plain;
  DataRole role;
  Dimension dimension = Dimension::none;
};

// Clocks in docs: seconds, where the name says no other unit.
constexpr std::array plain_clocks{"time_s",  "t_s",  "t",    "time", "timestamp",
                                  "time_ms", "t_ms", "t_us", "t_ns"};

constexpr std::array known_names{
    KnownName{"run", "run", DataRole::run},
    KnownName{"routing", "routing", DataRole::routing},
    KnownName{"held", "held", DataRole::held},
    KnownName{"direction", "direction", DataRole::direction},
    KnownName{"motortension", "motor_tension_N", DataRole::motor_tension, Dimension::force},
    KnownName{"motorforce", "motor_tension_N", DataRole::motor_tension, Dimension::force},
    KnownName{"motortensionsd", "motor_tension_sd_N", DataRole::motor_deviation, Dimension::force},
    KnownName{"speed", "speed_mm_s", DataRole::speed, Dimension::speed},
    KnownName{"cycle", "cycle", DataRole::cycle},
    KnownName{"temperature", "temperature_C", DataRole::temperature, Dimension::temperature},
    KnownName{"sheathangle", "sheath_angle_rad", DataRole::sheath_angle, Dimension::angle},
    KnownName{"readings", "readings", DataRole::readings},
    KnownName{"time", "time_s", DataRole::time, Dimension::time},
    KnownName{"timestamp", "time_s", DataRole::time, Dimension::time},
    KnownName{"t", "time_s", DataRole::time, Dimension::time},
    KnownName{"elapsed", "time_s", DataRole::time, Dimension::time},
    KnownName{"xvalue", "time_s", DataRole::time, Dimension::time},  // LabVIEW
    KnownName{"position", "position_mm", DataRole::position, Dimension::length},
    KnownName{"pos", "position_mm", DataRole::position, Dimension::length},
};

bool is_plain_clock(std::string_view text) {
  return std::find(plain_clocks.begin(), plain_clocks.end(), text) != plain_clocks.end();
}

bool all_of(std::string_view text, int (*is)(int)) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return is(static_cast<unsigned char>(c)) != 0;
  });
}

// Has the form of a tension's name without T: 1, a, ab, h1. A motor-side segment has two letters at
// most: 702 of them are more than 64 fingers can have.
bool looks_like_a_segment(std::string_view letters) {
  if (all_of(letters, std::isalpha)) return letters.size() <= 2;
  if (letters.starts_with('h')) letters.remove_prefix(1);
  return all_of(letters, std::isdigit);
}

// "01" → T1, "ab" → ab, "h1" → h1.
std::optional<Segment> segment_of(std::string_view letters) {
  if (all_of(letters, std::isalpha)) return segment_named(letters);
  const bool hand = letters.starts_with('h');
  std::string_view digits = letters.substr(hand ? 1 : 0);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return segment_named((hand ? "h" : "T") + std::string(digits));
}

// `letters` begin with t, and are in small letters.
std::optional<ColumnName> tension_named(std::string_view letters, const std::optional<Unit>& unit) {
  ColumnName result{DataRole::tension, {}, unit, false};
  if (letters.starts_with("at")) {
    letters.remove_prefix(2);
    result.place.beside = true;
  }
  if (!letters.starts_with('t')) return std::nullopt;
  letters.remove_prefix(1);
  // "tsd" itself is a segment of two letters.
  if (letters.size() > 2 && letters.ends_with("sd")) {
    result.role = DataRole::deviation;
    letters.remove_suffix(2);
  }
  if (!looks_like_a_segment(letters)) return std::nullopt;
  const bool is_strand = all_of(letters, std::isdigit);
  if (result.place.beside && !is_strand) return std::nullopt;
  const std::optional<Segment> segment = segment_of(letters);
  if (!segment) {
    if (!unit) return std::nullopt;
    throw InputError({.expected =
                          "a tension written as T1_N (strand), Ta_N (motor-side segment), Th1_N "
                          "(stretch at the hand) or at_T1_N (the motor-side segment at T1)"});
  }
  result.place.segment = *segment;
  result.needs_unit = !is_strand;
  return result;
}

std::optional<DataRole> known_role(const std::string& letters) {
  for (const KnownName& known : known_names) {
    if (letters == known.letters) return known.role;
  }
  return std::nullopt;
}

std::optional<ColumnName> named_by(const std::string& letters, const std::optional<Unit>& unit) {
  if (const auto role = known_role(letters)) return ColumnName{*role, {}, unit, false};
  return tension_named(letters, unit);
}

// Returns the unit of what the letters would be.
std::optional<Unit> unit_after(const std::string& letters, std::string_view unit) {
  return find_unit(unit, dimension_of(known_role(letters).value_or(DataRole::tension)));
}

}  // namespace

namespace {

// "T1 / N" and "T1 in N", as ISO 80000 writes them.
void take_unit_behind(std::string_view& name, std::optional<std::string>& unit) {
  for (const std::string_view mark : {" / ", " in "}) {
    const std::size_t at = name.rfind(mark);
    if (at == std::string_view::npos || !is_unit(name.substr(at + mark.size()))) continue;
    unit = trimmed(name.substr(at + mark.size()));
    name = trimmed(name.substr(0, at));
    return;
  }
}

}  // namespace

NameWords words_of(std::string_view name) {
  NameWords result;
  name = trimmed(name);
  if (name.ends_with(']') || name.ends_with(')')) {
    const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
    if (open != std::string_view::npos) {
      result.bracketed = trimmed(name.substr(open + 1, name.size() - open - 2));
      name = name.substr(0, open);
    }
  }
  if (!result.bracketed) take_unit_behind(name, result.bracketed);
  bool in_word = false;
  for (const char c : lower(name)) {
    const bool parts = c == ' ' || c == '_' || c == '-' || c == '.' || c == '\t';
    if (!parts && !in_word) result.words.emplace_back();
    if (!parts) result.words.back() += c;
    in_word = !parts;
  }
  return result;
}

std::string joined(const NameWords& name, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += name.words[i];
  return text;
}

void require_short_name(std::string_view name) {
  if (name.size() <= longest_name) return;
  throw InputError({.expected = fmt::format("a name of at most {} bytes, and it has {}",
                                            longest_name, name.size())});
}

std::optional<ColumnName> column_named(std::string_view name) {
  NameWords words = words_of(name);
  // An Arduino's clocks have their units for a name.
  for (const auto& [clock, unit] : {std::pair{"millis", "ms"}, std::pair{"micros", "us"}}) {
    if (lower(trimmed(name)) != clock) continue;
    return ColumnName{DataRole::time, {}, find_unit(unit, Dimension::time), false};
  }
  if (words.bracketed && (words.bracketed->empty() || *words.bracketed == "-")) {
    words.bracketed.reset();
  }
  const std::size_t count = words.words.size();
  if (words.bracketed) {
    const std::string letters = joined(words, count);
    const auto unit = unit_after(letters, *words.bracketed);
    return unit ? named_by(letters, unit) : std::nullopt;
  }
  // "speed_mm_s": the unit may be two words. First the most: "Ta_N" is no "tan".
  for (const std::size_t of_unit : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
    if (count <= of_unit) continue;
    const std::string letters = joined(words, count - of_unit);
    if (letters == "t" && !is_plain_clock(trimmed(name))) continue;  // T_min may be a tension
    std::optional<Unit> unit;
    if (of_unit > 0) {
      const std::string& last = words.words[count - 1];
      unit = unit_after(letters, of_unit == 1 ? last : words.words[count - 2] + "/" + last);
      if (!unit) continue;
    }
    if (auto found = named_by(letters, unit)) return found;
  }
  return std::nullopt;
}

std::optional<ColumnName> try_column_named(std::string_view name) {
  try {
    return column_named(name);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<NoForce> tension_in_no_unit_of_force(std::string_view name) {
  // Behind a blank or _, other words are a part of the name: "T3_left".
  constexpr std::array known{"a",   "ma",   "v",     "mv",     "nm",     "nmm",   "ncm",
                             "mnm", "adc",  "count", "counts", "cts",    "raw",   "lsb",
                             "bit", "bits", "pct",   "digit",  "digits", "ticks", "ohm"};
  NameWords words = words_of(name);
  const bool is_behind = !words.bracketed && words.words.size() > 1;
  if (is_behind) {
    if (std::ranges::find(known, words.words.back()) == known.end()) return std::nullopt;
    words.bracketed = trimmed(name).substr(trimmed(name).size() - words.words.back().size());
    words.words.pop_back();
  }
  if (!words.bracketed || words.bracketed->empty() || is_unit(*words.bracketed)) {
    return std::nullopt;
  }
  const auto named = try_column_named(joined(words, words.words.size()) + "[N]");
  if (!named || !is_of_sensor(named->role) || (is_behind && named->needs_unit)) return std::nullopt;
  return NoForce{*named, *words.bracketed};
}

std::optional<double> clock_unit(std::string_view name) {
  const auto named = try_column_named(name);
  if (!named || named->role != DataRole::time) return std::nullopt;
  return named->unit ? named->unit->factor : 1;
}

Dimension dimension_of(DataRole role) {
  if (role == DataRole::tension || role == DataRole::deviation) return Dimension::force;
  for (const KnownName& known : known_names) {
    if (known.role == role) return known.dimension;
  }
  return Dimension::none;
}

bool is_of_sensor(DataRole role) {
  return role == DataRole::motor_tension || role == DataRole::tension;
}

bool is_of_numbers(DataRole role) {
  constexpr std::array others{DataRole::run,       DataRole::routing, DataRole::held,
                              DataRole::direction, DataRole::group,   DataRole::no_name,
                              DataRole::covariate};
  return std::find(others.begin(), others.end(), role) == others.end();
}

std::string plain_name(const ColumnName& name) {
  for (const KnownName& known : known_names) {
    if (known.role == name.role) return known.plain;
  }
  const bool is_strand = name.place.segment.kind == SegmentKind::strand;
  return std::string(name.place.beside ? "at_" : "") + (is_strand ? "" : "T") +
         segment_name(name.place.segment) + (name.role == DataRole::deviation ? "_sd" : "") + "_N";
}

bool is_plain(std::string_view text, const ColumnName& name) {
  return name.role == DataRole::time ? is_plain_clock(text) : text == plain_name(name);
}

}  // namespace reeve::readings
