// A ranked design with what the catalogue and drawn coefficients say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/canonical.hpp"
#include "core/part_prices.hpp"
#include "core/routing.hpp"
#include "search/rank/ladder.hpp"
#include "search/rank/ranking.hpp"
#include "search/uncertainty/sweep.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

struct ListedDesign {
  RankedDesign ranked;
  Routing routing;
  std::string name;  // "" if it has none
  // Only where uncertainty was asked for.
  std::optional<RankDistribution> distribution;
  // Designs that differ in bearings alone, which change nothing (search/rank/equivalent.hpp): of
  // the first of them the words of the others that are listed, and of these its word.
  std::vector<std::string> equivalent = {};
  std::string same_as = {};
  Bands bands = {};       // only where uncertainty was asked for
  std::size_t place = 0;  // its rank, but that designs that are equal share the first of theirs
  // Share of the draws in which it meets all constraints: only where there are both.
  std::optional<double> constraints_met = std::nullopt;
};

// A ladder with what is known of its designs. Ranks and fronts are 0 where they are beyond the
// list.
struct ListedLadder {
  Ladder ladder;
  std::vector<ListedDesign> rungs;  // parallel to the ladder's
  std::optional<ListedDesign> affordable;
  std::string cost_unit;  // of the prices; "" if there are none, or nobody says
};

// `routings` begins parallel to `ranked`, and so is what was drawn, or it is empty.
std::vector<ListedDesign> list_designs(std::vector<RankedDesign> ranked,
                                       std::vector<Routing> routings, const DrawnDesigns& drawn,
                                       const Catalogue& catalogue);

// Of a ranking that begins with these designs: search/rank/equivalent.hpp.
void mark_places(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& places);

// Likewise: search/rank/equivalent.hpp.
void mark_equivalent(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& firsts);

// `listed` is where ranks are looked up.
ListedLadder list_ladder(const Ladder& ladder, const std::vector<ListedDesign>& listed,
                         const std::optional<PartPrices>& prices, const Catalogue& catalogue);

// Listed designs over one coefficient.
struct SweptDesigns {
  Sweep sweep;
  std::vector<ListedDesign> designs;  // parallel to the sweep's
};

// Nothing if stopped.
std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision);

}  // namespace reeve::studies
