// Tells in which of all grasps a routing jams, in words and JSON.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "reports/output/json.hpp"
#include "search/evaluate/objectives.hpp"

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

}  // namespace reeve::reports
