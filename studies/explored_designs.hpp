// The best designs of an exploration, from the folder that it wrote.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/routing.hpp"
#include "numerics/floors.hpp"

namespace reeve::studies {

// The first `count` of designs.csv, which are in the order of their ranks; fewer, if it has no
// more. Throws InputError with file, line and column.
std::vector<Routing> explored_designs(const std::filesystem::path& folder, std::size_t count);

}  // namespace reeve::studies
