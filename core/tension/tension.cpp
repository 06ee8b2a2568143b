#include "core/tension/tension.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/motor_sides.hpp"

namespace reeve::core {
namespace {

// Tolerance of the inequality between rounded products that decides if a loop may be opened.
constexpr double cone_tolerance = 1e-12;

// Virtual work: a spool of radius r pulls the carriage with r times its tendon's tension, and a
// locked end with nothing.
void scale_to_unit_motor_tension(const Network& network, const Mechanics& mechanics,
                                 const Grasp& grasp, TensionState& state) {
  double motor = 0;
  state.motor_tension.fill(0);
  for (std::size_t i = 0; i < state.tension.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind != SegmentKind::motor_side || grasp.locks(segment.number)) continue;
    const double pull = mechanics.spool(i) * state.tension[i];
    state.motor_tension[static_cast<std::size_t>(segment.carriage) - 1] += pull;
    motor += pull;
  }
  for (double& t : state.tension) t /= motor;
  for (double& t : state.motor_tension) t /= motor;
  if (motor == 0 && state.in_range) state.fault = TensionFault::nothing_pulls;
  if (motor < 0 && state.in_range) state.fault = TensionFault::motor_is_pulled;
  state.in_range &= motor > 0 && std::isnormal(motor);
}

// Exactly 1 if all carriages travel D.
double motor_work(const Grasp& grasp, const TensionState& state) {
  double work = 1;
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    work += (grasp.carriages.over_D[motor] - 1) * state.motor_tension[motor];
  }
  return work;
}

void make_absolute(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
                   TensionState& state) {
  scale_to_unit_motor_tension(network, mechanics, grasp, state);
  state.motor_work = motor_work(grasp, state);
  if (!state.in_range) {
    std::fill(state.tension.begin(), state.tension.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

double sliding_exponent(const Network& network, const Mechanics& mechanics, std::size_t contact,
                        const TensionState& state) {
  const bool alike =
      guide_use(network, mechanics, contact, state.slip, state.closing) == GuideUse::alike;
  return mechanics.phi[contact] - (alike ? mechanics.guides(contact) : 0);
}

void TensionSolver::solve_open(const Network& network, const TendonSpan& tendon,
                               const Mechanics& mechanics, std::size_t first, TensionState& state) {
  const std::size_t n = tendon.segments;
  segments_.clear();
  contacts_.clear();
  places_.clear();
  std::size_t before = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t k = first + j < n ? first + j : first + j - n;
    places_.push_back(segments_.size());
    segments_.push_back(
        {mechanics.length[tendon.first_segment + k], motion_.take_up[tendon.first_segment + k]});
    if (j > 0) add_contact(network, mechanics, tendon, tendon.first_contact + before);
    before = k;
  }
  chain_tension_.resize(segments_.size());
  chain_.solve(segments_, contacts_, chain_tension_);
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t k = first + j < n ? first + j : first + j - n;
    const double tension = chain_tension_[places_[j]];
    state.in_range &= std::isnormal(tension);
    state.tension[tendon.first_segment + k] = tension;
  }
}

// Between the last two segments. A strand that rests at its palm end as its finger closes has its
// guides apart, and between them and the tip a stretch without length, which takes up what the
// strand does. As the finger opens, the strand takes nothing up, and its guides slide with the tip.
void TensionSolver::add_contact(const Network& network, const Mechanics& mechanics,
                                const TendonSpan& tendon, std::size_t contact) {
  const Slide slide = slide_at(network, mechanics, motion_, tendon, contact);
  const bool rests_left = slide == Slide::to_right;
  ChainSegment& strand = *(segments_.end() - (rests_left ? 2 : 1));
  if (slide == Slide::no || strand.take_up == 0 ||
      guide_use(network, mechanics, contact, motion_.slip, motion_.closing) !=
          GuideUse::one_strand_rests) {
    contacts_.push_back({mechanics.decay[contact], slide});
    return;
  }
  const double resting = std::exp(-mechanics.guides(contact) / 2);
  const ChainContact guides{resting, Slide::no};
  const ChainContact tip{mechanics.decay[contact] / resting, slide};
  const ChainSegment behind{0, std::exchange(strand.take_up, 0)};
  segments_.insert(segments_.end() - 1, behind);
  ++places_.back();
  contacts_.push_back(rests_left ? guides : tip);
  contacts_.push_back(rests_left ? tip : guides);
}

// The forces at a loop's contacts are determined up to one that goes round: it can be chosen such
// that some still contact carries none and no other pulls the wrong way. The chain that is opened
// there has the loop's tensions, which lie in that contact's cone.
void TensionSolver::solve_loop(const Network& network, const TendonSpan& tendon,
                               const Mechanics& mechanics, TensionState& state) {
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    const std::size_t contact = tendon.first_contact + k;
    if (slide_at(network, mechanics, motion_, tendon, contact) != Slide::no) continue;
    const auto [left, right] = ends_of(tendon, k);
    solve_open(network, tendon, mechanics, right - tendon.first_segment, state);
    const auto [low, high] = std::minmax(state.tension[left], state.tension[right]);
    if (high * mechanics.decay[contact] <= low * (1 + cone_tolerance)) return;
  }
}

void TensionSolver::solve_tendon(const Network& network, const TendonSpan& tendon,
                                 const Mechanics& mechanics, TensionState& state) {
  if (tendon.closed) {
    solve_loop(network, tendon, mechanics, state);
  } else {
    solve_open(network, tendon, mechanics, 0, state);
  }
}

void TensionSolver::solve_tree(const Network& network, const Mechanics& mechanics, std::size_t tree,
                               TensionState& state) {
  state.in_range &= tree_tension_.solve(network, mechanics, motion_, tree, state.tension);
}

// A tree is solved with the first of its tendons that is taut.
bool TensionSolver::begins_tree(const Network& network, std::size_t tendon) const {
  for (std::size_t t = network.tendons[tendon].tree; t < tendon; ++t) {
    if (network.tendons[t].tree == network.tendons[tendon].tree && !motion_.is_slack(t)) {
      return false;
    }
  }
  return true;
}

void TensionSolver::solve_tendons(const Network& network, const Mechanics& mechanics,
                                  TensionState& state) {
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (motion_.is_slack(t) || (state.jams && motion_.jams[t] == 0)) {
      const auto first = state.tension.begin() + static_cast<std::ptrdiff_t>(tendon.first_segment);
      std::fill_n(first, tendon.segments, 0.0);
    } else if (!is_tied(network, tendon)) {
      solve_tendon(network, tendon, mechanics, state);
    } else if (begins_tree(network, t)) {
      solve_tree(network, mechanics, tendon.tree, state);
    }
  }
}

const Mechanics& TensionSolver::past_guides(const Network& network, const Mechanics& mechanics) {
  if (mechanics.guided_tips.empty()) return mechanics;
  past_guides_ = mechanics;
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    if (guide_use(network, mechanics, k, motion_.slip, motion_.closing) != GuideUse::alike)
      continue;
    past_guides_.phi[k] -= mechanics.guides(k);
    past_guides_.decay[k] = std::exp(-past_guides_.phi[k]);
  }
  return past_guides_;
}

void TensionSolver::solve_in_motion(const Network& network, const Mechanics& mechanics,
                                    TensionState& state) {
  state.tension.resize(network.segments.size());
  state.jams = std::find(motion_.jams.begin(), motion_.jams.end(), 1) != motion_.jams.end();
  state.fault = motion_.fault;
  state.opposed = motion_.opposed;
  state.in_range = mechanics.in_range && state.fault == TensionFault::none;
  solve_tendons(network, past_guides(network, mechanics), state);
  state.slip.swap(motion_.slip);
  state.closing.swap(motion_.closing);
  state.block_travel.swap(motion_.block_travel);
}

void TensionSolver::solve_relative(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                   Direction direction, TensionState& state) {
  kinematics_.solve(network, mechanics, grasp, direction, motion_);
  solve_in_motion(network, mechanics, state);
}

void TensionSolver::solve(const Network& network, const Mechanics& mechanics, Grasp grasp,
                          Direction direction, TensionState& state) {
  solve_relative(network, mechanics, grasp, direction, state);
  make_absolute(network, mechanics, grasp, state);
}

void TensionSolver::solve_relative_again(const Network& network, const Mechanics& mechanics,
                                         Grasp grasp, Direction direction, TensionState& state) {
  const bool has_loop = std::ranges::any_of(network.tendons, &TendonSpan::closed);
  if (has_loop) {
    solve_relative(network, mechanics, grasp, direction, state);
    return;
  }
  state.slip.swap(motion_.slip);
  state.closing.swap(motion_.closing);
  state.block_travel.swap(motion_.block_travel);
  solve_in_motion(network, mechanics, state);
}

void TensionSolver::solve_again(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                Direction direction, TensionState& state) {
  solve_relative_again(network, mechanics, grasp, direction, state);
  make_absolute(network, mechanics, grasp, state);
}

std::vector<double> motor_tensions(const Network& network, const TensionState& state) {
  const auto* const first = state.motor_tension.begin();
  return {first, first + carriage_count(network)};
}

const TensionState& require_in_range(const TensionState& state, Grasp grasp) {
  if (state.in_range) return state;
  throw OutOfRange("held " + to_text(grasp) +
                   ": the motor tension cannot be computed: " + words_of(state.fault));
}

TensionState tensions(const Network& network, const Mechanics& mechanics, Grasp grasp,
                      Direction direction) {
  TensionState state;
  TensionSolver().solve(network, mechanics, grasp, direction, state);
  return require_in_range(state, grasp);
}

}  // namespace reeve::core
