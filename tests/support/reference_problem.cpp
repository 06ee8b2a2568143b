#include "tests/support/reference_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reeve::testing::reference {

namespace {

Real nominal_phi(const std::string& kind, const ReferenceHardware& hardware) {
  const ReferenceLaw& law = kind == "tube"      ? hardware.tube
                            : kind == "bearing" ? hardware.bearing
                            : kind == "block"   ? hardware.block.value_or(hardware.bearing)
                                                : hardware.sheath;
  return law.mu * law.angle;
}

}  // namespace

bool tied(Real phi) { return phi < 1e-15L; }

bool tied(const Problem& problem, Index k) { return tied(problem.phi(k)); }

Vector exponents(const Tendon& tendon, const ReferenceHardware& hardware) {
  Vector phi(static_cast<Index>(tendon.kinds.size()));
  for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
    if (tendon.kinds[k] == "bar") {
      phi(static_cast<Index>(k)) = 0;
      continue;
    }
    const auto nominal = static_cast<double>(nominal_phi(tendon.kinds[k], hardware));
    const auto& left = tendon.segments[k].name;
    const auto& right = tendon.segments[(k + 1) % tendon.segments.size()].name;
    phi(static_cast<Index>(k)) =
        hardware.phi_override ? hardware.phi_override(left, right, nominal) : nominal;
  }
  return phi;
}

Vector lengths(const Tendon& tendon, const ReferenceHardware& hardware) {
  Vector length(static_cast<Index>(tendon.segments.size()));
  for (std::size_t i = 0; i < tendon.segments.size(); ++i) {
    const auto& [name, place, finger] = tendon.segments[i];
    const double nominal = place == Place::strand       ? hardware.strand_length
                           : place == Place::motor_side ? hardware.motor_side_length
                                                        : hardware.hand_length;
    length(static_cast<Index>(i)) =
        hardware.length_override ? hardware.length_override(name, nominal) : nominal;
  }
  return length;
}

double weight(int finger, const ReferenceHardware& hardware) {
  const auto found = hardware.closing_weight.find(finger);
  return found == hardware.closing_weight.end() ? 1.0 : found->second;
}

Real median_circulation(const Vector& phi, const Vector& slip) {
  std::vector<std::pair<Real, Real>> points;
  for (Index k = 0; k < phi.size(); ++k)
    if (!tied(phi(k))) points.emplace_back(-slip(k), phi(k));
  if (points.empty()) return 0;
  std::sort(points.begin(), points.end());
  const Real total = phi.sum();
  Real below = 0;
  std::size_t at = 0;
  while (below + points[at].second < total / 2 - 1e-14L * total) below += points[at++].second;
  const bool tie = below + points[at].second <= total / 2 + 1e-14L * total;
  const std::size_t next = std::min(at + 1, points.size() - 1);
  return tie ? (points[at].first + points[next].first) / 2 : points[at].first;
}

namespace {

// Slips that cancel e0: 0 = e0_i + s_i - s_{i-1}. Rounding must not turn rest into motion.
Vector zero_order_slips(const Vector& e0, const Vector& phi, bool loop) {
  Vector slip(phi.size());
  Real sum = 0;
  for (Index k = 0; k < slip.size(); ++k) slip(k) = -(sum += e0(k));
  if (loop) slip.array() += median_circulation(phi, slip);
  const Real noise = 1e-16L * e0.cwiseAbs().sum();
  return slip.unaryExpr([noise](Real s) { return std::abs(s) <= noise ? Real(0) : s; });
}

void impose_jam(const Tendon& tendon, ReferenceDirection direction, Problem& problem) {
  problem.jams = true;
  problem.slip.setZero(problem.phi.size());
  for (Index i = 0; i < problem.elastic.size(); ++i) {
    const bool motor_side = tendon.segments[static_cast<std::size_t>(i)].place == Place::motor_side;
    const bool pull = direction == ReferenceDirection::pull;
    problem.elastic(i) = motor_side != pull ? Real(0) : pull ? Real(1) : problem.length(i);
  }
}

// e0 is built in units of 1 / (the weights of all closing strands), in which it is exact, and
// divided afterwards.
void impose_motion(const Tendon& tendon, const std::map<int, Real>& weights, Real motor_sides,
                   ReferenceDirection direction, Problem& problem) {
  const bool pull = direction == ReferenceDirection::pull;
  Real unit = 0;
  for (const auto& segment : tendon.segments)
    if (const auto closing = weights.find(segment.finger); closing != weights.end())
      unit += closing->second;
  Vector e0 = Vector::Zero(problem.elastic.size());
  for (Index i = 0; i < e0.size(); ++i) {
    const auto& [name, place, finger] = tendon.segments[static_cast<std::size_t>(i)];
    const auto closing = weights.find(finger);
    if (place == Place::motor_side) {
      e0(i) = pull ? unit : -unit;
      problem.elastic(i) = pull ? 0 : 1;
    } else if (closing != weights.end()) {
      const Real give = motor_sides * closing->second;
      e0(i) = pull ? -give : give;
      problem.elastic(i) = pull ? give / unit : 0;
      problem.closing[finger] = static_cast<double>(give / unit);
    }
  }
  problem.slip = zero_order_slips(e0, problem.phi, problem.loop) / unit;
}

}  // namespace

Problem pose(const Tendon& tendon, const std::set<int>& held, ReferenceDirection direction,
             const ReferenceHardware& hardware) {
  Problem problem;
  problem.loop = tendon.loop;
  problem.length = lengths(tendon, hardware);
  problem.phi = exponents(tendon, hardware);
  problem.elastic = Vector::Zero(problem.length.size());
  const auto motor_sides =
      std::count_if(tendon.segments.begin(), tendon.segments.end(),
                    [](const Segment& s) { return s.place == Place::motor_side; });
  if (motor_sides == 0) throw std::invalid_argument("a tendon has no motor-side segment");
  std::map<int, Real> weights;
  for (const int finger : tendon.fingers)
    if (!held.contains(finger) && weight(finger, hardware) > 0)
      weights[finger] = weight(finger, hardware);
  if (weights.empty())
    impose_jam(tendon, direction, problem);
  else
    impose_motion(tendon, weights, static_cast<Real>(motor_sides), direction, problem);
  return problem;
}

}  // namespace reeve::testing::reference
