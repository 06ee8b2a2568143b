// Guesses what the columns of a logger's file mean (readings/guessed_column.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "readings/csv.hpp"
#include "readings/guessed_column.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

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
