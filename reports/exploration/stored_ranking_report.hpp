// Report of a store that was ranked again: as a table, as JSON and as CSV.
#pragma once

#include <string>

#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"
#include "studies/stored_ranking.hpp"

namespace reeve::reports {

Document stored_ranking_document(const StoredRanking& ranking, const ListColumns& columns = {});
std::string stored_ranking_json(const StoredRanking& ranking);
std::string stored_ranking_csv(const StoredRanking& ranking);

}  // namespace reeve::reports
