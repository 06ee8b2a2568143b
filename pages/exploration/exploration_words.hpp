// Findings of an exploration, in plain words: only those that its values support.
#pragma once

#include <string>
#include <vector>

#include "reports/exploration/explore_report.hpp"

namespace reeve::pages {

// Sentences.
struct ExplorationWords {
  std::vector<std::string> won;
  std::vector<std::string> explored;
  std::vector<std::string> rejected;
  std::vector<std::string> changes;  // under which settings another design comes first
  std::vector<std::string> caveats;
};

ExplorationWords exploration_words(const ExploreReport& report);

// How an exploration was made: what was generated, how judged, what rejected. Sentences.
std::vector<std::string> explored_words(const ExploreReport& report);
std::vector<std::string> rejected_words(const ExploreReport& report);

// The first of the listed designs if a single objective counts.
struct SingleBest {
  const ObjectiveRow& objective;
  const ListedDesign& design;  // among the equally good ones, the design with the best rank
  std::size_t equal = 0;       // others that are as good
};

// One for each objective, or none if no design is listed.
std::vector<SingleBest> single_bests(const ExploreReport& report);

}  // namespace reeve::pages
