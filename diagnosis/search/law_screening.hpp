// Every law that the grammar of terms can say of the data, screened to first order
// (law_families.hpp): a lever times a law of what each row records.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/search/found_laws.hpp"

namespace reeve::diagnosis {

// Returns the laws with the most evidence first, at most so many, of different sites or covariates.
// The problem is of some of the table's readings, all cells of each.
std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most);

}  // namespace reeve::diagnosis
