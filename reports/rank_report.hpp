// A ranking as a table and as JSON.
#pragma once

#include <string>

#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"
#include "studies/ranking_study.hpp"

namespace reeve::reports {

// If columns are chosen, the only table is the ranking.
Document rank_document(const RankReport& report, const ListColumns& columns = {});
std::string rank_json(const RankReport& report);

}  // namespace reeve::reports
