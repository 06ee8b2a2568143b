// Tells in which of all grasps a routing jams, and which tendons share a carriage, in words and
// JSON.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "search/evaluate/objectives.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// "fingers 1 and 2 are both held"
std::string held_words(Grasp grasp);

// "It never jams unless all fingers are held", "It jams when fingers 1 and 2 are both held (3 of 15
// grasps)". If groups of motors have nothing in common, it names the motors that stall.
std::string jam_sentence(const std::vector<Grasp>& smallest, const ObjectiveValues& values,
                         const Network& network);

// Returns "M2 stalls" of a state that jams, if motors have nothing in common; otherwise "".
std::string stalled_motors(const Network& network, const TensionState& state);
// " (jams)" or " (M2 stalls)"; "" if the state does not jam.
std::string jam_mark(const Network& network, const TensionState& state);

// "1;2 3;4", as a field of a CSV; "" of none, "none" for no finger held.
std::string jams_field(const std::vector<Grasp>& smallest);

// A list of finger numbers for each.
Json grasps_json(const std::vector<Grasp>& grasps);

// A tendon that no block ties to another is a tree by itself.
int tree_count(const Network& network);

// "2 tendons hang on one carriage: …"; "" of one tree.
std::string shared_carriage_text(const Network& network, const TendonParts& tendons);

// Says that several motors are judged as one machine.
extern const char* const motors_together_note;

// Returns a note with the ranks that are meant, for a list that is shown; no line if there are
// none.
std::vector<DocumentLine> shared_carriage_lines(const std::vector<ListedDesign>& shown,
                                                const TendonParts& tendons);

}  // namespace reeve::reports
