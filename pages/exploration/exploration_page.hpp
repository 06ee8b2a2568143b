// The page of an exploration: plots, table, and the selected designs side by side.
//
// Everything that it shows is in the report; what a selected design looks like is solved on demand.
// It stays below `page_bytes` whatever was explored: designs that the list holds beyond that, and
// the details of those that do not fit or were not asked for, are left out, and the page says so.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pages/exploration/exploration_details.hpp"
#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/exploration/explore_report.hpp"

namespace reeve::pages {

inline constexpr std::size_t page_bytes = 4'900'000;
inline constexpr std::size_t usual_schematics = 170;
inline constexpr std::size_t usual_first_schematics = 1000;

struct ExplorationView {
  const ExploreReport& report;
  std::string command;  // gives this exploration again
  // options with which `reeve show` judges alike: "" or " --hardware FILE"
  std::string show_options;
  SolveDesign solve;
  // The number of the best designs with schematics, tensions and contacts, beside the
  // named designs and the known routings. By default these are as many as `usual_schematics` show
  // in all grasps. `usual_first_schematics` designs more have the schematic of the first grasp: as
  // many as a list has by default.
  std::optional<std::size_t> details;
};

PageFiles exploration_page(const ExplorationView& view);

}  // namespace reeve::pages
