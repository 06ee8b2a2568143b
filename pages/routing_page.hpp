// The page of one routing: what `reeve show ROUTING --out DIR` writes.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {

struct RoutingPage {
  std::string html;
  std::vector<FigureFile> figures;
};

// `command`: that which writes the page.
RoutingPage routing_page(const ShownRouting& report, const std::string& command);

}  // namespace reeve::pages
