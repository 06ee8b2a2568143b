// Arguments from Python, as values; any other type is a TypeError that names the argument.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "python/module/bindings.hpp"

namespace reeve::python {

// "held: expected the fingers that are held, not 1.5"
[[nodiscard]] py::type_error wrong_type(const std::string& name, const std::string& expected,
                                        const py::handle& value);

double number_from(const py::handle& value, const std::string& name);
std::string text_from(const py::handle& value, const std::string& name,
                      const std::string& expected);
std::string path_from(const py::handle& value, const std::string& name);

// None: the paper's.
std::shared_ptr<const BoundHardware> hardware_from(const py::handle& value);

// Fingers as numbers, one number, or text as on the command line.
Grasp grasp_from(const py::handle& held, int fingers, int motors = 1, const MotorEnds& ends = {});
Direction direction_from(const py::handle& value);

}  // namespace reeve::python
