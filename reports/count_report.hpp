#pragma once

#include <string>

#include "search/counting.hpp"

namespace reeve {

std::string count_table(const RoutingCounts& counts);
std::string count_json(const RoutingCounts& counts);

}  // namespace reeve
