#pragma once

#include <string>

#include "reports/sheet/sheet.hpp"
#include "search/enumerate/counting.hpp"

namespace reeve::reports {

Sheet count_sheet(const RoutingCounts& counts, const PartSet& parts);
std::string count_json(const RoutingCounts& counts);

}  // namespace reeve::reports
