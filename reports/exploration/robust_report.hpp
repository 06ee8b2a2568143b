// The nominal best and the most robust design of a ranking, and what each loses.
#pragma once

#include <optional>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Returns no lines if there is no most robust design.
std::vector<DocumentLine> robust_lines(const std::optional<RobustFirst>& first);

Json robust_json(const std::optional<RobustFirst>& first);

}  // namespace reeve::reports
