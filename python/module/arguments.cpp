#include "python/module/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "core/error.hpp"

namespace reeve::python {
namespace {

constexpr const char* a_grasp = "the fingers that are held, such as 1, [1, 2], '1,2' or 'none'";

// Also NumPy's whole numbers, which are no int.
std::optional<int> whole_number(const py::handle& value) {
  if (PyIndex_Check(value.ptr()) == 0) return std::nullopt;
  const Py_ssize_t number = PyNumber_AsSsize_t(value.ptr(), nullptr);  // clipped, which is refused
  if (number == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();  // an array, which has an index only if it holds one number
    return std::nullopt;
  }
  constexpr Py_ssize_t most = 1000000;
  return static_cast<int>(std::clamp(number, -most, most));
}

std::vector<int> fingers_from(const py::handle& held) {
  if (const auto finger = whole_number(held)) return {*finger};
  std::vector<int> fingers;
  if (!py::isinstance<py::iterable>(held)) throw wrong_type("held", a_grasp, held);
  for (const py::handle& item : held) {
    const auto finger = whole_number(item);
    if (!finger) throw wrong_type("held", a_grasp, held);
    fingers.push_back(*finger);
  }
  return fingers;
}

}  // namespace

py::type_error wrong_type(const std::string& name, const std::string& expected,
                          const py::handle& value) {
  constexpr std::size_t longest = 60;
  std::string shown = py::repr(value);
  if (shown.size() > longest) shown = py::str(py::type::handle_of(value).attr("__name__"));
  return py::type_error(fmt::format("{}: expected {}, not {}", name, expected, shown));
}

double number_from(const py::handle& value, const std::string& name) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw wrong_type(name, "a number", value);
  }
  return number;
}

std::string text_from(const py::handle& value, const std::string& name,
                      const std::string& expected) {
  if (!py::isinstance<py::str>(value)) throw wrong_type(name, expected, value);
  return value.cast<std::string>();
}

std::string path_from(const py::handle& value, const std::string& name) {
  if (!py::isinstance<py::str>(value) && !py::hasattr(value, "__fspath__")) {
    throw wrong_type(name, "a path", value);
  }
  return py::str(py::module_::import("os").attr("fspath")(value));
}

std::shared_ptr<const BoundHardware> hardware_from(const py::handle& value) {
  static const auto paper = std::make_shared<const BoundHardware>(HardwareFile{});
  if (value.is_none()) return paper;
  if (!py::isinstance<BoundHardware>(value)) {
    throw wrong_type("hardware", "a reeve.Hardware or None", value);
  }
  return value.cast<std::shared_ptr<BoundHardware>>();
}

Grasp grasp_from(const py::handle& held, int fingers, int motors, const MotorEnds& ends) {
  if (py::isinstance<py::str>(held)) {
    return parse_grasp(held.cast<std::string>(), fingers, motors, ends);
  }
  std::string text;
  Grasp grasp;
  for (const int finger : fingers_from(held)) {
    text += (text.empty() ? "" : ",") + std::to_string(finger);
    if (finger >= 1 && finger <= fingers) grasp.held |= std::uint64_t{1} << (finger - 1);
  }
  // It knows what is wrong with the others.
  return text.empty() ? grasp : parse_grasp(text, fingers);
}

Direction direction_from(const py::handle& value) {
  const std::string text = text_from(value, "direction", "'pull' or 'release'");
  if (text == "pull") return Direction::pull;
  if (text == "release") return Direction::release;
  throw InputError({.what = "direction", .value = text, .expected = "pull or release"});
}

}  // namespace reeve::python
