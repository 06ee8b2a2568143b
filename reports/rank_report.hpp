#pragma once

#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "reports/design_list.hpp"
#include "reports/distribution_report.hpp"
#include "reports/sheet.hpp"
#include "reports/show_report.hpp"
#include "search/margin.hpp"
#include "search/order.hpp"
#include "search/ranking.hpp"
#include "search/score.hpp"
#include "search/uncertainty.hpp"

namespace reeve {

// What the page shows besides the ranking.
struct RankDetails {
  std::vector<BestDesigns> best;
  std::vector<ShownRouting> routings;  // in the order of the designs, in the grasps of the ranking
  TensionDistributions distributions;
};

struct RankReport {
  std::vector<ListedDesign> designs;
  Order order;
  Score score = authors_score();
  GraspSet grasps;
  Model model;
  std::uint64_t unconverged = 0;  // tension solves
  // Only where they were asked for.
  std::optional<UncertaintyOptions> uncertainty;
  std::optional<std::vector<Margin>> margins;
  std::optional<RankDetails> details;
};

Sheet rank_sheet(const RankReport& report);
std::string rank_json(const RankReport& report);

}  // namespace reeve
