// Defence of accepted terms. Each is put against nothing, and against others: one with more
// evidence takes its place, and those with hardly less share its probability, p_i ~ e^{E_i}.
#pragma once

#include "diagnosis/search/rival_terms.hpp"
#include "diagnosis/search/searched_model.hpp"

namespace reeve::diagnosis {

// True if two laws share one site and covariate, whatever their form. A constant law shares every
// covariate.
bool is_kin(const Effect& a, const Effect& b);

// Drops the terms without which the model is hardly less likely.
void drop_superfluous(SearchedModel& search);

// Puts a likelier term in the place of an accepted one, and notes those that are hardly less
// likely.
void defend(SearchedModel& search, const Vocabulary& words, std::size_t c);

}  // namespace reeve::diagnosis
