// Which other causes explain the readings as much as each one that is named (search/rivals.hpp).
//
// Where some come near by the training runs, all are fitted to all readings, those held out among
// them: no gain is claimed by that, only that it is no other cause.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/search/rivals.hpp"

namespace reeve::diagnosis {

struct AppliedCause {
  std::string name;
  Effect effect;  // of the extended model
};

// What the named causes are seen by, and what else was looked at.
struct AliasSearch {
  const Problem& training;  // seen from the extended model
  const Dataset& all;       // readings, where some are held out; none otherwise
  const Scatter& scatter;
  const Model& extended;
  const std::vector<Candidate>& candidates;
};

struct Aliases {
  std::vector<std::vector<Rival>> rivals;  // of each cause, by the training runs
  std::vector<Indistinguishable> groups;   // of causes that others cannot be told from
};

// Nothing if it was stopped.
std::optional<Aliases> aliases(const AliasSearch& search, const std::vector<AppliedCause>& causes,
                               Workers& workers, const std::function<bool()>& stop);

}  // namespace reeve::diagnosis
