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
    const auto [left, right] = tendon.sides(k);
    phi(static_cast<Index>(k)) =
        hardware.phi_override ? hardware.phi_override(left, right, nominal) : nominal;
  }
  return phi;
}

Vector lengths(const Tendon& tendon, const ReferenceHardware& hardware) {
  Vector length(static_cast<Index>(tendon.segments.size()));
  for (std::size_t i = 0; i < tendon.segments.size(); ++i) {
    const auto& [name, place, finger, carriage, extensor] = tendon.segments[i];
    const double nominal = place == Place::strand       ? hardware.strand_length
                           : place == Place::motor_side ? hardware.motor_side_length
                                                        : hardware.hand_length;
    length(static_cast<Index>(i)) =
        hardware.length_override ? hardware.length_override(name, nominal) : nominal;
  }
  return length;
}

double spool(const Segment& segment, const ReferenceHardware& hardware) {
  if (hardware.locked.contains(segment.name)) return 0;
  const auto found = hardware.spool.find(segment.name);
  return found == hardware.spool.end() ? 1.0 : found->second;
}

Real travel(const Segment& segment, const ReferenceHardware& hardware) {
  if (segment.place != Place::motor_side) return 0;
  const auto found = hardware.carriage_travel.find(segment.carriage);
  const Real r = spool(segment, hardware);
  return found == hardware.carriage_travel.end() ? r : r * static_cast<Real>(found->second);
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

void impose_jam(const Tendon& tendon, ReferenceDirection direction,
                const ReferenceHardware& hardware, Problem& problem) {
  problem.jams = true;
  problem.slip.setZero(problem.phi.size());
  for (Index i = 0; i < problem.elastic.size(); ++i) {
    const Segment& segment = tendon.segments[static_cast<std::size_t>(i)];
    const bool pull = direction == ReferenceDirection::pull;
    const bool hand_side = segment.place != Place::motor_side;
    problem.elastic(i) = pull ? travel(segment, hardware) : hand_side ? problem.length(i) : Real(0);
  }
}

// e0 is built in units of 1 / (the weights of all closing strands), in which it is exact, and
// divided afterwards.
void impose_motion(const Tendon& tendon, const std::map<int, Real>& weights, Real motor_sides,
                   ReferenceDirection direction, const ReferenceHardware& hardware,
                   Problem& problem) {
  const bool pull = direction == ReferenceDirection::pull;
  Real unit = 0;
  for (const auto& segment : tendon.segments)
    if (const auto closing = weights.find(segment.finger); closing != weights.end())
      unit += closing->second;
  if (weights.empty()) unit = 1;
  Vector e0 = Vector::Zero(problem.elastic.size());
  for (Index i = 0; i < e0.size(); ++i) {
    const Segment& segment = tendon.segments[static_cast<std::size_t>(i)];
    const int finger = segment.finger;
    const auto closing = weights.find(finger);
    if (segment.place == Place::motor_side) {
      const Real way = pull ? travel(segment, hardware) : -travel(segment, hardware);
      e0(i) = way * unit;
      problem.elastic(i) = way < 0 ? -way : 0;
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

Real slack(const Tendon& tendon, const ReferenceHardware& hardware) {
  Real sum = 0;
  for (const Segment& segment : tendon.segments) {
    const auto found = hardware.slack.find(segment.name);
    if (found != hardware.slack.end()) sum += static_cast<Real>(found->second);
  }
  return sum;
}

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
  Real motor_travel = 0;
  for (const Segment& segment : tendon.segments) motor_travel += travel(segment, hardware);
  const Real loose = slack(tendon, hardware);
  if (loose > 0 && motor_travel <= loose) {
    problem.slip.setZero(problem.phi.size());
    return problem;
  }
  if (motor_travel < 0) throw std::invalid_argument("a finger would have to open");
  if (motor_sides == 0) throw std::invalid_argument("a tendon has no motor-side segment");
  std::map<int, Real> weights;
  for (const int finger : tendon.fingers)
    if (!held.contains(finger) && weight(finger, hardware) > 0)
      weights[finger] = weight(finger, hardware);
  if (weights.empty() && motor_travel > 0)
    impose_jam(tendon, direction, hardware, problem);
  else
    impose_motion(tendon, weights, motor_travel, direction, hardware, problem);
  if (loose > 0) problem.elastic *= 1 - loose / motor_travel;
  return problem;
}

Problem pose_shared(const Tendon& tendon, const std::map<int, Real>& closing, bool slack,
                    ReferenceDirection direction, const ReferenceHardware& hardware) {
  Problem problem;
  problem.length = lengths(tendon, hardware);
  problem.phi = exponents(tendon, hardware);
  problem.elastic = Vector::Zero(problem.length.size());
  problem.slip = Vector::Zero(problem.phi.size());
  Vector e0 = problem.elastic;
  for (Index i = 0; i < e0.size(); ++i) {
    const Segment& segment = tendon.segments[static_cast<std::size_t>(i)];
    e0(i) = travel(segment, hardware);
    const auto found = closing.find(segment.finger);
    if (found == closing.end()) continue;
    e0(i) = segment.extensor ? found->second : -found->second;
    problem.closing[segment.finger] = static_cast<double>(found->second);
  }
  if (slack) return problem;
  if (direction == ReferenceDirection::release) e0 = -e0;
  for (Index i = 0; i < e0.size(); ++i) problem.elastic(i) = e0(i) < 0 ? -e0(i) : 0;
  problem.slip = zero_order_slips(e0, problem.phi, false);
  return problem;
}

}  // namespace reeve::testing::reference
