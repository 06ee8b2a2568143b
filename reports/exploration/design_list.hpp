// A list of ranked designs as table, CSV and JSON: what `rank` and `explore` have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/part_prices.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Uniformity and efficiency as mean/worst over the grasps. The objectives that are shown
// (search/evaluate/shown_objectives.hpp), blocks where there are any, and the cost where it is
// known. Or what is chosen among all columns, which are called as those of the CSV.
Table design_table(const std::vector<ListedDesign>& designs, std::vector<Objective> shown,
                   const ListColumns& wanted = {});

// The same columns, which head costs with the unit of the prices.
ListColumns priced(ListColumns wanted, const std::optional<PartPrices>& prices);

// Properties of a list of designs that determine which columns can be chosen.
struct ListedWith {
  bool prices = false;
  bool hand = false;
  bool draws = false;
  bool constraints = false;
};
std::vector<std::string> list_column_names(const ListedWith& with);
// Columns that a request for more would add.
std::vector<MissingColumns> missing_columns(const ListedWith& with);

// The shortest that a line of such a list may be: for room that is asked about before there are
// designs.
ListedDesign shortest_line(const std::string& word, const Order& order, const ListedWith& with);

// Without those for which another one stands: a line of a table is for all designs that are alike.
// The first `most`.
std::vector<ListedDesign> one_of_each(const std::vector<ListedDesign>& designs,
                                      std::size_t most = static_cast<std::size_t>(-1));

// Below such a table: which designs stand for others, and which rest on how their tendons share.
// The springs and slack are those of tendons by their numbers.
std::vector<DocumentLine> list_notes(const std::vector<ListedDesign>& shown,
                                     const TendonParts& tendons = {});

// ",uniformity_mean,…" and ",0.5,…": the objectives that there are with such values.
std::string objective_headings(const ObjectiveValues& values);
void append_objective_cells(std::string& csv, const ObjectiveValues& values);

// RFC 4180. A note, if any, becomes a comment line at the top.
std::string design_csv(const std::vector<ListedDesign>& designs, const std::string& note = "");

// Designs that have no rank.
std::string sample_csv(const std::vector<Design>& designs, const std::string& note = "");

Json to_json(const ListedDesign& design);
Json to_json(const std::vector<ListedDesign>& designs);
Json to_json(const std::vector<BestDesigns>& best);
// The best listed design that never jams, or null.
Json never_jams_json(const ListedTradeoff& tradeoff);

}  // namespace reeve::reports
