// Which causes explain the training data: accepted one by one until what is left looks like chance.
//
// A step screens every cause to first order, fits the promising causes of the hardware in full,
// judges the greatest gain by what the whole screening finds in data simulated from the current
// model, fits the other promising causes, and accepts the likeliest. Where mountings differ, the
// data are simulated to second order, and a gain that is not far beyond those is judged again by
// mountings that the model solves (mounted_draws.hpp). Afterwards each accepted cause
// has to defend its place: against others (one that explains more takes it), and against nothing
// (one that no longer gains enough goes). What the base model has already (coefficients that are
// free in every model, calibration.hpp) is fitted again each time, and stays.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

struct CauseSearchOptions {
  double alpha = 0.02;          // of the first cause
  double further_alpha = 0.01;  // of each further one: a second name is a stronger claim
  std::size_t replicates = 400;
  std::size_t most_causes = 3;
  std::uint64_t seed = 1;
};

struct AcceptedCause {
  Effect effect;
  double p_value = 1;  // family-wise, of the step that accepted it or its predecessor
};

struct CauseSearchResult {
  Model model;                          // with all accepted causes, fitted
  std::vector<AcceptedCause> accepted;  // in the order of acceptance
  double p_value_of_next = 1;           // of the best cause that was not accepted
};

// Returns nothing if `stop` says so. `changed` is called after each step with the current model,
// and may give the problem other standard deviations, and `mounting` what mountings do then.
std::optional<CauseSearchResult> search_causes(
    Problem& problem, const Model& base, const std::vector<Candidate>& candidates,
    const CauseSearchOptions& options, const MountingScatter& mounting, Workers& workers,
    const std::function<void(Problem&, const Model&)>& changed, const std::function<bool()>& stop);

}  // namespace reeve::diagnosis
