#include <fmt/format.h>
#include <pybind11/stl.h>

#include "catalog/rig/hardware_tables.hpp"
#include "core/error.hpp"
#include "python/module/bindings.hpp"

namespace reeve::python {
namespace {

// The law that is set and read under a name.
ContactLaw& law(Hardware& hardware, const std::string& kind) {
  if (kind == "tube") return hardware.tube;
  if (kind == "bearing") return hardware.bearing;
  if (kind == "sheath") return hardware.sheath;
  if (!hardware.block) hardware.block = hardware.bearing;
  return *hardware.block;
}

struct Field {
  const char* name;
  double& (*of)(Hardware&);
  const char* meaning;
};

constexpr Field fields[] = {
    {"tube_mu", [](Hardware& h) -> double& { return law(h, "tube").mu; },
     "Friction coefficient of the tubes."},
    {"tube_angle_rad", [](Hardware& h) -> double& { return law(h, "tube").angle_rad; },
     "Wrap angle of the tubes, rad."},
    {"bearing_mu", [](Hardware& h) -> double& { return law(h, "bearing").mu; },
     "Friction coefficient of the bearings."},
    {"bearing_angle_rad", [](Hardware& h) -> double& { return law(h, "bearing").angle_rad; },
     "Wrap angle of the bearings, rad."},
    {"sheath_mu", [](Hardware& h) -> double& { return law(h, "sheath").mu; },
     "Friction coefficient of the sheaths."},
    {"sheath_angle_rad", [](Hardware& h) -> double& { return law(h, "sheath").angle_rad; },
     "The sum of a sheath's bends, rad."},
    {"block_mu", [](Hardware& h) -> double& { return law(h, "block").mu; },
     "Friction coefficient of a floating block's sheave; the bearings' unless it is given."},
    {"block_angle_rad", [](Hardware& h) -> double& { return law(h, "block").angle_rad; },
     "Wrap angle of a floating block's sheave, rad."},
    {"strand_mm", [](Hardware& h) -> double& { return h.strand_mm; },
     "Length of a strand along a finger, mm."},
    {"motor_side_mm", [](Hardware& h) -> double& { return h.motor_side_mm; },
     "Length between a sheath and the carriage, mm."},
    {"hand_mm", [](Hardware& h) -> double& { return h.hand_mm; },
     "Length between two joins at the hand, mm."},
};

const Field* find_field(const std::string& name) {
  for (const Field& field : fields) {
    if (name == field.name) return &field;
  }
  return nullptr;
}

// mu_tube is tube_mu.
std::string as_in_the_files(const std::string& name) {
  return name.starts_with("mu_") ? name.substr(3) + "_mu" : name;
}

HardwareFile with(HardwareFile file, const py::kwargs& changes) {
  for (const auto& [key, value] : changes) {
    const auto given = key.cast<std::string>();
    const Field* field = find_field(as_in_the_files(given));
    if (field == nullptr) {
      std::string known;
      for (const Field& one : fields) known += (known.empty() ? "" : ", ") + std::string(one.name);
      throw py::type_error(fmt::format("Hardware has no '{}': expected one of {}", given, known));
    }
    field->of(file.hardware) = value.cast<double>();
  }
  return file;
}

std::string toml(const BoundHardware& self) {
  return catalog::hardware_toml(self.file.hardware, self.file.uncertainty, self.file.vary);
}

// What differs from the paper's, as it could be given.
std::string described(const BoundHardware& self) {
  Hardware own = self.file.hardware;
  Hardware paper;
  std::string text;
  for (const Field& field : fields) {
    const bool is_plain = std::string_view(field.name).starts_with("block") && !own.block;
    if (is_plain || field.of(own) == field.of(paper)) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", field.name, field.of(own));
  }
  if (!own.fingers.empty()) text += fmt::format("{}…", text.empty() ? "" : ", ");
  return "Hardware(" + text + ")";
}

BoundHardware from_text(const std::string& text, const std::string& name) {
  return BoundHardware(catalog::parse_hardware_file(text, name));
}

}  // namespace

BoundHardware::BoundHardware(HardwareFile given) : file(std::move(given)), builder(file.hardware) {}

std::shared_ptr<const BoundHardware> hardware_or_paper(std::shared_ptr<BoundHardware> hardware) {
  static const auto paper = std::make_shared<const BoundHardware>(HardwareFile{});
  return hardware ? hardware : paper;
}

void bind_hardware(py::module_& module) {
  py::class_<BoundHardware, std::shared_ptr<BoundHardware>> hardware(module, "Hardware", R"(
Friction and lengths of the parts that a tendon runs through. Immutable.

Parameters
----------
**coefficients : float
    ``tube_mu``, ``bearing_mu``, ``sheath_mu``, ``block_mu`` (friction
    coefficients; ``mu_tube`` is ``tube_mu``), ``tube_angle_rad``, …
    (wrap angles, rad), ``strand_mm``, ``motor_side_mm``, ``hand_mm`` (lengths,
    mm). What is not given is the paper's.

Notes
-----
What is different at one finger or one contact, the joints of a hand and its
motor stand in a file: see `from_toml`.

Examples
--------
>>> import reeve
>>> reeve.Hardware(tube_mu=0.09).replace(sheath_mu=0.05)
Hardware(tube_mu=0.09, sheath_mu=0.05)
)");
  hardware.def(py::init(
      [](const py::kwargs& coefficients) { return BoundHardware(with({}, coefficients)); }));
  for (const Field& field : fields) {
    hardware.def_property_readonly(
        field.name,
        [&field](const BoundHardware& self) {
          Hardware own = self.file.hardware;
          return field.of(own);
        },
        (std::string("float: ") + field.meaning).c_str());
  }
  hardware
      .def_static(
          "from_toml",
          [](const py::object& path) {
            return BoundHardware(catalog::read_hardware_file(py::str(path).cast<std::string>()));
          },
          py::arg("path"), "The hardware of a file, as the program reads it.")
      .def("to_toml", &toml, "str: A hardware file that reads back as this one.")
      .def(
          "replace",
          [](const BoundHardware& self, const py::kwargs& changes) {
            return BoundHardware(with(self.file, changes));
          },
          "The same hardware, but for the coefficients that are given.")
      .def("__eq__",
           [](const BoundHardware& self, const py::object& other) -> py::object {
             if (!py::isinstance<BoundHardware>(other)) {
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             }
             return py::bool_(toml(self) == toml(other.cast<const BoundHardware&>()));
           })
      .def("__hash__", [](const BoundHardware& self) { return py::hash(py::str(toml(self))); })
      .def("__repr__", &described)
      .def(py::pickle([](const BoundHardware& self) { return toml(self); },
                      [](const std::string& text) { return from_text(text, "pickle"); }));
}

}  // namespace reeve::python
