#include "tests/support/reference_numbers.hpp"

#include <algorithm>
#include <cstddef>
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

Real slack(const Tendon& tendon, const ReferenceHardware& hardware) {
  Real sum = 0;
  for (const Segment& segment : tendon.segments) {
    const auto found = hardware.slack.find(segment.name);
    if (found != hardware.slack.end()) sum += static_cast<Real>(found->second);
  }
  return sum;
}

}  // namespace reeve::testing::reference
