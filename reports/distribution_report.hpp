// What the figure of tension distributions shows, for programs (docs/json.md).
#pragma once

#include "reports/output/json.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::reports {

Json to_json(const TensionDistribution& distribution);
Json to_json(const SharedData& data);

}  // namespace reeve::reports
