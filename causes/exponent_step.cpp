#include "causes/exponent_step.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::causes {
namespace {

// Relative tolerance; the tensions are exact products of ratios but for rounding.
constexpr double limit_tolerance = 1e-12;
// A factor e: further than that a first order does not see.
constexpr double most_motion = 1;
// Least 1 - slope. A step has no bound if an exponent rises almost as fast as the tension that it
// raises.
constexpr double least_stiffness = 0.1;

bool is_at_limit(double left, double right, double decay) {
  const double high = std::max(left, right);
  return std::abs(std::min(left, right) - high * decay) <= limit_tolerance * high;
}

// Returns the first segment behind a contact inside its cone; 0 on an open tendon. A loop always
// has such a contact, up to rounding.
std::size_t first_of_runs(const TendonSpan& tendon, const std::vector<double>& tension,
                          const Mechanics& mechanics) {
  for (std::size_t k = 0; tendon.closed && k < tendon.contacts; ++k) {
    const auto [left, right] = ends_of(tendon, k);
    const double decay = mechanics.decay[tendon.first_contact + k];
    if (!is_at_limit(tension[left], tension[right], decay)) return right - tendon.first_segment;
  }
  return 0;
}

}  // namespace

void ExponentStep::go_on(const Place& place, std::size_t contact, std::size_t from,
                         std::size_t to) {
  const double way = place.errors.way[contact];
  const double slope = place.errors.slope[contact];
  if (place.tension[from] >= place.tension[to]) {
    gain_[to] = gain_[from] - slope * gain_[from];
    shift_[to] = shift_[from] - (way + slope * shift_[from]);
  } else {
    const double stiffness = std::max(1 - slope, least_stiffness);
    gain_[to] = gain_[from] / stiffness;
    shift_[to] = (shift_[from] + way) / stiffness;
  }
}

void ExponentStep::end_run(const Place& place) {
  double weight = 0;
  double gain = 0;
  double shift = 0;
  for (const std::size_t i : run_) {
    const double strain = place.mechanics.length[i] * place.tension[i];
    weight += strain;
    gain += strain * gain_[i];
    shift += strain * shift_[i];
  }
  for (const std::size_t i : run_) {
    shift_[i] -= gain_[i] * shift / gain;
    gain_[i] *= weight / gain;
    if (place.network.segments[i].kind != SegmentKind::motor_side) continue;
    const double pull = place.mechanics.spool(i) * place.tension[i];
    motor_gain_ += pull * gain_[i];
    motor_shift_ += pull * shift_[i];
  }
  run_.clear();
}

void ExponentStep::relate(const Place& place, const TendonSpan& tendon) {
  const std::size_t first = first_of_runs(tendon, place.tension, place.mechanics);
  for (std::size_t j = 0; j < tendon.segments; ++j) {
    const std::size_t k = first + j < tendon.segments ? first + j : first + j - tendon.segments;
    const std::size_t segment = tendon.first_segment + k;
    if (run_.empty()) {
      gain_[segment] = 1;
      shift_[segment] = 0;
    }
    run_.push_back(segment);
    if (j + 1 == tendon.segments) break;
    const std::size_t contact = tendon.first_contact + k;
    const std::size_t next = ends_of(tendon, k).right;
    if (is_at_limit(place.tension[segment], place.tension[next], place.mechanics.decay[contact])) {
      go_on(place, contact, segment, next);
    } else {
      end_run(place);
    }
  }
  end_run(place);
}

double ExponentStep::motion(std::size_t segment) const {
  return std::clamp(gain_[segment] * scale_ + shift_[segment], -most_motion, most_motion);
}

const std::vector<double>& ExponentStep::changes(const Network& network, const Mechanics& mechanics,
                                                 const TensionState& state,
                                                 const ExponentErrors& errors,
                                                 Prescribed prescribed) {
  changes_ = errors.way;
  const Place place{network, mechanics, state.tension, errors};
  gain_.resize(network.segments.size());
  shift_.resize(network.segments.size());
  motor_gain_ = 0;
  motor_shift_ = 0;
  // Tendons are slack where others jam.
  const auto is_slack = [&](const TendonSpan& tendon) {
    return state.tension[tendon.first_segment] == 0;
  };
  for (const TendonSpan& tendon : network.tendons) {
    if (!is_slack(tendon)) relate(place, tendon);
  }
  scale_ = prescribed == Prescribed::take_up ? 0 : -motor_shift_ / motor_gain_;
  for (const TendonSpan& tendon : network.tendons) {
    if (is_slack(tendon)) continue;
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const std::size_t high = state.tension[left] >= state.tension[right] ? left : right;
      const std::size_t contact = tendon.first_contact + k;
      changes_[contact] += errors.slope[contact] * motion(high);
    }
  }
  return changes_;
}

}  // namespace reeve::causes
