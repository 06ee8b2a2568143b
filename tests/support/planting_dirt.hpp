// Planted files as loggers and people leave them. What a reading is, stays as it was, but for
// spikes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace reeve::testing {

enum class Dirt : std::uint8_t {
  // Byte order mark, CRLF, semicolons and decimal commas, an index without a name, a row of units,
  // NaN for what is missing, a column of remarks, blank lines, separators behind the last field.
  form,
  copies,    // one row in twenty stands there twice
  unsorted,  // rows in random order
  spikes,    // one tension in a hundred reads 3 to 10 times as much
};
const char* dirt_name(Dirt dirt);
const std::vector<Dirt>& all_dirt();

// Of a file of planting.hpp: comment lines, a header, rows; no field has a quote or a comma.
std::string dirtied(const std::string& csv, Dirt dirt, std::uint64_t seed);

}  // namespace reeve::testing
