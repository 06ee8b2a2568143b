// The files that are embedded into the program: those of pages/assets and the chart library.
// The table is generated when building.
#pragma once

#include <map>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::pages {

const std::map<std::string_view, std::string_view>& asset_table();

// Throws std::out_of_range.
inline std::string_view asset(std::string_view name) { return asset_table().at(name); }

}  // namespace reeve::pages
