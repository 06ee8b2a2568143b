// A logged series from the text of a CSV file.
#pragma once

#include <string>

#include "readings/log/logged_series.hpp"
#include "readings/log/recordings.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {

inline LoggedSeries log_of(const std::string& text) { return parse_logged_series(text, "log.csv"); }

// Its clock is asked, too.
inline std::string log_error(const std::string& text) {
  return input_error([&] { recordings(log_of(text)); });
}

}  // namespace reeve::testing
