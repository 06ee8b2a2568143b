// Two ways in which there is no answer.
#pragma once

#include <stdexcept>

#include "numerics/floors.hpp"

namespace reeve::core {

// What the user got wrong: found where input is read. One message that names the place, the value
// and what was expected; the command line turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What is well said but has no answer: tensions that no number can hold, exponents beyond any
// contact. Who only tries a model asks for a status instead (TensionState::in_range,
// try_forecast). The same exit code, since other input is all that helps.
class OutOfRange : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace reeve::core
