#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/error.hpp"
#include "python/module/arguments.hpp"
#include "python/module/bindings.hpp"
#include "python/module/watched.hpp"
#include "studies/tension_table.hpp"

namespace reeve::python {
namespace {

using CoefficientArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Least number of solves to watch. Fewer take no longer than a thread that watches them.
constexpr std::size_t worth_watching = 20000;

struct CoefficientName {
  const char* name;
  ContactKind kind;
  LawTerm term;
};

constexpr CoefficientName coefficients[] = {
    {"tube_mu", ContactKind::tube, LawTerm::mu},
    {"bearing_mu", ContactKind::bearing, LawTerm::mu},
    {"sheath_mu", ContactKind::sheath, LawTerm::mu},
    {"block_mu", ContactKind::block, LawTerm::mu},
    {"tube_angle_rad", ContactKind::tube, LawTerm::angle},
    {"bearing_angle_rad", ContactKind::bearing, LawTerm::angle},
    {"sheath_angle_rad", ContactKind::sheath, LawTerm::angle},
    {"block_angle_rad", ContactKind::block, LawTerm::angle},
};

CoefficientColumn column(const std::string& name, const CoefficientArray& values) {
  const std::string filed = name.starts_with("mu_") ? name.substr(3) + "_mu" : name;
  for (const CoefficientName& known : coefficients) {
    if (filed != known.name) continue;
    return {name, known.kind, known.term, {values.data(), static_cast<std::size_t>(values.size())}};
  }
  std::string names;
  for (const CoefficientName& known : coefficients) {
    names += (names.empty() ? "" : ", ") + std::string(known.name);
  }
  throw py::type_error("no coefficient '" + name + "': expected one of " + names);
}

std::vector<std::string> segment_names(const std::vector<Routing>& routings) {
  std::vector<std::string> names;
  for (const Segment& segment : table_segments(routings)) names.push_back(segment_name(segment));
  return names;
}

TensionTableRequest request_of(const std::vector<std::shared_ptr<BoundRouting>>& routings,
                               const BoundHardware& hardware, const py::list& held,
                               const py::object& direction,
                               const std::map<std::string, CoefficientArray>& columns,
                               int threads) {
  TensionTableRequest request;
  int fewest = max_fingers;
  for (const auto& routing : routings) {
    request.routings.push_back(routing->routing);
    fewest = std::min(fewest, routing->network.fingers);
  }
  require_contacts(hardware, request.routings);
  request.hardware = hardware.file.hardware;
  for (const py::handle& grasp : held) request.grasps.push_back(grasp_from(grasp, fewest));
  request.direction = direction_from(direction);
  for (const auto& [name, values] : columns) {
    request.columns.push_back(column(name, values));
    request.samples = static_cast<std::size_t>(values.size());
  }
  request.threads = threads;
  return request;
}

// The table, the names of its segments, and whether Ctrl-C stopped it.
py::tuple tension_table(const std::vector<std::shared_ptr<BoundRouting>>& routings,
                        const py::object& hardware, const py::list& held,
                        const py::object& direction,
                        const std::map<std::string, CoefficientArray>& columns, int threads,
                        const py::object& progress) {
  const auto used = hardware_from(hardware);
  const TensionTableRequest request =
      request_of(routings, *used, held, direction, columns, threads);
  const std::vector<std::string> segments = segment_names(request.routings);
  py::array_t<double> table(
      {request.routings.size(), request.grasps.size(), request.samples, segments.size()});
  const std::span<double> cells(table.mutable_data(), static_cast<std::size_t>(table.size()));
  const std::size_t solves = table.size() / std::max<std::size_t>(segments.size(), 1);
  bool interrupted = false;
  if (solves < worth_watching && progress.is_none()) {
    const py::gil_scoped_release release;
    fill_tension_table(request, cells);
  } else {
    interrupted = watched(progress, [&](const studies::StudySupervision& supervision) {
                    return fill_tension_table(request, cells, supervision);
                  }).second;
  }
  return py::make_tuple(table, segments, interrupted);
}

}  // namespace

void bind_table(py::module_& module) {
  module.def("tension_table", &tension_table, py::arg("routings"), py::arg("hardware"),
             py::arg("held"), py::arg("direction"), py::arg("columns"), py::arg("threads"),
             py::arg("progress"), "See reeve.tensions.");
}

}  // namespace reeve::python
