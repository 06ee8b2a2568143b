// Reports how near designs come to a wanted ratio of the fingers' pulls, and whether by statics.
#pragma once

#include <optional>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/target_study.hpp"

namespace reeve::reports {

// Describes the nearest design in a line or two; returns no lines without a report.
std::vector<DocumentLine> target_lines(const std::optional<TargetReport>& report);
Section target_section(const std::optional<TargetReport>& report);

Json target_json(const std::optional<TargetReport>& report);

}  // namespace reeve::reports
