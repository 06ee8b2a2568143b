// Properties of the terminal that the program writes to.
#pragma once

#include <cstddef>

#include "numerics/floors.hpp"

namespace reeve::cli {

struct Terminal {
  bool is_one = false;       // otherwise a file, a pipe, …: no limits and no codes
  bool obeys_codes = false;  // moves its cursor, wipes lines, shows colour
  bool colour = false;       // also wanted: NO_COLOR is not set (https://no-color.org)
  std::size_t width = 0;     // in columns
};

// Returns the properties of stdout or stderr.
Terminal terminal(int descriptor);

}  // namespace reeve::cli
