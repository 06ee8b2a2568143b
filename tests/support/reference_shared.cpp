#include "tests/support/reference_shared.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace reeve::testing::reference {

namespace {

constexpr Real tolerance = 1e-12L;

struct Shared {
  Matrix takes;   // tendon by finger: strands, an extensor's counted as -1
  Matrix closes;  // finger by tendon: w_f, or -w_f
  Vector travel;
  std::vector<bool> pulled;
};

Shared shared(const std::vector<Tendon>& tendons, const std::set<int>& held,
              const ReferenceHardware& hardware) {
  const auto n = static_cast<Index>(tendons.size());
  constexpr Index fingers = 65;
  Shared all{Matrix::Zero(n, fingers), Matrix::Zero(fingers, n), Vector::Zero(n), {}};
  for (Index t = 0; t < n; ++t) {
    bool pulled = false;
    for (const Segment& segment : tendons[static_cast<std::size_t>(t)].segments) {
      all.travel(t) += travel(segment, hardware);
      pulled |= travel(segment, hardware) > 0;
      if (segment.finger == 0 || held.contains(segment.finger)) continue;
      all.takes(t, segment.finger) += segment.extensor ? -1 : 1;
      Real& closes = all.closes(segment.finger, t);
      const Real w = weight(segment.finger, hardware);
      closes = segment.extensor && !(closes > 0) ? -w : w;
    }
    all.pulled.push_back(pulled);
  }
  return all;
}

// The amounts q if just this set is taut; nothing if its equations cannot be met.
bool solve(const Shared& all, const std::vector<Index>& taut, Vector& q) {
  q = Vector::Zero(all.travel.size());
  if (taut.empty()) return true;
  const Matrix whole = all.takes * all.closes;
  const Matrix part = whole(taut, taut);
  const Vector right = all.travel(taut);
  const Vector found = part.fullPivLu().solve(right);
  if ((part * found - right).cwiseAbs().maxCoeff() > tolerance) return false;
  q(taut) = found;
  return found.minCoeff() > -tolerance;
}

}  // namespace

bool share_fingers(const std::vector<Tendon>& tendons) {
  std::set<int> seen;
  for (const Tendon& tendon : tendons) {
    for (const Segment& segment : tendon.segments)
      if (segment.extensor) return true;
    for (const int finger : tendon.fingers)
      if (!seen.insert(finger).second) return true;
  }
  return false;
}

SharedMotion shared_motion(const std::vector<Tendon>& tendons, const std::set<int>& held,
                           const ReferenceHardware& hardware) {
  for (const Tendon& tendon : tendons)
    if (!tendon.passes.empty() || !tendon.ends.empty())
      throw std::invalid_argument("the reference model: blocks join tendons that share fingers");
  const Shared all = shared(tendons, held, hardware);
  SharedMotion found;
  for (std::size_t set = 0; set < std::size_t{1} << tendons.size(); ++set) {
    std::vector<Index> taut;
    bool pulled = true;
    for (std::size_t t = 0; t < tendons.size(); ++t) {
      if ((set >> t & 1U) == 0) continue;
      taut.push_back(static_cast<Index>(t));
      pulled &= all.pulled[t];
    }
    Vector q;
    if (!pulled || !solve(all, taut, q)) continue;
    const Vector dl = all.closes * q;
    const Vector room = all.takes * dl - all.travel;
    if (room.minCoeff() < -tolerance) continue;
    found.possible = true;
    for (const Tendon& tendon : tendons)
      for (const int finger : tendon.fingers)
        if (!held.contains(finger)) found.closing[finger] = dl(finger);
    for (std::size_t t = 0; t < tendons.size(); ++t)
      found.slack.push_back(!all.pulled[t] || room(static_cast<Index>(t)) > 1e-9L);
    return found;
  }
  return found;
}

}  // namespace reeve::testing::reference
