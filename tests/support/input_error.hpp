// The message of the InputError that a call throws, for tests that compare it word by word.
#pragma once

#include <string>

#include "core/error.hpp"

namespace reeve::testing {

template <typename Call>
std::string input_error(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError was thrown";
}

}  // namespace reeve::testing
