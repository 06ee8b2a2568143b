// Every routing of a set of parts, ranked, beside the routings that are known.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "search/checkpoint.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/motor_force.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "store/exploration_store.hpp"
#include "studies/listed_design.hpp"
#include "studies/shown_routing.hpp"
#include "studies/study_supervision.hpp"
#include "studies/target_study.hpp"

namespace reeve::studies {

struct ExploreReport {
  ExploreOptions options;
  ExploreResult result;
  std::vector<ListedDesign> front;
  std::vector<ListedDesign> top;
  std::vector<std::string> reference_names;  // parallel to result.references
  ListedTradeoff tradeoff;
  std::optional<RobustFirst> robust_first = std::nullopt;
  std::optional<MotorForce> motor{};     // motor force of the first design, with a hand
  std::vector<double> target_shares{};   // empty: no target
  std::optional<TargetReport> target{};  // only if one was asked for
  // The first design in the smallest grasp in which it jams, if there is one.
  std::optional<SolvedRouting> jammed_first = std::nullopt;
  // Only where uncertainty was asked for.
  std::optional<UncertaintyOptions> uncertainty;
  bool draws_stopped = false;               // before there were distributions
  std::vector<Bands> reference_bands = {};  // parallel to result.references, or empty
  std::optional<CoefficientRange> sweep_over = std::nullopt;  // only where it was asked for
  std::optional<SweptDesigns> sweep = std::nullopt;           // not if it was stopped
};

// The longer of top and front: both are the beginning of one ranking.
const std::vector<ListedDesign>& listed_designs(const ExploreReport& report);

// Counts the different sets of values of the objectives on the front; variants share theirs.
std::size_t distinct_on_front(const ExploreReport& report);

// The catalogue's routings with as many fingers as the options ask for, as the generator writes
// them. Left out are those without tensions in one of the grasps.
std::vector<Routing> known_routings(const ExploreOptions& options, const Catalogue& catalogue);

// With `uncertainty` also the spread of ranks and objectives, of the longer of top and front, and
// of the objectives of known routings beyond. A stopped report says so, and holds the results up to
// then. `search` as of explore.
ExploreReport exploration_study(const ExploreOptions& options,
                                const std::optional<UncertaintyOptions>& uncertainty,
                                const Catalogue& catalogue,
                                const StudySupervision& supervision = {},
                                const Checkpoint& checkpoint = {}, const Searcher& search = {});

// The same of shards that were explored elsewhere, all of them. Throws InputError on words that are
// no routings of this exploration.
ExploreReport merged_study(const ExploreOptions& options,
                           const std::optional<UncertaintyOptions>& uncertainty,
                           const std::vector<ShardRecord>& shards, const Catalogue& catalogue,
                           const StudySupervision& supervision = {});

// Returns the report of the request, without results.
ExploreReport planned_report(const ExploreOptions& options,
                             const std::optional<UncertaintyOptions>& uncertainty,
                             const Catalogue& catalogue);

// The drawn bands are parallel to the longer of top and front, or empty.
ExploreReport explore_report(const ExploreOptions& options, ExploreResult result,
                             const DrawnDesigns& drawn, const Catalogue& catalogue);

// More lines than these a figure cannot show.
inline constexpr std::size_t most_swept = 8;

// The first design, the affordable one, the steps of the trade-off, and the front: the designs to
// choose from. Among designs that are alike, only the first is swept.
std::vector<ListedDesign> designs_to_sweep(const ExploreReport& report);

// Sweeps these designs; adds no sweep if it was stopped now or before.
void add_sweep(ExploreReport& report, const SweepOptions& options,
               const StudySupervision& supervision);

// Adds the motor force of the first design, and none if the exploration was stopped.
void add_motor(ExploreReport& report, const UncertaintyOptions& drawn);

// Keeps an exploration in a store while it runs. Goes on where the store ends; saves when so long
// has passed since the last time, or when many designs have gathered. The store has to outlive it.
Checkpoint checkpoint_in(ExplorationStore& store, std::chrono::seconds every);

}  // namespace reeve::studies
