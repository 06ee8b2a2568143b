// How sure a ranking is: the coefficients are drawn from their ranges, the designs are evaluated
// and ranked anew for each draw, and each design's rank becomes a distribution.
//
// A draw is a point of the box of uncertain coefficients (coefficient_box.hpp), uniform in it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "search/explore.hpp"
#include "search/judge/ranking.hpp"

namespace reeve::search {

struct UncertaintyOptions {
  Model nominal;
  UncertaintyRanges ranges;
  GraspSet grasps;
  Order order;
  std::size_t draws = 1000;  // at least 1
  std::uint64_t seed = 1;
  int threads = 0;
  Score score = authors_score();
  std::optional<PartPrices> prices = std::nullopt;
};

struct RankDistribution {
  double first = 0;  // share of draws in which the design is first
  double median = 0;
  double low = 0;   // 5 % quantile
  double high = 0;  // 95 % quantile
};

// The model of draw number `draw`: a function of seed and number alone. Its effects are the nominal
// ones, its hardware is drawn (coefficient_box.hpp).
Model draw_model(const UncertaintyOptions& options, std::uint64_t draw);

// Throws InputError if the upper end of the ranges is out of the range of the hardware, or if draws
// and designs together are more than memory should hold.
void validate(const UncertaintyOptions& options, std::size_t designs);

// Ranks among the given routings, parallel to them. Nothing if stopped.
std::optional<std::vector<RankDistribution>> rank_distributions(
    const std::vector<Routing>& routings, const UncertaintyOptions& options,
    const Supervision& supervision = {});

}  // namespace reeve::search
