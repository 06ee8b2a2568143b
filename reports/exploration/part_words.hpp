// The parts that routings are made of, those that were left out because they make too many, and how
// many routings they make.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/field_parts.hpp"
#include "search/limits/limited_generator.hpp"

namespace reeve::reports {

// "tips tube; joins T, P; ends M, F; up to 2 floating blocks"
std::string parts_text(const PartSet& parts);

// The same, with the number of tendons and whether fingers are alike.
std::string routings_text(const GeneratorOptions& generator);

// "2 to 4 floating blocks are left out: …"
std::string left_out_text(const LeftOutParts& left_out);

Json parts_json(const PartSet& parts);
Json left_out_json(const std::optional<LeftOutParts>& left_out);

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
