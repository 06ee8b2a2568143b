#pragma once

#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "reports/design_list.hpp"
#include "reports/sheet.hpp"
#include "search/margin.hpp"
#include "search/objectives.hpp"
#include "search/uncertainty.hpp"

namespace reeve {

struct RankReport {
  std::vector<ListedDesign> designs;
  std::vector<Objective> objectives;
  GraspSet grasps;
  Model model;
  std::uint64_t unconverged = 0;  // tension solves
  // Only where they were asked for.
  std::optional<UncertaintyOptions> uncertainty;
  std::optional<std::vector<Margin>> margins;
};

Sheet rank_sheet(const RankReport& report);
std::string rank_json(const RankReport& report);

}  // namespace reeve
