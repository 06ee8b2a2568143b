// The pages of a routing, a ranking, a sizing and the catalogue: what `show`, `rank`, `size` and
// `catalogue` write with --out. The pages of an exploration and of a diagnosis have headers of
// their own.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "reports/rank_report.hpp"
#include "reports/show_report.hpp"
#include "studies/catalogue_list.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::pages {

// `command`: that which writes the page.
PageFiles routing_page(const ShownRouting& report, const std::string& command);

// The report has details.
PageFiles ranking_page(const RankReport& report, const std::string& command);

// The report has details.
PageFiles sizing_page(const SizingReport& report, const std::string& command);

// Lists the mechanisms by family, each with a drawing.
PageFiles catalogue_page(const std::vector<ListedMechanism>& list, const std::string& command);

}  // namespace reeve::pages
