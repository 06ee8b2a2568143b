// Details of a design that the page shows when it is pointed at or selected: schematic, tensions
// and contacts in each grasp, for as many designs as a number of bytes holds.
//
// The schematics of one design in several grasps, and those of designs alike, have most of their
// lines in common: a chunk of designs holds each line once, and is compressed.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/routing.hpp"
#include "reports/output/json.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {

// A design, solved in each grasp of the exploration. Asked by many threads at once.
using SolveDesign = std::function<SolvedRouting(const Routing& routing)>;

struct DetailedDesigns {
  std::vector<const Routing*> whole;  // with a schematic of each grasp
  std::vector<const Routing*> brief;  // with that of the first alone; they come after the others
};

struct DesignDetails {
  // [{"words", "pack"}]; a pack has [{"segments", "strands", "grasps", "contacts"}], a design each,
  // in its first line, and the lines of their schematics in the others.
  Json chunks = Json::array();
  std::size_t designs = 0;  // whole ones
  std::size_t brief = 0;
  std::size_t bytes = 0;
};

// In this order, until all are in or `bytes` would be exceeded; the same for any number of threads.
DesignDetails design_details(const DetailedDesigns& designs, const SolveDesign& solve,
                             std::size_t bytes, int threads);

// Title and grasp above it; no legend.
std::string grasp_svg(const SolvedRouting& report, std::size_t grasp, const std::string& ids);

}  // namespace reeve::pages
