// Guesses what the columns of a logger's file mean if their names are not reeve's. The guess uses
// common words, English and German, the numbers beside them and their units. It is proposed to the
// user and never taken unasked.
//
//   Zeit [s]            time              Kraft 1 [N]        T1
//   Weg [mm]            position          Motorkraft [N]     motor_tension
//   Geschw. [mm/s]      speed             Motorstrom [A]     nothing: a current is no tension
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "readings/csv.hpp"
#include "readings/reading_options.hpp"

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
  std::string reason;  // reason against its apparent meaning; usually ""
};

struct LogGuess {
  char separator = ',';
  std::vector<CsvComment> titles;                    // lines above the header
  std::vector<GuessedColumn> columns;                // named columns, in the order of the file
  std::vector<std::vector<std::string>> first_rows;  // cells of these columns, as written

  // The map has the meanings that the user gave, and those that are guessed.
  std::vector<ColumnMeaning> map;

  bool has(const std::string& meaning) const;
};

// Throws InputError where the file has no rows of fields.
LogGuess guess_columns(const std::filesystem::path& path, const ReadingOptions& options);

}  // namespace reeve::readings
