#include <pybind11/stl.h>

#include "catalog/catalogue.hpp"
#include "cli/api.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "core/performance.hpp"
#include "python/module/arguments.hpp"
#include "python/module/bindings.hpp"
#include "reports/mujoco/mjcf.hpp"
#include "reports/show_report.hpp"

namespace reeve::python {
namespace {

std::string canonical_word(const BoundRouting& bound) {
  return to_word(canonical(bound.routing, FingerIdentity::identical));
}

py::dict part_counts(const BoundRouting& bound) {
  using py::literals::operator""_a;
  const PartCount count = parts(bound.network);
  return py::dict("sheaths"_a = count.sheaths, "pulleys"_a = count.pulleys, "knots"_a = count.knots,
                  "blocks"_a = count.blocks, "bars"_a = count.bars, "anchors"_a = count.anchors);
}

std::string drawn(const BoundRouting& bound) {
  return show_svg(cli::api::show({bound.word}), nullptr);
}

std::vector<std::string> segment_names(const BoundRouting& bound) {
  std::vector<std::string> names;
  for (const Segment& segment : bound.network.segments) names.push_back(segment_name(segment));
  return names;
}

std::string exported(const BoundRouting& routing, const py::object& hardware) {
  const auto used = hardware_from(hardware);
  require_contacts(*used, {routing.routing});
  cli::require_known_fingers(used->file.hardware, routing.network.fingers);
  const std::string source = hardware.is_none() ? cli::default_hardware_name : "";
  return mjcf(routing.routing, used->file.hardware,
              {name_of(the_catalogue(), routing.routing), source});
}

BoundRouting bound(const py::object& word) {
  if (py::isinstance<BoundRouting>(word)) return word.cast<const BoundRouting&>();
  return BoundRouting(
      text_from(word, "word", "a word such as 'M-1-T-2-F', or a name of the catalogue"));
}

}  // namespace

BoundRouting::BoundRouting(const std::string& text)
    : routing(cli::read_routing(text, the_catalogue())),
      network(expand(routing)),
      word(to_word(routing)),
      identity(to_word(canonical(routing, FingerIdentity::distinct))) {}

const Catalogue& the_catalogue() {
  static const Catalogue catalogue = cli::shipped_catalogue();
  return catalogue;
}

void require_contacts(const BoundHardware& hardware, const std::vector<Routing>& routings) {
  const Hardware& given = hardware.file.hardware;
  if (given.contacts.empty() && given.spools.empty() && given.tendon.own.empty()) return;
  cli::require_hardware_to_fit(given, routings);
  Hardware of_contacts = given;
  of_contacts.fingers.clear();  // A hand's fingers may have more parts than a routing touches.
  cli::require_values_to_act(of_contacts, routings);
}

void bind_routing(py::module_& module) {
  py::class_<BoundRouting, std::shared_ptr<BoundRouting>>(module, "Routing", R"(
A routing: how one motor's tendons are led through the fingers of a hand.

Parameters
----------
word : str
    The walk of the tendons, such as ``"1-P-2-P-1"``, or a name of the
    catalogue, such as ``"TR7"``.

Notes
-----
Two routings are equal if they differ only in how they are written: backwards,
from another finger of a loop, with a finger's strands swapped, or with the
tendons in another order.

Examples
--------
>>> import reeve
>>> reeve.Routing("TR7")
Routing('1-P-2-P-1')
>>> reeve.Routing("M-1-T-2-F") == reeve.Routing("F-2-T-1-M")
True
)")
      .def(py::init(&bound), py::arg("word"))
      .def_readonly("word", &BoundRouting::word, "str: The word as it was written.")
      .def_property_readonly("canonical", &canonical_word,
                             "str: The one word of this routing, where fingers are alike.")
      .def_property_readonly(
          "name", [](const BoundRouting& self) { return name_of(the_catalogue(), self.routing); },
          "str: Its name in the catalogue; empty if it has none.")
      .def_property_readonly(
          "fingers", [](const BoundRouting& self) { return self.network.fingers; },
          "int: How many fingers it pulls.")
      .def_property_readonly("parts", &part_counts,
                             "dict: How many sheaths, pulleys, knots, … it needs.")
      .def_property_readonly("segments", &segment_names,
                             "list of str: The segments of its tendons: T1, a, h1.")
      .def("__eq__",
           [](const BoundRouting& self, const py::object& other) -> py::object {
             if (!py::isinstance<BoundRouting>(other)) {
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             }
             return py::bool_(self.identity == other.cast<const BoundRouting&>().identity);
           })
      .def("__hash__", [](const BoundRouting& self) { return py::hash(py::str(self.identity)); })
      .def("__repr__", [](const BoundRouting& self) { return "Routing('" + self.word + "')"; })
      .def("__str__", [](const BoundRouting& self) { return self.word; })
      .def("_repr_svg_", &drawn)
      .def("_to_mjcf", &exported, py::arg("hardware"))
      .def(py::pickle([](const BoundRouting& self) { return self.word; },
                      [](const std::string& word) { return BoundRouting(word); }));
}

}  // namespace reeve::python
