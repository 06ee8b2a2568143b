// The nominal best and the robust best of a ranking, and what each loses.
#pragma once

#include <optional>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// Returns no lines if there is no robust best.
std::vector<DocumentLine> robust_lines(const std::optional<RobustFirst>& first);

Json robust_json(const std::optional<RobustFirst>& first);

}  // namespace reeve::reports
