// Lengths, exponents and travels of a tendon's segments and contacts, by the reference model.
#pragma once

#include <Eigen/Core>

#include "tests/support/reference_model.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing::reference {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Index = Eigen::Index;

// Of the segments and contacts of one tendon. A bar has no friction.
Vector lengths(const Tendon& tendon, const ReferenceHardware& hardware);
Vector exponents(const Tendon& tendon, const ReferenceHardware& hardware);

// 0 of a locked end.
double spool(const Segment& segment, const ReferenceHardware& hardware);

// r v_c; 0 of a segment that is no motor side.
Real travel(const Segment& segment, const ReferenceHardware& hardware);

// s / D of the whole tendon.
Real slack(const Tendon& tendon, const ReferenceHardware& hardware);

double weight(int finger, const ReferenceHardware& hardware);

// The c that minimises sum_k phi_k |slip_k + c| over the contacts with friction; the middle of them
// all if there are many.
Real median_circulation(const Vector& phi, const Vector& slip);

// Whether a contact is taken as frictionless.
bool tied(Real phi);

}  // namespace reeve::testing::reference
