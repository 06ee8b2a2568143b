// The message of the error that a call throws, for tests that compare it word by word.
#pragma once

#include <string>

#include "core/error.hpp"

namespace reeve::testing {

template <typename Error, typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error was thrown";
}

template <typename Call>
std::string input_error(const Call& call) {
  return message_of<InputError>(call);
}

// The parts of the error, "where | what | value | expected"; a dash for one that is missing.
template <typename Call>
std::string input_fault(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    const InputFault& fault = error.fault();
    return fault.where.value_or("-") + " | " + fault.what + " | " + fault.value.value_or("-") +
           " | " + fault.expected;
  }
  return "no such error was thrown";
}

template <typename Call>
std::string out_of_range(const Call& call) {
  return message_of<OutOfRange>(call);
}

}  // namespace reeve::testing
