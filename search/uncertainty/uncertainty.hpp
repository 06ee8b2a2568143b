// Measures how sure a ranking is. The coefficients are drawn from their ranges, and the designs are
// evaluated and ranked anew for each draw. Each design's place and each of its objectives become a
// distribution.
//
// A draw has two layers: a point of the box of uncertain coefficients (coefficient_box.hpp),
// uniform in it, of which all parts of a kind are; and on top of that a factor of its own for each
// contact (ContactScatter), so that no two contacts are alike. Contacts at the same place of two
// networks have the same factor. Designs that are equal in a draw share their place
// (rank/equivalent.hpp): two of them can both be first.
//
// Memory does not grow with the draws times the designs times the objectives: of as many designs as
// there is room for the values are kept while all are ranked, and the others are evaluated once
// more. The result is the same for any number of threads and any room.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "search/explore.hpp"
#include "search/rank/ranking.hpp"
#include "search/uncertainty/bands.hpp"

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
  std::size_t values_at_once = 32'000'000;  // bound on drawn values kept for bands; 8 bytes each
  std::vector<Constraint> constraints = {};
};

// Distribution of a design's place among the designs that were drawn together.
struct RankDistribution {
  double first = 0;  // share of draws in which no design is better placed
  double median = 0;
  double low = 0;           // 5 % quantile
  double high = 0;          // 95 % quantile
  double first_shared = 0;  // share of draws in which it shares the first place
};

struct DrawnDesigns {
  std::vector<RankDistribution> ranks;
  // Shares of the draws in which a design meets all constraints; empty without constraints. They
  // leave no design out: what is listed met them at the nominal coefficients.
  std::vector<double> constraints_met = {};
  std::vector<Bands> bands;
  std::vector<Band> decisive = {};  // bands of decisive_value
};

// The model of draw number `draw`: a function of seed and number alone. Its effects are the nominal
// ones, its hardware is drawn (coefficient_box.hpp).
Model draw_model(const UncertaintyOptions& options, std::uint64_t draw);

// Throws InputError if the upper end of the ranges is out of the range of the hardware, or if draws
// and designs together are more than memory should hold.
void validate(const UncertaintyOptions& options, std::size_t designs);

// Ranks among the given routings, how often they meet the constraints, and their bands, parallel to
// them. Nothing if stopped.
std::optional<DrawnDesigns> drawn_designs(const std::vector<Routing>& routings,
                                          const UncertaintyOptions& options,
                                          const Supervision& supervision = {});

// Bands of these objectives alone, of draws of any models. Nothing if stopped.
using DrawnModel = std::function<Model(std::uint64_t draw)>;
std::optional<std::vector<Bands>> drawn_bands(const std::vector<Routing>& routings,
                                              const std::vector<Objective>& objectives,
                                              const UncertaintyOptions& options,
                                              const DrawnModel& model,
                                              const Supervision& supervision = {});

}  // namespace reeve::search
