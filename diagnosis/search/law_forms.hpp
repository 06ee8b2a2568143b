// The forms that one law can have. Screening to first order finds where a law acts and what it
// follows; of its form it tells little where the law is large. So the other forms are fitted, too.
// A law of the load is a force as well as a change of the exponent: phi' = phi + F e^phi / T_high.
#pragma once

#include <vector>

#include "causes/term.hpp"
#include "diagnosis/search/row_laws.hpp"

namespace reeve::diagnosis {

// Powers, exponentials and parabolas over the range of covariate c.
std::vector<RowLaw> smooth_bends(std::size_t c, const Range& seen);

// A force that contacts take is none that they give.
bool is_possible(const Term& term, const std::vector<double>& values);

// Nats that the form and the target add to the price of a law.
double price_of_form(const Term& term);

struct LawForm {
  Effect effect;  // a zero crossing of its own is free
  std::vector<std::vector<double>> starts;
  double more_price = 0;  // than that of the given law
};

// Returns the other forms of a law of one covariate, from values on at which they are near it; of a
// constant in one direction, that in the other.
std::vector<LawForm> other_forms(const Effect& law);

}  // namespace reeve::diagnosis
