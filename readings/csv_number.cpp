#include "readings/csv_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "readings/words.hpp"

namespace reeve::readings {

bool is_missing(std::string_view text) {
  constexpr std::array words{"", "-", "--", "nan", "na", "n/a", "#n/a", "null"};
  const std::string small = lower(text);
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return small == word; });
}

double CsvNumberReader::read(std::string_view text, std::size_t line, double low, double high,
                             bool may_be_empty) {
  std::string number(text);
  // Words may have both marks, and say nothing of either.
  if (with_commas_ && text.find_first_not_of("0123456789+-eE.,") == std::string_view::npos) {
    require_one_mark(text, line);
    std::replace(number.begin(), number.end(), ',', '.');
  }
  const char* begin = number.data() + (number.starts_with('+') ? 1 : 0);
  const char* end = number.data() + number.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  const bool is_number = error == std::errc{} && stop == end && std::isfinite(value) &&
                         !(*begin == '-' && begin != number.data());
  if (is_number && value >= low && value <= high) return value;
  if (std::isinf(high) && std::isinf(low)) {
    throw InputError({.expected = "a finite number such as 12.5, or an empty cell"});
  }
  throw InputError({.expected = fmt::format("a number from {} to {}{}", low, high,
                                            may_be_empty ? ", or an empty cell" : "")});
}

void CsvNumberReader::require_one_mark(std::string_view text, std::size_t line) {
  const bool comma = text.find(',') != std::string_view::npos;
  const bool point = text.find('.') != std::string_view::npos;
  if (comma && comma_line_ == 0) comma_line_ = line;
  if (point && point_line_ == 0) point_line_ = line;
  if (comma_line_ == 0 || point_line_ == 0 || !(comma || point)) return;
  throw InputError(
      {.what = fmt::format("the file has decimal commas (line {}) and decimal points (line {})",
                           comma_line_, point_line_),
       .expected = "one of them throughout"});
}

}  // namespace reeve::readings
