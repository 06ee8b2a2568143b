// The catalogue's files in the program, by their path in the catalogue. The table is generated when
// building.
#pragma once

#include <map>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::catalog {

const std::map<std::string_view, std::string_view>& embedded_catalogue();

}  // namespace reeve::catalog
