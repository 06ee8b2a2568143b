// Defence of accepted terms. Each is put against nothing, and against others: one with more
// evidence takes its place, and those with hardly less share its probability, p_i ~ e^{E_i}. The
// evidence of a model is less here by what its free coefficients of friction cost: with k of them,
// each of which gains G_c over the hardware's value,
//
//   sum over c of min(G_c, ln(n)/2 + ln(k))
//
// so that of causes that explain alike the one is likelier that leaves them as the hardware says.
#pragma once

#include "diagnosis/search/rival_terms.hpp"
#include "diagnosis/search/searched_model.hpp"

namespace reeve::diagnosis {

// True if two laws share one site and covariate, whatever their form. A constant law shares every
// covariate, and that of one direction is that of the other beside another coefficient. The place
// in the file and the number of the run are one: when a reading was taken.
bool is_kin(const Effect& a, const Effect& b);

// True if two laws have one target and site, in whatever runs.
bool acts_alike(const Effect& a, const Effect& b);

// True if two laws are alike but for the groups that they are of.
bool differ_in_group(const Effect& a, const Effect& b);

// Drops the terms without which the model is hardly less likely.
void drop_superfluous(SearchedModel& search);

// Puts a likelier term in the place of an accepted one, and notes those that are hardly less
// likely.
void defend(SearchedModel& search, const Vocabulary& words, std::size_t c);

}  // namespace reeve::diagnosis
