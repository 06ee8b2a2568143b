// A table in columns that are aligned, numbers to the right.
#pragma once

#include <string>

#include "reports/document/document.hpp"

namespace reeve::reports {

// In a narrow window dispensable columns are left out, which a line below says; then texts are
// wrapped; and what still finds no room follows below, with the first column again.
std::string text(const Table& table, const TextStyle& look = {});

// The line with the codes for its tint around it, if the look has colour.
std::string inked(const std::string& line, Tint tint, const TextStyle& look);

}  // namespace reeve::reports
