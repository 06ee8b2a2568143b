#include "core/error.hpp"

#include <new>
#include <utility>

namespace reeve::core {
namespace {

std::string thing(const InputFault& fault) {
  if (!fault.value) return fault.what;
  if (fault.form == InputForm::equals) return fault.what + " = " + *fault.value;
  std::string quoted = "'" + *fault.value + "'";
  if (fault.what.empty()) return quoted;
  return fault.what + (fault.form == InputForm::cell ? " = " : " ") + quoted;
}

std::string placed(const std::optional<std::string>& place, const std::string& text) {
  return place ? *place + ": " + text : text;
}

}  // namespace

void require_memory(const std::error_code& error) {
  if (error == std::errc::not_enough_memory) throw std::bad_alloc();
}

std::string sentence(const InputFault& fault) {
  std::string text = thing(fault);
  if (!fault.expected.empty()) {
    if (!text.empty()) text += fault.form == InputForm::unknown ? "; " : ": ";
    text += "expected " + fault.expected;
  }
  text = placed(fault.where, text);
  if (!fault.parts.empty()) text += ':';
  for (const InputFault& part : fault.parts) text += "\n  " + sentence(part);
  return text;
}

InputFault changed(InputFault fault, std::string (*change)(std::string)) {
  if (fault.where) fault.where = change(*fault.where);
  fault.what = change(fault.what);
  if (fault.value) fault.value = change(*fault.value);
  fault.expected = change(fault.expected);
  for (InputFault& part : fault.parts) part = changed(std::move(part), change);
  return fault;
}

InputError::InputError(InputFault fault)
    : std::runtime_error(sentence(fault)),
      fault_(std::make_shared<const InputFault>(std::move(fault))) {}

InputError InputError::at(const std::string& place) const {
  InputFault fault = *fault_;
  fault.where = fault.where ? placed(place, *fault.where) : place;
  return InputError(std::move(fault));
}

InputError InputError::at(const InputFault& thing) const {
  if (fault_->where || !fault_->what.empty() || fault_->value) return at(sentence(thing));
  InputFault known = thing;
  known.expected = fault_->expected;
  return InputError(std::move(known));
}

InputError InputError::begun_with(const std::string& start) const {
  InputFault begun = *fault_;
  (begun.where ? *begun.where : begun.what).insert(0, start);
  return InputError(std::move(begun));
}

}  // namespace reeve::core
