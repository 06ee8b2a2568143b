// Numbers in the fields of a CSV file: decimal points, or decimal commas where the separator is no
// comma. A file that has both is refused: 1,234 may then be a thousand or one and a bit.
#pragma once

#include <cstddef>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

// NaN, NA, n/a, - and what else stands for a number that is not there, or nothing at all.
bool is_missing(std::string_view text);

class CsvNumberReader {
 public:
  explicit CsvNumberReader(char separator) : with_commas_(separator != ',') {}

  // A finite number from low to high. Throws InputError that says what was expected, and whether
  // the cell might be empty instead; the place is the caller's to name.
  double read(std::string_view text, std::size_t line, double low, double high,
              bool may_be_empty = true);

 private:
  void require_one_mark(std::string_view text, std::size_t line);

  bool with_commas_;
  std::size_t comma_line_ = 0;  // first line with a decimal comma
  std::size_t point_line_ = 0;
};

}  // namespace reeve::readings
