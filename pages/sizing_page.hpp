// The page of a sizing: what `reeve size … --out DIR` writes.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::pages {

struct SizingPage {
  std::string html;
  std::vector<FigureFile> figures;
};

// The report has details. `command`: that which writes the page.
SizingPage sizing_page(const SizingReport& report, const std::string& command);

}  // namespace reeve::pages
