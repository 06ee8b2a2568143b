// Every routing of a set of parts, ranked, beside the routings that are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "studies/listed_design.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

struct ExploreReport {
  ExploreOptions options;
  ExploreResult result;
  std::vector<ListedDesign> front;
  std::vector<ListedDesign> top;
  std::vector<std::string> reference_names;  // parallel to result.references
  ListedLadder ladder;
  // Only where uncertainty was asked for.
  std::optional<UncertaintyOptions> uncertainty;
  bool draws_stopped = false;  // before there were distributions
};

// The catalogue's routings with as many fingers as the options ask for, as the generator writes
// them.
std::vector<Routing> known_routings(const GeneratorOptions& options, const Catalogue& catalogue);

// With `uncertainty` also the spread of the ranks, of the longer of top and front. What was stopped
// says so, and holds what there was.
ExploreReport exploration_study(const ExploreOptions& options,
                                const std::optional<UncertaintyOptions>& uncertainty,
                                const Catalogue& catalogue,
                                const StudySupervision& supervision = {});

// The same of shards that were explored elsewhere, all of them. Throws InputError on words that are
// no routings of this exploration.
ExploreReport merged_study(const ExploreOptions& options,
                           const std::optional<UncertaintyOptions>& uncertainty,
                           const std::vector<ShardRecord>& shards, const Catalogue& catalogue,
                           const StudySupervision& supervision = {});

// What is asked, before there is an answer.
ExploreReport planned_report(const ExploreOptions& options,
                             const std::optional<UncertaintyOptions>& uncertainty,
                             const Catalogue& catalogue);

// Distributions are parallel to the longer of top and front, or empty.
ExploreReport explore_report(const ExploreOptions& options, ExploreResult result,
                             const std::vector<RankDistribution>& distributions,
                             const Catalogue& catalogue);

}  // namespace reeve::studies
