#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

// Quoted where RFC 4180 needs it: text of the user's, such as a name.
std::string csv_field(const std::string& text);

// With every bit; empty where there is no such number.
std::string csv_number(double value);

}  // namespace reeve::reports
