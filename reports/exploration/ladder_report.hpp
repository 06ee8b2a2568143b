// Trade-off table of designs against parts, as a table, as CSV and as JSON.
#pragma once

#include <string>

#include "core/part_prices.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Returns a ladder of two rungs with the shortest cells, to check the room before there are
// designs.
ListedLadder shortest_ladder(const ListedDesign& line, const Order& order,
                             const LadderOptions& options);

// Nothing of fewer than two rungs.
Section ladder_section(const ListedLadder& ladder);

// RFC 4180; a note becomes a comment line at the top.
std::string ladder_csv(const ListedLadder& ladder, const std::string& note = "");

Json ladder_json(const ListedLadder& ladder);

// {"by","within"} and the prices, null if there are none.
void add_ladder_settings(Json& settings, const LadderOptions& options,
                         const std::optional<PartPrices>& prices);

}  // namespace reeve::reports
