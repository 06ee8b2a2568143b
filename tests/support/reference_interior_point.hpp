// Which contacts of a tendon are at a bound, by the reference model.
#pragma once

#include <vector>

#include "tests/support/reference_problem.hpp"

namespace reeve::testing::reference {

// +1: u_left - u_right = phi; -1: = -phi; 0: inside.
using Sides = std::vector<int>;

// Primal-dual interior-point method in the differences d_k = u_left - u_right. The common level of
// a tendon is eliminated by sum_i L_i T_i = S = sum_i E_i, which leaves, with y_i = u_i - u_0,
//
//   minimise S ln(sum_i L_i e^{y_i}) - sum_i E_i y_i + sum_k slip_k d_k / eps,  |d_k| <= phi_k,
//
// and for a loop sum_k d_k = 0. Frictionless contacts (d = 0) are no unknowns.
Sides contacts_at_a_bound(const Problem& problem);

}  // namespace reeve::testing::reference
