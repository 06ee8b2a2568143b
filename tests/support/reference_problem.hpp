// One tendon's problem of the reference model, in numbers.
#pragma once

#include <Eigen/Core>

#include <map>
#include <set>

#include "tests/support/reference_model.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing::reference {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Index = Eigen::Index;

struct Problem {
  bool loop = false;
  bool jams = false;
  Vector length, elastic, phi;    // L, E, phi
  Vector slip;                    // zero-order slip of each contact, D = 1
  std::map<int, double> closing;  // of the fingers that close
};

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
bool tied(const Problem& problem, Index k);

// Throws std::invalid_argument for a tendon without a motor-side segment.
Problem pose(const Tendon& tendon, const std::set<int>& held, ReferenceDirection direction,
             const ReferenceHardware& hardware);

// The same of a tendon that shares fingers with others, which close so; nothing is imposed on a
// slack one.
Problem pose_shared(const Tendon& tendon, const std::map<int, Real>& closing, bool slack,
                    ReferenceDirection direction, const ReferenceHardware& hardware);

}  // namespace reeve::testing::reference
