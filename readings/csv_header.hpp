// Finds the header of a CSV file, which may stand below titles.
//
// A logger may write lines above the header: the name of a measurement, its date. The header is the
// first row without a number that has as many fields as most of the rows of numbers below it. Where
// a few rows of numbers and then another such row with more of them follow, as behind the titles
// that LabVIEW writes for each channel, it is that one. A file without such a row begins with its
// header.
#pragma once

#include <cstddef>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::readings {

// Characters of one row, outside quotes.
struct SeparatorCounts {
  std::size_t commas = 0;
  std::size_t semicolons = 0;
  std::size_t tabs = 0;

  bool is_ambiguous() const { return commas > 0 && semicolons > 0; }
  // Semicolons, else commas, else tabs.
  char separator() const;
};

// Returns the row that begins there, up to its line feed. A quoted field may have line ends.
std::string_view csv_row_at(std::string_view text, std::size_t begin);
std::string_view without_carriage_return(std::string_view row);

SeparatorCounts separators_of(std::string_view row);

// Returns the place of the header, at or behind `begin`.
std::size_t header_begin(std::string_view text, std::size_t begin);

}  // namespace reeve::readings
