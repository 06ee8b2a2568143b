// The whole search, repeated without each fold of runs, and what its models win on the runs that
// they have not seen.
//
// Runs are dealt to at most five folds, those of one routing in turn. Each fold is opened once, by
// the model that was found without it. Where the readings of a fold's model hardly tell that from
// what all readings name, it is the latter, fitted to them alone. A name holds if more than half of
// the folds find it, too, or something that cannot be told from it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "diagnosis/search/term_search.hpp"

namespace reeve::diagnosis {

inline constexpr std::size_t most_folds = 5;

// A fold's own readings, and what was found in the others.
struct Fold {
  Dataset unseen;
  Dataset seen;
  Explanation found;
  // The forecasts are of its own readings.
  Forecast nominal;
  Forecast base;
  Forecast forecast;
};

// Returns the readings of these rows, ascending.
std::vector<std::size_t> readings_in(const Dataset& part);

// Returns for each run of the data the fold that it is in. Only runs of these readings are dealt.
std::vector<std::size_t> dealt_runs(const MeasuredData& data,
                                    const std::vector<std::size_t>& readings, std::size_t folds);

// Fewer than two runs give no folds.
std::vector<Fold> cross_validated(const MeasuredData& data,
                                  const std::vector<std::size_t>& readings, const Model& nominal,
                                  const TermSearch& search, Workers& workers);

// True if a fold's own term is this cause, another form of its law, the same in another group or in
// some of its runs, or one of its alternatives.
bool stands_for(const Effect& found, const AcceptedTerm& cause);

// The share of the folds in which the cause that was accepted in this place holds: they find it or
// one of its alternatives, or it is as evident there as what they find.
double share_of_folds(const std::vector<Fold>& folds, const AcceptedTerm& cause, std::size_t place);

// Forecasts of all readings, each by its fold.
Forecast joined(const std::vector<Fold>& folds, const Dataset& all,
                const std::function<Forecast(const Fold&)>& of);

}  // namespace reeve::diagnosis
