#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

// Quoted where RFC 4180 needs it: text of the user's, such as a name.
std::string csv_field(const std::string& text);

}  // namespace reeve::reports
