// Pieces of pages about a routing that was solved in some grasps: its schematics, and what `show`
// says of it as tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "pages/shell/figure_files.hpp"
#include "pages/shell/html_table.hpp"
#include "pages/shell/page.hpp"
#include "reports/results/show_report.hpp"

namespace reeve::pages {

// "no finger held", "finger 1 held", "fingers 1, 3 held"
std::string grasp_words(Grasp grasp);
// "held-none", "held-1", "held-1-3": part of the id of an element or a figure
std::string grasp_id(Grasp grasp);

struct NamedRouting {
  std::string name;  // "" if it has none
  std::string word;
};

// The name, or the word where there is none, or both where another of that name is among them: no
// two are alike, as long as no two words are.
std::vector<std::string> labels(const std::vector<NamedRouting>& routings);

// Counts without decimals.
std::string objective_text(const ObjectiveRow& row, const ObjectiveValues& values);

// In the order T1 … T2n.
std::vector<std::pair<Segment, double>> strands(const Network& network, const TensionState& state);

// For the page, with buttons to save it, and for figures/: ID.svg.
std::string schematic_html(const std::string& id, const ShownRouting& report,
                           const ShownGrasp& shown);
FigureFile schematic_file(const std::string& id, const ShownRouting& report,
                          const ShownGrasp& shown);

HtmlTable tension_table(const ShownRouting& report);
HtmlTable share_table(const ShownRouting& report);
HtmlTable contact_table(const ShownRouting& report);
HtmlTable objective_table(const ShownRouting& report);

}  // namespace reeve::pages
