// Bad lines of the commands that most tests of bad input call.
#pragma once

#include <string>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {

inline BadLine show_tr1(Arguments options, const std::string& message) {
  options.insert(options.begin(), {"show", "TR1"});
  return {options, message, {}};
}

inline BadLine explore(Arguments options, const std::string& message) {
  options.insert(options.begin(), {"explore", "--out", "out"});
  return {options, message, {}};
}

}  // namespace reeve::testing
