#include "core/performance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reeve::core {
namespace {

// Ends tied at fingertips. A tip that the tendon runs round joins two strands.
int anchors(const Network& network) {
  const auto strands =
      std::count_if(network.segments.begin(), network.segments.end(),
                    [](const Segment& segment) { return segment.kind == SegmentKind::strand; });
  const auto tips =
      std::count_if(network.contacts.begin(), network.contacts.end(),
                    [](const Contact& contact) { return contact.place == ContactPlace::tip; });
  return static_cast<int>(strands - 2 * tips);
}

// Removes an excess over 1 of a few units in the last place. If nothing is lost, the products of
// tension and travel add up to 1 but for rounding. A larger excess is a fault of the solver and
// stays visible.
double without_gain(double efficiency) {
  constexpr double rounding = 1e-12;
  return efficiency > 1 && efficiency < 1 + rounding ? 1 : efficiency;
}

double least_over_greatest(const FingerPulls& pulls) {
  return pulls.greatest > 0 ? pulls.least / pulls.greatest : 0;
}

}  // namespace

FingerArray pulls_by_finger(const Network& network, const TensionState& state) {
  FingerArray pull{};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::strand) {
      pull[static_cast<std::size_t>(segment.finger)] += segment.way() * state.tension[i];
    }
  }
  return pull;
}

FingerPulls finger_pulls(const Network& network, const TensionState& state) {
  FingerArray pull = pulls_by_finger(network, state);
  for (double& each : pull) each = std::abs(each);
  const auto* const first = pull.begin() + 1;
  const auto [least, greatest] = std::minmax_element(first, first + network.fingers);
  return network.fingers == 0 ? FingerPulls{} : FingerPulls{*least, *greatest};
}

Performance performance(const StrandTally& tally, const FingerPulls& pulls) {
  Performance result;
  result.force_transmission = tally.sum;
  result.efficiency = without_gain(tally.work);
  const bool has_strands = tally.least <= tally.most;
  if (!has_strands) {
    result.uniformity = std::numeric_limits<double>::quiet_NaN();
    result.finger_uniformity = result.uniformity;
  } else if (tally.most > 0) {
    result.uniformity = tally.least / tally.most;
    result.finger_uniformity = least_over_greatest(pulls);
  }
  return result;
}

bool yields(const Network& network, const TensionState& state, std::size_t strand) {
  if (!network.shared || state.tension[strand] > 0) return false;
  const Segment& own = network.segments[strand];
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& other = network.segments[i];
    const bool is_antagonist = other.kind == SegmentKind::strand && other.finger == own.finger &&
                               other.extensor != own.extensor;
    if (is_antagonist && state.tension[i] > 0) return true;
  }
  return false;
}

namespace {

StrandTally strand_tally(const Network& network, const TensionState& state, Direction direction) {
  StrandTally tally;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind != SegmentKind::strand || yields(network, state, i)) continue;
    tally.add(state.tension[i],
              segment.way() * state.closing[static_cast<std::size_t>(segment.finger - 1)]);
  }
  const bool pull = direction == Direction::pull;
  const double gained = pull ? tally.work : state.motor_work;
  const double spent = pull ? state.motor_work : tally.work;
  tally.work = spent > 0 ? gained / spent : 0;
  return tally;
}

}  // namespace

Performance performance(const Network& network, const TensionState& state, Direction direction) {
  return performance(strand_tally(network, state, direction), finger_pulls(network, state));
}

Performance performance(const Network& network, const TensionState& state,
                        const FingerPulls& pulls) {
  return performance(strand_tally(network, state, Direction::pull), pulls);
}

double motor_efficiency(const Network& network, const TensionState& state, Direction direction) {
  return without_gain(strand_tally(network, state, direction).work);
}

double round_trip_efficiency(double pull_efficiency, double release_efficiency) {
  return pull_efficiency * release_efficiency;
}

namespace {

void count_bearing(const Contact& contact, PartCount& count) {
  ++count.pulleys;
  if (contact.place == ContactPlace::tip) ++count.tip_bearings;
  if (contact.place == ContactPlace::hand_join) ++count.fixed_pulleys;
  if (contact.place == ContactPlace::carriage) ++count.movable_pulleys;
}

// An end that is tied neither to the carriage nor to a block: at the hand, or at a fingertip.
bool is_untied(const Network& network, const TendonEnd& end, std::size_t segment) {
  return end.tie == EndTie::none && network.segments[segment].kind != SegmentKind::motor_side;
}

int untied_ends(const Network& network) {
  int ends = 0;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.closed) continue;
    if (is_untied(network, tendon.left, tendon.first_segment)) ++ends;
    if (is_untied(network, tendon.right, tendon.first_segment + tendon.segments - 1)) ++ends;
  }
  return ends;
}

}  // namespace

PartCount& PartCount::operator+=(const PartCount& other) {
  sheaths += other.sheaths;
  pulleys += other.pulleys;
  knots += other.knots;
  blocks += other.blocks;
  bars += other.bars;
  anchors += other.anchors;
  tip_bearings += other.tip_bearings;
  fixed_pulleys += other.fixed_pulleys;
  movable_pulleys += other.movable_pulleys;
  tubes += other.tubes;
  fixed_ends += other.fixed_ends;
  return *this;
}

PartCount parts(const Network& network) {
  PartCount count;
  for (const Contact& contact : network.contacts) {
    if (contact.kind == ContactKind::sheath) ++count.sheaths;
    if (contact.kind == ContactKind::tube) ++count.tubes;
    if (contact.kind == ContactKind::bearing) count_bearing(contact, count);
  }
  for (const Block& block : network.blocks) ++(block.is_bar ? count.bars : count.blocks);
  count.anchors = anchors(network);
  count.fixed_ends = untied_ends(network) - count.anchors;
  count.knots = static_cast<int>(std::count_if(network.tendons.begin(), network.tendons.end(),
                                               [](const TendonSpan& t) { return t.closed; }));
  return count;
}

}  // namespace reeve::core
