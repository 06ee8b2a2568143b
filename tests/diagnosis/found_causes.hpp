// Which of some causes a search finds on a bench, and their names in alphabetical order.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/search/cause_search.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {

using Changed = std::function<void(Problem&, const Model&)>;
using Candidates = std::vector<Candidate>;
using Causes = std::vector<const MadeUpCause*>;
using Names = std::vector<std::string>;

inline void unchanged(Problem&, const Model&) {}

inline CauseSearchResult found(Bench& bench, const Candidates& candidates,
                               const CauseSearchOptions& options = {}, const Model& nominal = {},
                               const Changed& changed = unchanged) {
  Workers workers(1);
  return *search_causes(bench.problem, nominal, candidates, options, {}, workers, changed,
                        [] { return false; });
}

inline CauseSearchResult found(Bench& bench, const Causes& causes,
                               const CauseSearchOptions& options = {},
                               const Changed& changed = unchanged) {
  Candidates candidates;
  for (const MadeUpCause* cause : causes) candidates.push_back(cause->candidate());
  return found(bench, candidates, options, {}, changed);
}

inline Names names(const CauseSearchResult& result) {
  Names names;
  for (const AcceptedCause& accepted : result.accepted)
    names.push_back(effect_name(accepted.effect));
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace reeve::testing
