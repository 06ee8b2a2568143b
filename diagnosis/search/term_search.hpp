// The likeliest model of some readings: coefficients calibrated, then terms accepted one by one.
//
// A step screens every cause of the library and every law of the grammar to first order, fits the
// most promising in full (rival_terms.hpp), and accepts the one with the greatest evidence
// (searched_model.hpp) if that is at least 3 nats above the model without it. After each step the
// earlier terms have to defend their places (defence.hpp): one that stood in for two is replaced
// before others stand in for what it leaves. The coefficients that are free in every
// model (calibration.hpp) are fitted again each time.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "diagnosis/search/calibration.hpp"
#include "diagnosis/search/rival_terms.hpp"
#include "diagnosis/search/searched_model.hpp"

namespace reeve::diagnosis {

struct TermSearchOptions {
  double alpha = 0.02;                     // chance for coefficients that differ
  std::optional<std::size_t> most_causes;  // beside coefficients; none: as many as the data carry
  // Relative standard deviation of friction exponents from mounting to mounting, if it is known.
  std::optional<double> mounting_scatter;
  // Laws that are looked for, from these values on, at the price of a name of the library.
  std::vector<Effect> terms{};
};

struct Explanation {
  Problem problem;  // seen from the model
  Scatter scatter;
  Model base;   // with the coefficients that the data tell
  Model model;  // with the accepted causes as well
  std::vector<AcceptedTerm> accepted;
  std::vector<Calibration> calibrations;  // by the model
  // Parallel to these: causes of the library that, beside the hardware's own coefficient, explain
  // the readings hardly less than one that differs from it.
  std::vector<std::vector<Alternative>> instead;
  // Belongs to a search on some of the readings, parallel to what was accepted on all of them:
  // whether all that together is as evident here as what was found here, and more evident with this
  // one.
  std::vector<bool> holds;
  double best_refused = 0;  // evidence of the best that was not accepted
  std::size_t most_causes = 0;

  // How many independent differences between mountings the scatter is known from.
  double mounting_degrees() const;
};

// The explanation of readings that are too few to look for anything.
Explanation nothing_explained(const Dataset& dataset, const Model& nominal,
                              const std::vector<Effect>& candidates,
                              const TermSearchOptions& options, Workers& workers);

// The explanation without one of the accepted causes, with the scatter that is likeliest then.
Explanation without_term(const Dataset& dataset, const Explanation& found, std::size_t cause,
                         const TermSearchOptions& options, Workers& workers);

class TermSearch {
 public:
  // Everything must outlive it.
  TermSearch(const Dataset& dataset, const Model& nominal, const std::vector<Effect>& candidates,
             const TermSearchOptions& options, Workers& workers);

  // `stage` is called with the name of each stage.
  Explanation run(const std::function<void(const char*)>& stage);

  // The same search on some of the runs, by the columns that `run` has made. Any thread may.
  Explanation run_on(const Dataset& part, Workers& workers) const;

 private:
  const Dataset& dataset_;
  const Model& nominal_;
  const TermSearchOptions& options_;
  Workers& workers_;
  std::vector<Effect> coefficients_;
  std::vector<Effect> causes_;
  std::vector<Screened> screened_;
  // Results of the search on all readings.
  ScatterLevel level_;
  Model model_;
  std::vector<AcceptedTerm> accepted_;
};

}  // namespace reeve::diagnosis
