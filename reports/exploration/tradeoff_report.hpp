// Trade-off table of designs against parts, as a table, as CSV and as JSON.
#pragma once

#include <string>

#include "core/part_prices.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Returns a trade-off of two steps with the shortest cells, to check the room before there are
// designs.
ListedTradeoff shortest_tradeoff(const ListedDesign& line, const Order& order,
                                 const TradeoffOptions& options);

// There are no lines of fewer than two steps.
Section tradeoff_section(const ListedTradeoff& tradeoff);

// RFC 4180; a note becomes a comment line at the top.
std::string tradeoff_csv(const ListedTradeoff& tradeoff, const std::string& note = "");

Json tradeoff_json(const ListedTradeoff& tradeoff);

// {"by","within"} and the prices, null if there are none.
void add_tradeoff_settings(Json& settings, const TradeoffOptions& options,
                           const std::optional<PartPrices>& prices);

}  // namespace reeve::reports
