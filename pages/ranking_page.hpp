// The page of a ranking: what `reeve rank … --out DIR` writes.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/rank_report.hpp"

namespace reeve::pages {

struct RankingPage {
  std::string html;
  std::vector<FigureFile> figures;
};

// The report has details. `command`: that which writes the page.
RankingPage ranking_page(const RankReport& report, const std::string& command);

}  // namespace reeve::pages
