// Notes on routings of which several tendons, or trees of tendons, hang on one carriage.
//
// Within a tree the statics alone say how tensions stand to each other. Between trees they do not:
// the model has all take up the same fraction of their travel, as tendons of one stiffness (EA) do
// that are mounted without slack. So shares, uniformity and efficiency of such routings rest on
// how well they are trimmed.
#pragma once

#include <string>
#include <vector>

#include "core/network.hpp"
#include "reports/document/document.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// A tendon that no block ties to another is a tree by itself.
int tree_count(const Network& network);

// "2 tendons hang on one carriage: …"; "" of one tree.
std::string shared_carriage_text(const Network& network);

// Returns a note with the ranks that are meant, for a list that is shown; no line if there are
// none.
std::vector<DocumentLine> shared_carriage_lines(const std::vector<ListedDesign>& shown);

}  // namespace reeve::reports
