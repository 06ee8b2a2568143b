// Strand tensions as bars, one panel beside the other: one routing in several grasps, or several
// routings in one.
#pragma once

#include <string>
#include <vector>

#include "core/network.hpp"
#include "core/tension/tension.hpp"
#include "drawing/chart/chart.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {

struct TensionPanel {
  std::string title;  // no two alike
  const Network* network = nullptr;
  const TensionState* state = nullptr;
};

// Panels of equal scale, over the motor tension. The text that describes them lists the tensions,
// for its beginning to be put before. The networks have strands.
chart::Chart tension_chart(const std::vector<TensionPanel>& panels);

// A panel for each grasp.
chart::Chart tension_chart(const SolvedRouting& report);

// As many panels in a row as a figure of a paper takes.
std::size_t columns(double panel_width, std::size_t panels);

// The wish of a panel for its bars.
double panel_width(std::size_t bars);

}  // namespace reeve::pages
