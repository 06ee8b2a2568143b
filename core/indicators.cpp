#include "core/indicators.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::core {

double ClosingAlike::given_up(const Network& network, const Mechanics& mechanics) {
  double sum = 0;
  if (network.blocks.empty() && !network.shared) {
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      if (network.segments[i].kind == SegmentKind::motor_side) sum += mechanics.spool(i);
    }
    return sum;
  }
  // Only travels count here; friction and lengths do not change them.
  mechanics_.length.assign(network.segments.size(), 1);
  mechanics_.phi.assign(network.contacts.size(), 0);
  mechanics_.decay.assign(network.contacts.size(), 1);
  mechanics_.closing.assign(static_cast<std::size_t>(network.fingers), 1);
  mechanics_.spools = mechanics.spools;
  kinematics_.solve(network, mechanics_, Grasp{}, Direction::pull, motion_);
  for (const Segment& segment : network.segments) {
    if (segment.kind != SegmentKind::strand) continue;
    sum += segment.way() * motion_.closing[static_cast<std::size_t>(segment.finger - 1)];
  }
  return sum;
}

Indicators indicators(const Network& network, const TensionState& state) {
  return indicators(network, state, finger_pulls(network, state),
                    ClosingAlike().given_up(network, {}));
}

Indicators indicators(const Network& network, const TensionState& state, const FingerPulls& pulls,
                      double given_up) {
  constexpr double best = 10;
  double sum = 0;
  int strands = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind != SegmentKind::strand) continue;
    sum += state.tension[i];
    ++strands;
  }
  if (!(sum > 0)) return {};
  double twist = 0;
  double friction = 0;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const Contact& contact = network.contacts[tendon.first_contact + k];
      if (contact.kind == ContactKind::bar) continue;
      const auto [left, right] = ends_of(tendon, k);
      const double drop = std::abs(state.tension[left] - state.tension[right]);
      friction = std::max(friction, drop);
      // A finger's strands meet at its tip, and nowhere else.
      if (contact.place == ContactPlace::tip) twist = std::max(twist, drop);
    }
  }
  const double transmission = best * sum / strands;
  return {best * (1 - (pulls.greatest - pulls.least) / sum), best * (1 - twist / sum),
          best * (1 - friction / sum), given_up * transmission, transmission};
}

}  // namespace reeve::core
