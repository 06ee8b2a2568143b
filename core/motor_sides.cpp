#include "core/motor_sides.hpp"

#include <algorithm>

namespace reeve::core {

std::vector<MotorSide> motor_sides(const Network& network) {
  std::vector<MotorSide> result;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (network.contacts[tendon.first_contact + k].kind != ContactKind::sheath) continue;
      const ContactEnds ends = ends_of(tendon, k);
      const bool left = network.segments[ends.left].kind == SegmentKind::motor_side;
      result.push_back(left ? MotorSide{ends.left, ends.right} : MotorSide{ends.right, ends.left});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const MotorSide& a, const MotorSide& b) { return a.motor_side < b.motor_side; });
  return result;
}

MotorEnds motor_ends(const Network& network) {
  MotorEnds ends;
  const auto bit = [](const Segment& side) { return std::uint64_t{1} << (side.number - 1); };
  for (const Segment& segment : network.segments) {
    if (segment.kind == SegmentKind::motor_side && segment.number <= most_lockable) {
      ends.push_back(bit(segment));
    }
  }
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (network.contacts[tendon.first_contact + k].place != ContactPlace::carriage) continue;
      const auto [left, right] = ends_of(tendon, k);
      const Segment& l = network.segments[left];
      const Segment& r = network.segments[right];
      if (l.number > most_lockable || r.number > most_lockable) continue;
      ends[static_cast<std::size_t>(l.number) - 1] |= bit(r);
      ends[static_cast<std::size_t>(r.number) - 1] |= bit(l);
    }
  }
  return ends;
}

int carriage_count(const Network& network) {
  int count = 0;
  for (const Segment& segment : network.segments) {
    if (segment.kind == SegmentKind::motor_side) count = std::max(count, segment.carriage);
  }
  return count;
}

std::string motor_name(int carriage) {
  return carriage == 1 ? "M" : "M" + std::to_string(carriage);
}

std::optional<Segment> motor_side_at(const Network& network, const Segment& strand) {
  for (const MotorSide& side : motor_sides(network)) {
    if (network.segments[side.hand] == strand) return network.segments[side.motor_side];
  }
  return std::nullopt;
}

bool letters_match_strands(const Network& network) {
  const std::vector<MotorSide> sides = motor_sides(network);
  return std::all_of(sides.begin(), sides.end(), [&](const MotorSide& side) {
    const Segment& hand = network.segments[side.hand];
    return hand.kind != SegmentKind::strand ||
           hand.number == network.segments[side.motor_side].number;
  });
}

}  // namespace reeve::core
