// Routings that somebody has in mind, compared: ranked, and where asked for with the spread of
// their ranks and with the least lead of the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "search/evaluate/score.hpp"
#include "search/rank/ranking.hpp"
#include "search/uncertainty/margin.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "studies/listed_design.hpp"
#include "studies/shown_routing.hpp"
#include "studies/study_supervision.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::studies {

// Draws of coefficients for the spread of the ranks.
struct Draws {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
};

// The settings by which routings are ranked.
struct RankSettings {
  Model model;
  UncertaintyRanges ranges;
  GraspSet grasps;
  Order order;
  Score score = authors_score();
  std::optional<PartPrices> prices;
};

struct RankRequest : RankSettings {
  std::vector<Routing> routings;  // as many fingers each
  std::optional<Draws> draws;
  bool margins = false;  // needs the order of mean uniformity and mean efficiency
  bool details = false;
  int threads = 0;
  TradeoffOptions tradeoff;
  std::optional<CoefficientRange> sweep = std::nullopt;
};

// Details that the page shows besides the ranking.
struct RankDetails {
  std::vector<BestDesigns> best;
  std::vector<ShownRouting> routings;  // in the order of the designs, in the grasps of the ranking
  TensionDistributions distributions;
};

struct RankReport : RankSettings {
  std::vector<ListedDesign> designs;
  std::uint64_t unconverged = 0;  // tension solves
  // Only where they were asked for.
  std::optional<UncertaintyOptions> uncertainty;
  std::optional<std::vector<Margin>> margins;
  std::optional<RankDetails> details;
  ListedTradeoff tradeoff;
  std::optional<RobustFirst> robust_first;
  std::optional<MotorForce> motor{};                 // motor force of the first design, with a hand
  std::optional<SweptDesigns> sweep = std::nullopt;  // only if it was asked for
};

// How its designs are judged and drawn.
UncertaintyOptions uncertainty_of(const RankRequest& request);

// Nothing if it was stopped. The details have no distributions yet.
std::optional<RankReport> ranking_study(const RankRequest& request, const Catalogue& catalogue,
                                        const StudySupervision& supervision = {});

}  // namespace reeve::studies
