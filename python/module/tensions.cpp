#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/graph.hpp"
#include "core/motor_sides.hpp"
#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "python/module/arguments.hpp"
#include "python/module/bindings.hpp"

namespace reeve::python {
namespace {

// Tensions of one routing in one grasp.
struct BoundTensions {
  std::shared_ptr<const BoundRouting> routing;
  Grasp grasp;
  Direction direction = Direction::pull;
  TensionState state;
};

py::array_t<double> array(const std::vector<double>& values) {
  py::array_t<double> result(static_cast<py::ssize_t>(values.size()), values.data());
  result.attr("flags").attr("writeable") = false;
  return result;
}

const py::object& numpy_float() {
  // Never destroyed: the interpreter may be gone by then.
  static const auto* type = new py::object(py::module_::import("numpy").attr("float64"));
  return *type;
}

BoundTensions solve(const std::shared_ptr<BoundRouting>& routing, const py::object& hardware,
                    const py::object& held, const py::object& direction) {
  // Keep their memory from call to call.
  thread_local Mechanics mechanics;
  thread_local TensionSolver solver;
  const auto used = hardware_from(hardware);
  require_contacts(*used, {routing->routing});
  used->builder.apply(routing->network, mechanics);
  used->builder.require_in_range(routing->network, mechanics);
  BoundTensions result{routing,
                       grasp_from(held, routing->network.fingers, carriage_count(routing->routing),
                                  motor_ends(routing->network)),
                       direction_from(direction),
                       {}};
  solver.solve(routing->network, mechanics, result.grasp, result.direction, result.state);
  if (!result.state.in_range) {
    require_actuated(routing->network, routing->word);
    require_in_range(result.state, result.grasp);
  }
  return result;
}

std::size_t place(const BoundTensions& self, const std::string& name) {
  const auto segment = segment_named(name);
  const auto at = segment ? find_segment(self.routing->network, *segment) : std::nullopt;
  if (!at) throw py::key_error(name);
  return *at;
}

py::list names(const BoundTensions& self) {
  py::list result;
  for (const Segment& segment : self.routing->network.segments) {
    result.append(segment_name(segment));
  }
  return result;
}

std::string named(const BoundTensions& self) {
  std::string text = "Tensions(" + self.routing->word + ", held " + to_text(self.grasp);
  if (self.direction == Direction::release) text += ", release";
  return text + ")";
}

Performance performed(const BoundTensions& self) {
  return performance(self.routing->network, self.state, self.direction);
}

}  // namespace

void bind_tensions(py::module_& module) {
  py::class_<BoundTensions>(module, "Tensions", R"(
Tensions of a routing in one grasp: a mapping from segments to N per N of motor
tension.
)")
      .def("__getitem__",
           [](const BoundTensions& self, const std::string& name) {
             return numpy_float()(self.state.tension[place(self, name)]);
           })
      .def("__len__", [](const BoundTensions& self) { return self.state.tension.size(); })
      .def("__iter__", [](const BoundTensions& self) { return py::iter(names(self)); })
      .def("__repr__", &named)
      .def_property_readonly(
          "array", [](const BoundTensions& self) { return array(self.state.tension); },
          "ndarray of shape (segments,): N per N of motor tension.")
      .def_property_readonly(
          "slip", [](const BoundTensions& self) { return array(self.state.slip); },
          "ndarray of shape (contacts,): left to right, per unit of carriage travel.")
      .def_property_readonly(
          "closing", [](const BoundTensions& self) { return array(self.state.closing); },
          "ndarray of shape (fingers,): tendon that each finger takes, per unit of carriage travel.")
      .def_property_readonly(
          "jams", [](const BoundTensions& self) { return self.state.jams; },
          "bool: Whether no finger of some tendon can move.")
      .def_property_readonly(
          "uniformity", [](const BoundTensions& self) { return performed(self).uniformity; },
          "float: Least over greatest strand tension.")
      .def_property_readonly(
          "efficiency", [](const BoundTensions& self) { return performed(self).efficiency; },
          "float: Work of the strands over work of the motor.")
      .def_property_readonly(
          "force_transmission",
          [](const BoundTensions& self) { return performed(self).force_transmission; },
          "float: Sum of the strand tensions over the motor tension.");

  // A method of the routing; it stands here with what it returns.
  const auto routing =
      py::class_<BoundRouting, std::shared_ptr<BoundRouting>>(module.attr("Routing"));
  py::class_<BoundRouting, std::shared_ptr<BoundRouting>>(routing).def(
      "_tensions", &solve, py::arg("hardware"), py::arg("held"), py::arg("direction"));
}

}  // namespace reeve::python
