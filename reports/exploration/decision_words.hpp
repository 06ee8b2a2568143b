// The answer in a few sentences: which design is first, which costs less within a stated loss,
// where the trade-off bends, and why nothing is left where nothing is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/part_prices.hpp"
#include "reports/document/document.hpp"
#include "search/explore.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// "SoftHand (M-1b-…)", or the word alone.
std::string design_name(const ListedDesign& design);
// "SoftHand", or the word.
std::string short_name(const ListedDesign& design);

// "uniformity", "worst uniformity": a heading that stands alone.
std::string objective_heading(Objective objective);

// "" if there are none, or nobody says.
std::string cost_unit(const std::optional<PartPrices>& prices);

// "N", "mm/mm"; of a cost the unit of its prices; "" of numbers of parts and what has none.
std::string objective_unit(Objective objective, const std::string& cost_unit = "");

std::string signed_percent(double share);                 // "+1.3 %"
std::string within_text(const TradeoffOptions& options);  // "within 2 %"
std::string tradeoff_title(const Tradeoff& tradeoff);
// "Fewest sheaths within 2 %"
std::string advised_text(const TradeoffOptions& options);

// ", and 2 more with other bearings, which change nothing"; "" if there is none.
std::string equivalent_text(const ListedDesign& design);

// The first and the affordable design, and the knee. Nothing of nothing.
std::vector<DocumentLine> answer_lines(const std::vector<ListedDesign>& designs,
                                       const ListedTradeoff& tradeoff);

// Lists the equivalent designs for which each of the shown lines stands.
std::vector<DocumentLine> equivalent_lines(const std::vector<ListedDesign>& shown);

// Explains an exploration whose constraints no design meets together; nothing otherwise.
std::vector<DocumentLine> infeasible_lines(const ExploreOptions& options,
                                           const ExploreResult& result);

}  // namespace reeve::reports
