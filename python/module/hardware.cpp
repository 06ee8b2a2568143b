#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "catalog/hardware_tables.hpp"
#include "core/error.hpp"
#include "python/module/arguments.hpp"
#include "python/module/bindings.hpp"
#include "python/module/toml_values.hpp"

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

// mu_tube is tube_mu.
std::string as_in_the_files(const std::string& name) {
  return name.starts_with("mu_") ? name.substr(3) + "_mu" : name;
}

// Tables of the file that are given as mappings.
struct MappingTable {
  const char* name;
  const char* key;
  const char* meaning;
};

constexpr MappingTable tables[] = {
    {"fingers", "finger",
     "What is different at one finger, by its number: ``{2: {\"tip_mu\": 0.09}}``."},
    {"contacts", "contact",
     "What is different at one contact, by the segments beside it: "
     "``{\"a-T1\": {\"mu\": 0.2}}``."},
    {"spools", "spools",
     "Spool of an end at a motor, over that of the carriage, by its segment: ``{\"b\": 0.5}``."},
    {"tendons", "tendon",
     "Spring in series and slack of single tendons, by number, with what they stand beside: "
     "``{\"EA_N\": 2e4, 1: {\"stiffness_N_mm\": 5}}``."},
    {"hand", "hand", "Joints and force of every finger that has none of its own."},
    {"motor", "motor", "Spool, force and stroke of the motor."},
    {"uncertainty", "uncertainty", "How well the coefficients are known."},
};

template <typename Row, std::size_t count>
const Row* find(const Row (&rows)[count], const std::string& name) {
  const Row* const found = std::ranges::find(rows, name, &Row::name);
  return found == std::end(rows) ? nullptr : found;
}

[[noreturn]] void fail_unknown(const std::string& given) {
  std::string known;
  for (const Field& field : fields) known += std::string(field.name) + ", ";
  for (const MappingTable& table : tables) known += std::string(table.name) + ", ";
  known.resize(known.size() - 2);
  throw py::type_error(fmt::format("Hardware has no '{}': expected one of {}", given, known));
}

std::string file_text(const HardwareFile& file) {
  return catalog::hardware_toml(file.hardware, file.uncertainty, file.vary);
}

void put(catalog::TomlNode table, catalog::TomlNode& root) {
  std::erase_if(root.children, [&](const auto& child) { return child.key == table.key; });
  root.children.push_back(std::move(table));
}

// Nobody wrote the file, so that lines and columns in it say nothing.
HardwareFile read_without_places(const catalog::TomlNode& root) {
  try {
    return catalog::read_hardware_tables(root);
  } catch (const InputError& error) {
    core::InputFault fault = error.fault();
    static const std::regex place("^Hardware:[0-9]+:[0-9]+(: )?");
    if (fault.where) fault.where = std::regex_replace(*fault.where, place, "");
    if (fault.where && fault.where->empty()) fault.where.reset();
    throw InputError(fault);
  }
}

HardwareFile with(HardwareFile file, const py::kwargs& changes) {
  std::vector<catalog::TomlNode> changed;
  for (const auto& [key, value] : changes) {
    const auto given = key.cast<std::string>();
    if (const MappingTable* table = find(tables, given)) {
      changed.push_back(toml_from(value, given, table->key));
    } else if (const Field* field = find(fields, as_in_the_files(given))) {
      field->of(file.hardware) = number_from(value, given);
    } else {
      fail_unknown(given);
    }
  }
  if (!changes.empty()) file.hardware.origin.reset();  // It is no longer what the file says.
  if (changed.empty()) return file;
  catalog::TomlNode root = catalog::parse_toml(file_text(file), "Hardware");
  for (catalog::TomlNode& table : changed) put(std::move(table), root);
  return read_without_places(root);
}

std::string toml(const BoundHardware& self) { return file_text(self.file); }

// As it can be given again.
py::dict table_values(const BoundHardware& self, const MappingTable& table) {
  const catalog::TomlNode root = catalog::parse_toml(toml(self), "Hardware");
  const catalog::TomlNode* node = root.find(table.key);
  if (node == nullptr) return {};
  const py::dict values = value_of(*node);
  if (table.key != std::string_view("finger")) return values;
  py::dict by_number;
  for (const auto& [finger, value] : values)
    by_number[py::int_(py::reinterpret_borrow<py::object>(finger))] = value;
  return by_number;
}

// Returns the differences from the paper's hardware, as they could be given.
std::string described(const BoundHardware& self) {
  Hardware own = self.file.hardware;
  Hardware paper;
  std::string text;
  for (const Field& field : fields) {
    const bool is_plain = std::string_view(field.name).starts_with("block") && !own.block;
    if (is_plain || field.of(own) == field.of(paper)) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", field.name, field.of(own));
  }
  const BoundHardware plain{HardwareFile{}};
  for (const MappingTable& table : tables) {
    const py::dict values = table_values(self, table);
    if (values.equal(table_values(plain, table))) continue;
    text +=
        fmt::format("{}{}={}", text.empty() ? "" : ", ", table.name, std::string(py::repr(values)));
  }
  return "Hardware(" + text + ")";
}

BoundHardware from_text(const std::string& text, const std::string& name) {
  return BoundHardware(catalog::parse_hardware_file(text, name));
}

}  // namespace

BoundHardware::BoundHardware(HardwareFile given) : file(std::move(given)), builder(file.hardware) {}

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
fingers, contacts, spools, tendons, hand, motor, uncertainty : mapping
    The tables of a hardware file (catalog/hardware/example.toml), with its
    names: what is different at one finger, ``{2: {"tip_mu": 0.09}}``, or at
    one contact, ``{"a-T1": {"mu": 0.2}}``; joints and forces of a hand; its
    motor; how well the coefficients are known.

Examples
--------
>>> import reeve
>>> reeve.Hardware(tube_mu=0.09).replace(sheath_mu=0.05)
Hardware(tube_mu=0.09, sheath_mu=0.05)
>>> reeve.Hardware(fingers={2: {"tip_mu": 0.09}}).fingers[2]["tip_mu"]
0.09
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
  for (const MappingTable& table : tables) {
    hardware.def_property_readonly(
        table.name, [&table](const BoundHardware& self) { return table_values(self, table); },
        (std::string("dict: ") + table.meaning).c_str());
  }
  hardware
      .def_static(
          "from_toml",
          [](const py::object& path) {
            return BoundHardware(catalog::read_hardware_file(path_from(path, "path")));
          },
          py::arg("path"), "The hardware of a file, as the program reads it.")
      .def("to_toml", &toml, "str: A hardware file that reads back as this one.")
      .def(
          "replace",
          [](const BoundHardware& self, const py::kwargs& changes) {
            return BoundHardware(with(self.file, changes));
          },
          "The same hardware, but for what is given; a table takes the place of the whole table.")
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
