// What explains the training runs: coefficients calibrated, scatter estimated, causes found, and
// those dropped that the training runs themselves do not confirm or do not know the size of.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/search/calibration.hpp"
#include "diagnosis/search/cause_search.hpp"

namespace reeve::diagnosis {

struct ExplanationOptions {
  double alpha = 0.02;
  std::size_t replicates = 1000;
  std::optional<std::size_t> most_causes;
  std::optional<double> mounting_scatter;
  std::uint64_t seed = 1;
};

struct Explanation {
  Problem problem;  // of the training runs, seen from the model
  Scatter scatter;
  Model base;   // with the coefficients that the data tell
  Model model;  // with the accepted causes as well
  std::vector<AcceptedCause> accepted;
  std::vector<Calibration> calibrations;  // by the model
  double alpha = 0.02;                    // at which coefficients differ
  double p_value = 1;                     // of the first accepted cause, or of the best there was
  std::size_t most_causes = 0;
  std::vector<std::string> not_confirmed;
  std::vector<std::string> not_sure;

  // How many independent differences between mountings the scatter is known from.
  double mounting_degrees() const;
};

// Of readings that are too few to look for anything.
Explanation nothing_explained(const Dataset& training, const Model& nominal,
                              const ExplanationOptions& options, Workers& workers);

// Nothing if it was stopped; `stop` is called with the name of each stage.
std::optional<Explanation> explain(const Dataset& training, const Model& nominal,
                                   const std::vector<Candidate>& candidates,
                                   const ExplanationOptions& options, Workers& workers,
                                   const std::function<bool(const char*)>& stop);

// Without the cause that was accepted last.
void take_back_last(Explanation& explanation, Workers& workers);

}  // namespace reeve::diagnosis
