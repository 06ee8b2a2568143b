// Strand tensions as bars, one panel beside the other: one routing in several grasps, or several
// routings in one.
#pragma once

#include <string>
#include <vector>

#include "core/network.hpp"
#include "core/tension.hpp"
#include "reports/json.hpp"
#include "reports/show_report.hpp"

namespace reeve {

struct TensionPanel {
  std::string title;  // no two alike
  const Network* network = nullptr;
  const TensionState* state = nullptr;
};

// Panels of equal scale, over the motor tension. The networks have strands.
Json tension_spec(const std::vector<TensionPanel>& panels);

// A panel for each grasp.
Json tension_spec(const ShowReport& report);

// Facets in rows as long as the window is wide (page.js, `fitted`), and in `spec` as it stands in
// rows of as many panels as a figure of a paper takes.
Json in_rows(Json spec, double panel_width, std::size_t panels);

// The wish of a panel for its bars.
double panel_width(std::size_t bars);

}  // namespace reeve
