// What more parts buy, as a section of a page: of an exploration and of a ranking alike.
#pragma once

#include <string>

#include "studies/listed_design.hpp"

namespace reeve::pages {

// With its heading; "" where there is no ladder of at least two rungs.
std::string ladder_html(const ListedLadder& ladder);

}  // namespace reeve::pages
