// The value of its covariate at which a law of friction begins to add to the hardware's
// coefficient.
//
// A coefficient mu of all tubes or all sheaths and a law f of them say together mu (1 + f(x)): any
// x0 can be where f is zero. Where the hardware's own coefficient mu_n is right at some x0 that the
// data have seen, or next to that, the law says all by itself,
//
//   mu (1 + f(x)) = mu_n (1 + g(x)),   g(x0) = 0,
//
// and no coefficient is wrong.
#pragma once

#include <optional>

#include "causes/cause.hpp"
#include "causes/term.hpp"

namespace reeve::diagnosis {

// True if the law is one of all contacts of one kind, linear, log or power, and the coefficient is
// that of this kind.
bool is_law_of(const Term& law, const Effect& coefficient);

// Returns g of a law f as above; nothing if f is not mu_n / mu - 1 anywhere in its range, or a
// tenth of that beside it.
std::optional<Effect> law_from(double nominal, double mu, const Effect& law);

}  // namespace reeve::diagnosis
