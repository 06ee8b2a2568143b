// A ranking as a table and as JSON.
#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"
#include "studies/ranking_study.hpp"

namespace reeve::reports {

Sheet rank_sheet(const RankReport& report);
std::string rank_json(const RankReport& report);

}  // namespace reeve::reports
