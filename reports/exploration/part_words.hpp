// The parts that routings are made of, those that were left out because they make too many, and how
// many routings they make.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/field_parts.hpp"
#include "search/limits/limited_counts.hpp"

namespace reeve::reports {

// Parts that a set has or has not, beyond tips, joins, ends, anchors and blocks.
struct PartSwitch {
  bool PartSet::*is_in;
  const char* name;   // in JSON, and with dashes among the options
  const char* words;  // "linked blocks"
  int least_blocks;   // without so many blocks there is none of it
};
inline constexpr std::array part_switches{
    PartSwitch{&PartSet::linked, "linked", "linked blocks", 2},
    PartSwitch{&PartSet::series, "series", "blocks in series", 2},
    PartSwitch{&PartSet::bars, "bars", "bars", 1},
    PartSwitch{&PartSet::beckets, "beckets", "beckets", 1},
    PartSwitch{&PartSet::double_passes, "double_passes", "double passes", 1}};

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
