// Two ways in which there is no answer.
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// Format of the sentence about a value; `what` is InputFault::what.
enum class InputForm : std::uint8_t {
  option,   // "what 'value': expected …"
  unknown,  // "what 'value'; expected …"
  equals,   // "what = value: expected …"
  cell,     // "what = 'value': expected …"
};

// A fault of an input, in parts. A missing part is left out of the sentence. A name or value that
// the user gives may also be present and empty. If no single value is at fault, `what` is prose.
struct InputFault {
  std::optional<std::string> where = {};  // "d.csv:3", "routing 'M-1-Q', column 5"
  std::string what = {};                  // "column 'T1_N'", "--shard", "tube.mu"
  std::optional<std::string> value = {};  // printable text
  std::string expected = {};              // "a number from 0 to 10"
  InputForm form = InputForm::option;
  // All faults of one input that has several, or the first fault alone.
  std::vector<InputFault> parts = {};
};

// "where: what 'value': expected …". Each part has a line of its own below it.
std::string sentence(const InputFault& fault);

// A copy with `change` made to each part.
InputFault changed(InputFault fault, std::string (*change)(std::string));

// Throws std::bad_alloc if the system call failed for want of memory, which is no fault of an
// input.
void require_memory(const std::error_code& error);

// A mistake in the user's input. It is thrown where input is read and caught only to add a place.
// Its message is the fault's sentence; the command line turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(InputFault fault);
  // Prose. A template, since a string would take the braces of a fault for its own.
  template <std::convertible_to<std::string> Text>
  explicit InputError(const Text& prose) : InputError(InputFault{.what = prose}) {}

  const InputFault& fault() const { return *fault_; }

  // "place: " before the sentence; the parts stay, and `where` grows.
  InputError at(const std::string& place) const;
  // Before an error that says no more than what was expected: that of this thing. Before another
  // one it is a place.
  InputError at(const InputFault& thing) const;
  // `start` before the name that the sentence begins with.
  InputError begun_with(const std::string& start) const;

 private:
  std::shared_ptr<const InputFault> fault_;  // a copy of an exception must not throw
};

// A valid input without an answer: tensions that no number can hold, exponents beyond any contact.
// Code that only tries a model asks for a status instead (TensionState::in_range, try_forecast).
// The exit code is the same, since only other input helps.
class OutOfRange : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  // "place: " before the sentence.
  OutOfRange at(const std::string& place) const { return OutOfRange(place + ": " + what()); }
};

}  // namespace reeve::core
