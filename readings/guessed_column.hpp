// Guesses what a column means if its name is not reeve's. The guess uses common words, English and
// German, the numbers beside them and their units. It is proposed to the user and never taken
// unasked.
//
//   Zeit [s]            time              Kraft 1 [N]        T1
//   Weg [mm]            position          Motorkraft / N     motor_tension
//   Geschw. [mm/s]      speed             Motorstrom [A]     nothing: a current is no tension
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "readings/csv.hpp"

namespace reeve::readings {

enum class GuessKind : std::uint8_t {
  known,    // known from its name, or from the user
  guessed,  // guessed; the user must confirm it
  unknown,  // a covariate
};

struct GuessedColumn {
  std::string name;     // name in the file
  std::string meaning;  // without a unit, which the name or the row of units has; "" if unknown
  GuessKind kind = GuessKind::unknown;
  std::string reason;        // reason against its apparent meaning; usually ""
  bool may_be_held = false;  // if its cells are finger numbers
  bool has_unit = false;     // its name or the row of units says one of force
};

// `unit` is as unit_of_column has it.
GuessedColumn guess_column(const std::string& name, const std::string& unit);

// Returns the unit that the name says, or the row of units at this place; "" if neither does.
std::string unit_of_column(const std::string& name, const std::optional<CsvRow>& units,
                           std::size_t index);

}  // namespace reeve::readings
