// Common parts of the module. Values cross as they are. Subcommands are called as the command line
// would call them (cli/api.hpp), so that names, defaults and complaints are the program's.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/hardware_file.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"

namespace reeve::python {

// Code above the floors of numerics/floors.hpp looks at all of them.
using namespace cli;

namespace py = pybind11;

// With what every use of it needs.
struct BoundRouting {
  explicit BoundRouting(const std::string& text);

  Routing routing;
  Network network;
  std::string word;
  std::string identity;  // equal for two words of the same routing
};

struct BoundHardware {
  explicit BoundHardware(HardwareFile given);

  HardwareFile file;
  MechanicsBuilder builder;
};

const Catalogue& the_catalogue();

// Contacts that the hardware names must be there.
void require_contacts(const BoundHardware& hardware, const std::vector<Routing>& routings);

void bind_errors(py::module_& module);
void bind_routing(py::module_& module);
void bind_hardware(py::module_& module);
void bind_tensions(py::module_& module);
void bind_table(py::module_& module);
void bind_commands(py::module_& module);

}  // namespace reeve::python
