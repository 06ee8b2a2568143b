// A list of ranked designs as table, CSV and JSON: what `rank` and `explore` have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "reports/json.hpp"
#include "reports/sheet.hpp"
#include "search/ranking.hpp"
#include "search/uncertainty.hpp"

namespace reeve {

struct ListedDesign {
  RankedDesign ranked;
  std::string name;  // "" if it has none
  // Only where uncertainty was asked for.
  std::optional<RankDistribution> distribution;
};

// `distributions` is parallel to `ranked`, or empty.
std::vector<ListedDesign> list_designs(const std::vector<RankedDesign>& ranked,
                                       const std::vector<RankDistribution>& distributions,
                                       const Catalogue& catalogue);

// Uniformity and efficiency as mean/worst over the grasps. Besides what is always shown, the
// objectives that the order asks for, and what the score is made of where it orders.
Table design_table(const std::vector<ListedDesign>& designs, const Order& order = {},
                   const Score& score = authors_score());

// RFC 4180. A note, if any, becomes a comment line at the top.
std::string design_csv(const std::vector<ListedDesign>& designs, const std::string& note = "");

// Designs that have no rank.
std::string sample_csv(const std::vector<Design>& designs, const std::string& note = "");

Json to_json(const ListedDesign& design);
Json to_json(const std::vector<ListedDesign>& designs);
Json to_json(const std::vector<BestDesigns>& best);

}  // namespace reeve
