// What the user got wrong. One message that names the place, the value and what was expected;
// the command line turns it into exit code 2.
#pragma once

#include <stdexcept>

namespace reeve {

class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace reeve
