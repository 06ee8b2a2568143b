// The parts of a ranking's page: its figures, and what it says in sentences.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/page.hpp"
#include "reports/output/json.hpp"
#include "reports/rank_report.hpp"

namespace reeve::pages {

// Labels of the designs on the page, in their order: no two alike.
using Labels = std::vector<std::string>;

// Over the first two objectives that span the front; with only one, the mean uniformity or the mean
// efficiency joins it.
Figure pareto_figure(const RankReport& report, const Labels& labels);

// Median and 5 % to 95 % of each design's rank. The report has distributions.
Figure rank_figure(const RankReport& report, const Labels& labels);

// Strand tensions of these designs in their g-th grasp.
Figure tensions_figure(const std::vector<ShownRouting>& routings, const Labels& labels,
                       std::size_t grasp, std::size_t most);

// For the template ranking_answer.mustache. The report has details.
Json ranking_answer(const RankReport& report, const Labels& labels);

}  // namespace reeve::pages
