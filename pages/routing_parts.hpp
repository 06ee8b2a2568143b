// Pieces that several pages have: schematics of a routing that was solved in some grasps, what
// `show` says of it as tables, and a trade-off.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pages/page_words.hpp"
#include "pages/shell/figure_files.hpp"
#include "pages/shell/html_table.hpp"
#include "pages/shell/page.hpp"
#include "reports/show_report.hpp"
#include "studies/listed_design.hpp"

namespace reeve::pages {

// In the order T1 … T2n.
std::vector<std::pair<Segment, double>> strands(const Network& network, const TensionState& state);

// For the page, with buttons to save it under that file's name, and for figures/.
std::string schematic_html(const std::string& id, const SolvedRouting& report,
                           const ShownGrasp& shown, const std::string& file);
FigureFile schematic_file(const std::string& file, const SolvedRouting& report,
                          const ShownGrasp& shown);

HtmlTable tension_table(const SolvedRouting& report);
HtmlTable share_table(const SolvedRouting& report);
HtmlTable contact_table(const SolvedRouting& report);
HtmlTable routing_objectives(const ShownRouting& report);

// For a template: the "text" of each line, and whether it is a "caveat".
Json line_values(const std::vector<DocumentLine>& lines);

// The report of a hand: its tables as HTML, and the lines below them.
struct HandParts {
  std::string tables;
  Json lines;
};
HandParts hand_parts(const ShownHand& hand);

// Trade-off table of designs against parts, as a section with its heading; "" if the trade-off has
// fewer than two steps.
std::string tradeoff_html(const ListedTradeoff& tradeoff);

}  // namespace reeve::pages
