// The tables that an exploration's page has without JavaScript.
#pragma once

#include "reports/exploration/explore_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {

// For exploration.mustache: the front and the first designs, and the best by each objective alone.
Json static_tables(const ExploreReport& report);

}  // namespace reeve::pages
