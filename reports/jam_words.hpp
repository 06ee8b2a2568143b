// Tells in which of all grasps a routing jams, and which tendons share a carriage, in words and
// JSON.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/network.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "search/evaluate/objectives.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// "fingers 1 and 2 are both held"
std::string held_words(Grasp grasp);

// "It never jams unless all fingers are held", "It jams when fingers 1 and 2 are both held (3 of 15
// grasps)"
std::string jam_sentence(const std::vector<Grasp>& smallest, const ObjectiveValues& values,
                         int fingers);

// "1;2 3;4", as a field of a CSV; "" of none, "none" for no finger held.
std::string jams_field(const std::vector<Grasp>& smallest);

// A list of finger numbers for each.
Json grasps_json(const std::vector<Grasp>& grasps);

// A tendon that no block ties to another is a tree by itself.
int tree_count(const Network& network);

// "2 tendons hang on one carriage: …"; "" of one tree.
std::string shared_carriage_text(const Network& network);

// Returns a note with the ranks that are meant, for a list that is shown; no line if there are
// none.
std::vector<DocumentLine> shared_carriage_lines(const std::vector<ListedDesign>& shown);

}  // namespace reeve::reports
