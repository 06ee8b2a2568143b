#include "core/version.hpp"
#include "python/module/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace reeve::python;
  module.doc() = "The library of reeve; the package reeve gives it its shape.";
  const auto build = reeve::core::version();
  module.attr("__version__") = build.number;
  module.attr("__commit__") = build.commit;
  bind_errors(module);
  bind_hardware(module);
  bind_routing(module);
  bind_tensions(module);
  bind_table(module);
  bind_commands(module);
}
