// What a ranking says, in sentences.
#pragma once

#include "pages/ranking_charts.hpp"
#include "reports/output/json.hpp"
#include "reports/rank_report.hpp"

namespace reeve::pages {

// For the template ranking_answer.mustache. The report has details.
Json ranking_answer(const RankReport& report, const Labels& labels);

}  // namespace reeve::pages
