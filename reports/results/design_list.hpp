// A list of ranked designs as table, CSV and JSON: what `rank` and `explore` have in common.
#pragma once

#include <string>
#include <vector>

#include "reports/json.hpp"
#include "reports/sheet/chosen_columns.hpp"
#include "reports/sheet/sheet.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Uniformity and efficiency as mean/worst over the grasps. The objectives that are shown
// (search/judge/shown_objectives.hpp), blocks where there are any, and the cost where it is known.
// Or what is chosen among all columns, which are called as those of the CSV.
Table design_table(const std::vector<ListedDesign>& designs, std::vector<Objective> shown,
                   const ListColumns& wanted = {});

// What can be chosen, of designs that were judged so.
struct ListedWith {
  bool prices = false;
  bool hand = false;
  bool draws = false;
  bool constraints = false;
};
std::vector<std::string> list_column_names(const ListedWith& with);

// Without those for which another one stands: a line of a table is for all designs that are alike.
std::vector<ListedDesign> one_of_each(const std::vector<ListedDesign>& designs);

// ",uniformity_mean,…" and ",0.5,…": the objectives that there are with such values.
std::string objective_headings(const ObjectiveValues& values);
std::string objective_cells(const ObjectiveValues& values);

// RFC 4180. A note, if any, becomes a comment line at the top.
std::string design_csv(const std::vector<ListedDesign>& designs, const std::string& note = "");

// Designs that have no rank.
std::string sample_csv(const std::vector<Design>& designs, const std::string& note = "");

Json to_json(const ListedDesign& design);
Json to_json(const std::vector<ListedDesign>& designs);
Json to_json(const std::vector<BestDesigns>& best);

}  // namespace reeve::reports
