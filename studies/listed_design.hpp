// A ranked design with what the catalogue and drawn coefficients say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/canonical.hpp"
#include "core/grasp.hpp"
#include "core/part_prices.hpp"
#include "core/routing.hpp"
#include "search/rank/ranking.hpp"
#include "search/rank/tradeoff.hpp"
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
  // The band of what orders designs within a front; only if uncertainty was asked for.
  std::optional<Band> decisive = std::nullopt;
  // The smallest sets of held fingers with which it jams (core/tension/jamming.hpp).
  std::vector<Grasp> smallest_jams = {};
};

// A tradeoff with what is known of its designs. Ranks and fronts are 0 where they are beyond the
// list.
struct ListedTradeoff {
  Tradeoff tradeoff;
  std::vector<ListedDesign> steps;  // parallel to the trade-off's
  std::optional<ListedDesign> affordable;
  std::optional<BlockChoice<ListedDesign>> choice;  // only where the trade-off has one
  // The choice with floating blocks, with bars in place of them where they can be.
  std::optional<ListedDesign> with_bars;
  std::string cost_unit;  // unit of the prices; "" if there are none, or none is given
  // The first of the listed designs that jam in no grasp.
  std::optional<ListedDesign> never_jams = std::nullopt;
};

// `routings` begins parallel to `ranked`, and so is what was drawn, or it is empty. The model is
// that by which they were evaluated.
std::vector<ListedDesign> list_designs(std::vector<RankedDesign> ranked,
                                       std::vector<Routing> routings, const DrawnDesigns& drawn,
                                       const Model& model, const Catalogue& catalogue);

// Marks the places in a ranking that begins with these designs (search/rank/equivalent.hpp).
void mark_places(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& places);

// Marks the equivalent designs (search/rank/equivalent.hpp).
void mark_equivalent(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& firsts);

// Two answers where numbers are uncertain: the design that is first at the nominal coefficients,
// and the one that is best in 5 % of the worst cases. `value` is what orders designs within a front
// (decisive_value), `p5` its 5 % quantile over the draws of coefficients. Without draws it is that
// over contacts that are not alike, uniformity_p5 × efficiency_p5.
struct RobustDesign {
  ListedDesign design;
  double value = 0;
  double p5 = 0;
};

struct RobustFirst {
  RobustDesign nominal;
  RobustDesign robust;  // the same one if none has a greater quantile
  bool by_score = false;
  bool over_draws = false;
};

// Returns the nominal and the robust best of a ranking. Returns nothing without designs, and
// nothing for the score without draws. Designs that are alike at the nominal coefficients need not
// be so where contacts are not, so all of them are looked at.
std::optional<RobustFirst> robust_first(const std::vector<ListedDesign>& designs,
                                        const Order& order);

// `listed` is where ranks are looked up.
ListedTradeoff list_tradeoff(const Tradeoff& tradeoff, const std::vector<ListedDesign>& listed,
                             const Order& order, const Model& model,
                             const std::optional<PartPrices>& prices, const Catalogue& catalogue);

// The settings by which a trade-off of designs was evaluated.
struct EvaluatedBy {
  const Model& model;
  const GraspSet& grasps;
  const Score& score;
  const std::optional<PartPrices>& prices;
};

// Adds what bars in place of its floating blocks make of the trade-off's choice.
void add_bars(ListedTradeoff& tradeoff, const EvaluatedBy& by, const Catalogue& catalogue);

LookAtNetworks looks_at_designs(const std::vector<ListedDesign>& designs);

// Listed designs over one coefficient.
struct SweptDesigns {
  Sweep sweep;
  std::vector<ListedDesign> designs;  // parallel to the sweep's
  std::string note = {};              // on contacts that the sweep leaves alone
};

// Nothing if stopped.
std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision);

}  // namespace reeve::studies
