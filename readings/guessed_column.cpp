#include "readings/guessed_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "readings/column_name.hpp"
#include "readings/columns.hpp"
#include "readings/units.hpp"

namespace reeve::readings {
namespace {

// A part of a name, in small letters, and what a column with it holds; the first that fits counts.
struct Hint {
  std::string_view part;
  std::string_view meaning;
};

constexpr std::array clock_hints{Hint{"zeit", "time"}, Hint{"time", "time"},
                                 Hint{"sekunde", "time"}, Hint{"elapsed", "time"}};
constexpr std::array motion_hints{
    Hint{"geschw", "speed"},    Hint{"veloc", "speed"},     Hint{"speed", "speed"},
    Hint{"weg", "position"},    Hint{"hub", "position"},    Hint{"position", "position"},
    Hint{"travel", "position"}, Hint{"stroke", "position"}, Hint{"displacement", "position"},
};
constexpr std::array label_hints{
    Hint{"versuch", "run"},
    Hint{"messung", "run"},
    Hint{"trial", "run"},
    Hint{"seilführung", "routing"},
    Hint{"verlegung", "routing"},
    Hint{"gehalten", "held"},
    Hint{"blockiert", "held"},
    Hint{"held", "held"},
    Hint{"direction", "direction"},
    Hint{"richtung", "direction"},
    Hint{"zyklus", "cycle"},
    Hint{"zyklen", "cycle"},
    Hint{"temperatur", "temperature"},
    Hint{"temp", "temperature"},
};

// Words for a grasp that may be other things: only the cells tell.
constexpr std::array<std::string_view, 7> parts_of_grasp{"grasp",   "finger",   "blocked", "fixed",
                                                         "holding", "obstacle", "griff"};

constexpr std::array<std::string_view, 9> parts_of_force{
    "kraft", "force", "tension", "seilzug", "zugkraft", "load", "last", "wägezelle", "fz"};
constexpr std::array<std::string_view, 5> parts_of_drive{"motor", "antrieb", "aktor", "actuator",
                                                         "schlitten"};
constexpr std::array<std::string_view, 2> parts_of_sum{"gesamt", "total"};

// Quantities that a motor logs in place of its pull.
constexpr std::array<std::string_view, 2> parts_of_current{"strom", "current"};
constexpr std::array<std::string_view, 2> parts_of_torque{"moment", "torque"};

template <std::size_t Size>
bool has_part(const std::string& letters, const std::array<std::string_view, Size>& parts) {
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
    return letters.find(part) != std::string::npos;
  });
}

template <std::size_t Size>
std::string hinted(const std::string& letters, const std::array<Hint, Size>& hints) {
  for (const Hint& hint : hints) {
    if (letters.find(hint.part) != std::string::npos) return std::string(hint.meaning);
  }
  return "";
}

// The whole number in a name: 1 of "kraft1" and "kraft 1 links".
std::optional<std::string> number_in_name(const std::string& letters) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto begin = std::find_if(letters.begin(), letters.end(), is_digit);
  if (begin == letters.end()) return std::nullopt;
  const auto end = std::find_if_not(begin, letters.end(), is_digit);
  return std::string(begin, end);
}

// True of "Motor [N]", "Motor_N" and "Motor" above a unit of force.
bool has_unit_of_force(const std::string& name, const std::string& unit) {
  return find_unit(unit, Dimension::force) || unit_at_the_end(name, Dimension::force);
}

class ColumnGuess {
 public:
  // `unit` is as the name or the row of units has it, or "".
  ColumnGuess(const std::string& name, std::string unit)
      : words_(words_of(name)),
        letters_(joined(words_, words_.words.size())),
        unit_(std::move(unit)),
        is_in_force_(has_unit_of_force(name, unit_)) {}

  GuessedColumn guess() const {
    if (const std::string reason = no_tension(); !reason.empty()) return unknown(reason);
    if (has_part(letters_, parts_of_force)) return tension();
    if (has_part(letters_, parts_of_drive) && is_in_force_) return guessed("motor_tension");
    if (const std::string clock = hinted(letters_, clock_hints); !clock.empty()) {
      return in_unit_of(clock, Dimension::time);
    }
    if (const std::string motion = hinted(letters_, motion_hints); !motion.empty()) {
      return in_unit_of(motion, motion == "speed" ? Dimension::speed : Dimension::length);
    }
    const std::string label = hinted(letters_, label_hints);
    return label.empty() ? unknown("") : guessed(label);
  }

 private:
  static GuessedColumn guessed(const std::string& meaning) {
    return {"", meaning, GuessKind::guessed, ""};
  }
  static GuessedColumn unknown(const std::string& reason) {
    return {"", "", GuessKind::unknown, reason};
  }

  std::string no_tension() const {
    const std::string unit = lower(unit_);
    if (has_part(letters_, parts_of_current) || unit == "a" || unit == "ma") {
      return "a current is no tension; multiplied by newton per ampere of motor and spool it "
             "would be motor_tension_N";
    }
    if (has_part(letters_, parts_of_torque) || unit == "nm" || unit == "nmm") {
      return "a torque is no tension; divided by the spool's radius it would be motor_tension_N";
    }
    return "";
  }

  GuessedColumn tension() const {
    const GuessedColumn found = named_tension();
    if (found.meaning.empty()) return found;
    const GuessedColumn read = in_unit_of(found.meaning, Dimension::force);
    return read.kind == GuessKind::guessed ? found : read;
  }

  GuessedColumn named_tension() const {
    if (has_part(letters_, parts_of_drive) || has_part(letters_, parts_of_sum)) {
      return guessed("motor_tension");
    }
    const auto number = number_in_name(letters_);
    if (!number || number->front() == '0') {
      return unknown(
          "a tension, but of which strand? Strands are T1, T2, …; the motor's pull is "
          "motor_tension");
    }
    if (letters_.find("finger") == std::string::npos) return guessed("T" + *number);
    const auto strand = 2 * std::stoul(number->substr(0, 3)) - 1;
    GuessedColumn column = guessed(fmt::format("T{}", strand));
    column.reason =
        fmt::format("guessed: one strand of finger {}; the other is T{}", *number, strand + 1);
    return column;
  }

  GuessedColumn in_unit_of(const std::string& meaning, Dimension dimension) const {
    if (unit_.empty() || find_unit(unit_, dimension)) return guessed(meaning);
    return unknown(fmt::format("it would be {}, but '{}' is no unit of {} ({})", meaning,
                               for_message(unit_), dimension_name(dimension),
                               unit_names(dimension)));
  }

  NameWords words_;
  std::string letters_;
  std::string unit_;
  bool is_in_force_;
};

}  // namespace

GuessedColumn guess_column(const std::string& name, const std::string& unit) {
  GuessedColumn column = ColumnGuess(name, unit).guess();
  column.name = name;
  column.has_unit = has_unit_of_force(name, unit);
  column.may_be_held = column.meaning.empty() && has_part(lower(name), parts_of_grasp);
  return column;
}

std::string unit_of_column(const std::string& name, const std::optional<CsvRow>& units,
                           std::size_t index) {
  if (const auto bracketed = words_of(name).bracketed) return *bracketed;
  if (!units) return "";
  const std::string_view cell = without_brackets(units->fields[index]);
  return is_missing(cell) ? "" : std::string(cell);
}

}  // namespace reeve::readings
