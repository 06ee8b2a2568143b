#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/field_parts.hpp"
#include "search/limits/limited_generator.hpp"

namespace reeve::reports {

struct CountReport {
  PartSet parts;
  std::optional<LeftOutParts> left_out;
  RoutingCounts counts;
  std::vector<Constraint> constraints;
  std::optional<LimitedCounts> limited;  // if there are constraints
};

Document count_sheet(const CountReport& report);
std::string count_json(const CountReport& report);

}  // namespace reeve::reports
