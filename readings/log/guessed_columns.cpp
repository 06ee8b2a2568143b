#include "readings/log/guessed_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "readings/columns.hpp"
#include "readings/csv.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t shown_rows = 5;

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
    Hint{"versuch", "run"},        Hint{"messung", "run"},
    Hint{"trial", "run"},          Hint{"seilführung", "routing"},
    Hint{"gehalten", "held"},      Hint{"blockiert", "held"},
    Hint{"richtung", "direction"}, Hint{"zyklus", "cycle"},
    Hint{"zyklen", "cycle"},       Hint{"temperatur", "temperature"},
    Hint{"temp", "temperature"},
};

constexpr std::array<std::string_view, 9> parts_of_force{
    "kraft", "force", "tension", "seilzug", "zugkraft", "load", "last", "wägezelle", "fz"};
constexpr std::array<std::string_view, 7> parts_of_motor{
    "motor", "antrieb", "aktor", "actuator", "gesamt", "total", "schlitten"};

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

class ColumnGuess {
 public:
  // `unit` is as the name or the row of units has it, or "".
  ColumnGuess(const std::string& name, std::string unit)
      : words_(words_of(name)),
        letters_(joined(words_, words_.words.size())),
        unit_(std::move(unit)) {}

  GuessedColumn guess() const {
    if (const std::string reason = no_tension(); !reason.empty()) return unknown(reason);
    if (has_part(letters_, parts_of_force)) return tension();
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
    if (has_part(letters_, parts_of_motor)) return guessed("motor_tension");
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
};

// A row of units below names that are still unknown.
bool has_units_alone(const CsvRow& row) {
  bool any = false;
  for (const std::string& field : row.fields) {
    const std::string_view cell = without_brackets(field);
    if (cell.find_first_of("0123456789+-") == 0) return false;
    any = any || is_unit(cell);
  }
  return any;
}

std::string unit_of_column(const std::string& name, const std::optional<CsvRow>& units,
                           std::size_t index) {
  if (const auto bracketed = words_of(name).bracketed) return *bracketed;
  if (!units) return "";
  const std::string_view cell = without_brackets(units->fields[index]);
  return is_missing(cell) ? "" : std::string(cell);
}

// Returns nothing for a column that reeve takes for a covariate.
std::optional<std::string> known_meaning(const std::string& name, const std::string& unit,
                                         const ReadingOptions& options) {
  const auto named = try_column_named(meaning_of(name, options));
  if (!named || (named->needs_unit && !named->unit && !find_unit(unit, Dimension::force))) {
    return std::nullopt;
  }
  return plain_name(*named);
}

// Returns the meaning without its unit: "motor_tension" of "motor_tension_N", which "motor_tension"
// means too.
std::string without_unit(const std::string& meaning) {
  for (const std::string_view unit : {"_mm_s", "_mm", "_N", "_s", "_C", "_rad"}) {
    if (meaning.ends_with(unit)) return meaning.substr(0, meaning.size() - unit.size());
  }
  return meaning;
}

GuessedColumn column_of(const std::string& name, const std::string& unit,
                        const ReadingOptions& options) {
  if (const auto known = known_meaning(name, unit, options)) {
    return {name, without_unit(*known), GuessKind::known, ""};
  }
  GuessedColumn column = ColumnGuess(name, unit).guess();
  column.name = name;
  return column;
}

// Two columns of one meaning: one that is known goes before a guess, the first before the others.
void part_equals(std::vector<GuessedColumn>& columns) {
  for (GuessedColumn& column : columns) {
    if (column.kind != GuessKind::guessed) continue;
    for (const GuessedColumn& other : columns) {
      const bool goes_before = other.kind == GuessKind::known || &other < &column;
      if (&other == &column || other.meaning != column.meaning || !goes_before) continue;
      column = {
          column.name, "", GuessKind::unknown,
          fmt::format("it would be {}, and so is '{}'", column.meaning, for_message(other.name))};
      break;
    }
  }
}

}  // namespace

bool LogGuess::has(const std::string& meaning) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const GuessedColumn& column) { return column.meaning == meaning; });
}

LogGuess guess_columns(const std::filesystem::path& path, const ReadingOptions& options) {
  CsvReader csv = CsvReader::open(path);
  LogGuess result;
  result.separator = csv.separator();
  result.titles = csv.titles();
  FaultList faults;
  Beginning beginning = read_beginning(csv, options, faults);
  if (beginning.first && has_units_alone(*beginning.first)) {
    beginning.units = std::exchange(beginning.first, std::nullopt);
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < csv.header().fields.size(); ++i) {
    const std::string name(trimmed(csv.header().fields[i]));
    if (name.empty()) continue;
    places.push_back(i);
    result.columns.push_back(column_of(name, unit_of_column(name, beginning.units, i), options));
  }
  part_equals(result.columns);
  result.map = options.map;
  for (const GuessedColumn& column : result.columns) {
    if (column.kind == GuessKind::guessed) result.map.push_back({column.name, column.meaning});
  }
  CsvRow row;
  const auto keep = [&](const CsvRow& shown) {
    result.first_rows.emplace_back();
    for (const std::size_t place : places) result.first_rows.back().push_back(shown.fields[place]);
  };
  if (beginning.first) keep(*beginning.first);
  while (!beginning.is_broken && result.first_rows.size() < shown_rows && csv.next(row)) keep(row);
  return result;
}

}  // namespace reeve::readings
