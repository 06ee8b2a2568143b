#include "tests/support/planting_rig.hpp"

#include <algorithm>

namespace reeve::testing {

double at_tendon(const Drive& drive, const Condition& condition) {
  const double loss = drive.loss_N + drive.loss_Ns_mm * condition.speed_mm_s.value_or(10);
  const double sign = condition.direction == ReferenceDirection::pull ? -1 : 1;
  return std::max(0.0, drive.gain * condition.motor_tension_N + drive.offset_N + sign * loss);
}

void apply(const Electronics& electronics, const std::vector<std::string>& channels, double place,
           std::map<std::string, double>& tension_N) {
  const auto& [one, other] = electronics.exchanged;
  if (tension_N.contains(one) && tension_N.contains(other)) {
    std::swap(tension_N.at(one), tension_N.at(other));
  }
  const std::map<std::string, double> clean = tension_N;
  const auto carried = [&](std::size_t column) {
    const auto found = column < channels.size() ? clean.find(channels[column]) : clean.end();
    return found == clean.end() ? 0 : found->second;
  };
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto reads = tension_N.find(channels[c]);
    if (reads == tension_N.end()) continue;
    if (const auto part = electronics.part_of_neighbours.find(channels[c]);
        part != electronics.part_of_neighbours.end()) {
      reads->second += part->second * ((c > 0 ? carried(c - 1) : 0) + carried(c + 1));
    }
    if (const auto limit = electronics.limit_N.find(channels[c]);
        limit != electronics.limit_N.end()) {
      reads->second = std::min(reads->second, limit->second);
    }
    if (const auto drift = electronics.drift_N.find(channels[c]);
        drift != electronics.drift_N.end()) {
      reads->second += drift->second * place;
    }
    if (electronics.dead.contains(channels[c])) reads->second = 0;
  }
}

}  // namespace reeve::testing
