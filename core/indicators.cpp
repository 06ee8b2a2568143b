#include "core/indicators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reeve::core {

Indicators indicators(const Network& network, const TensionState& state) {
  constexpr double best = 10;
  double sum = 0;
  int motor_sides = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind == SegmentKind::strand) sum += state.tension[i];
    if (network.segments[i].kind == SegmentKind::motor_side) ++motor_sides;
  }
  if (!(sum > 0)) return {};
  double least_pull = std::numeric_limits<double>::infinity();
  double greatest_pull = 0;
  double twist = 0;
  double friction = 0;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const double drop = std::abs(state.tension[left] - state.tension[right]);
      friction = std::max(friction, drop);
      if (network.contacts[tendon.first_contact + k].place != ContactPlace::tip) continue;
      // A finger's strands meet at its tip, and nowhere else.
      twist = std::max(twist, drop);
      least_pull = std::min(least_pull, state.tension[left] + state.tension[right]);
      greatest_pull = std::max(greatest_pull, state.tension[left] + state.tension[right]);
    }
  }
  const double transmission = best * sum / (2.0 * network.fingers);
  return {best * (1 - (greatest_pull - least_pull) / sum), best * (1 - twist / sum),
          best * (1 - friction / sum), motor_sides * transmission, transmission};
}

}  // namespace reeve::core
