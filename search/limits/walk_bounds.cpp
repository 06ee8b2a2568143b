#include "search/limits/walk_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reeve::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

int WalkBounds::Flow::slip_at_tip(int finger, int motor_sides_before) const {
  const int strands = 2 * finger - 1 - (held == 0 || held > finger ? 0 : held == finger ? 1 : 2);
  return strands * motor_sides - motor_sides_before * closing;
}

int WalkBounds::Flow::slip_behind(int finger, int motor_sides_before) const {
  const int strands = 2 * finger - (held > 0 && held <= finger ? 2 : 0);
  return strands * motor_sides - motor_sides_before * closing;
}

WalkBounds::WalkBounds(const Hardware& hardware, const PartSet& parts, int fingers,
                       double motor_beside)
    : parts_(parts),
      fingers_(fingers),
      motor_beside_(motor_beside),
      strand_mm_(hardware.strand_mm),
      motor_side_mm_(hardware.motor_side_mm),
      first_bounded_(fingers / 2 + 1) {
  const auto law = [](const ContactLaw& given) {
    return Law{std::exp(-given.exponent()), std::exp(given.exponent())};
  };
  tube_ = law(hardware.tube);
  bearing_ = law(hardware.bearing);
  sheath_ = law(hardware.sheath);
  constexpr Costs of_most{0, 1e-4, 4e-4, 1.6e-3, 6.4e-3, 0.0256, 0.1, 0.4, 1};
  for (std::size_t i = 0; i < lambdas; ++i) lambda_[i] = of_most[i] * sheath_.decay;
  const auto bounded = static_cast<std::size_t>(fingers_ - first_bounded_) + 1;
  const auto sides = static_cast<std::size_t>(most_motor_sides()) + 1;
  costs_.resize(sides * (static_cast<std::size_t>(fingers_) + 1) * bounded * sides);
  for (int m = 1; m <= most_motor_sides(); ++m) {
    for (int held = 0; held <= fingers_; ++held) find_costs(flow(m, held));
  }
  levels_.resize(static_cast<std::size_t>(fingers_) + 1);
  for (Level& level : levels_) {
    level.beginnings.resize(sides * (static_cast<std::size_t>(fingers_) + 1));
  }
}

WalkBounds::Flow WalkBounds::flow(int motor_sides, int held) const {
  return {motor_sides, 2 * (held > 0 ? fingers_ - 1 : fingers_), held, motor_beside_ / motor_sides};
}

std::size_t WalkBounds::index(int motor_sides, int held) const {
  return static_cast<std::size_t>(motor_sides) * (static_cast<std::size_t>(fingers_) + 1) +
         static_cast<std::size_t>(held);
}

WalkBounds::Costs& WalkBounds::costs(int motor_sides, int held, int finger,
                                     int motor_sides_before) {
  const auto bounded = static_cast<std::size_t>(fingers_ - first_bounded_) + 1;
  const auto sides = static_cast<std::size_t>(most_motor_sides()) + 1;
  const auto bounded_finger = static_cast<std::size_t>(finger - first_bounded_);
  return costs_[(index(motor_sides, held) * bounded + bounded_finger) * sides +
                static_cast<std::size_t>(motor_sides_before)];
}

void WalkBounds::find_costs(const Flow& flow) {
  for (int finger = fingers_; finger >= first_bounded_; --finger) {
    for (int before = 0; before <= flow.motor_sides; ++before) {
      costs(flow.motor_sides, flow.held, finger, before) = from_tip(flow, finger, before);
    }
  }
}

WalkBounds::Costs WalkBounds::from_tip(const Flow& flow, int finger, int before) {
  const Costs behind =
      at_length(flow, strand_mm_,
                finger == fingers_ ? of_last(flow, before) : behind_finger(flow, finger, before));
  Costs least;
  least.fill(infinity);
  for (const TipKind kind : parts_.tips) {
    const Costs with = crossed(flow, kind == TipKind::tube ? tube_ : bearing_,
                               flow.slip_at_tip(finger, before), At::hand, behind);
    for (std::size_t i = 0; i < lambdas; ++i) least[i] = std::min(least[i], with[i]);
  }
  return least;
}

WalkBounds::Costs WalkBounds::behind_finger(const Flow& flow, int finger, int before) {
  Costs least;
  least.fill(infinity);
  const auto slip = [&](int more) { return flow.slip_behind(finger, before + more); };
  for (const TokenKind join : parts_.joins) {
    const bool on_carriage = join == TokenKind::movable_pulley;
    if (before + (on_carriage ? 2 : 0) > flow.motor_sides) continue;
    Costs rest = costs(flow.motor_sides, flow.held, finger + 1, before + (on_carriage ? 2 : 0));
    rest = at_length(flow, strand_mm_, rest);
    if (on_carriage) {
      rest = at_motor_side(flow, crossed(flow, sheath_, slip(2), At::carriage, rest));
      rest = at_motor_side(flow, crossed(flow, bearing_, slip(1), At::carriage, rest));
      rest = crossed(flow, sheath_, slip(0), At::carriage, rest);
    } else {
      const Law& law = join == TokenKind::tube_join ? tube_ : bearing_;
      rest = crossed(flow, law, slip(0), At::hand, rest);
    }
    for (std::size_t i = 0; i < lambdas; ++i) least[i] = std::min(least[i], rest[i]);
  }
  return least;
}

// The tendon's end, behind the last finger.
WalkBounds::Costs WalkBounds::of_last(const Flow& flow, int before) const {
  const TokenKind end = before == flow.motor_sides ? TokenKind::fixed_end : TokenKind::motor_end;
  Costs rest{};
  if (before < flow.motor_sides - 1 ||
      std::find(parts_.ends.begin(), parts_.ends.end(), end) == parts_.ends.end()) {
    rest.fill(infinity);
    return rest;
  }
  if (end == TokenKind::fixed_end) return rest;
  return crossed(flow, sheath_, flow.slip_behind(fingers_, before), At::carriage,
                 at_motor_side(flow, rest));
}

WalkBounds::Costs WalkBounds::at_length(const Flow& flow, double length, Costs rest) const {
  for (std::size_t i = 0; i < lambdas; ++i) rest[i] -= lambda_[i] * flow.per_mm * length;
  return rest;
}

WalkBounds::Costs WalkBounds::at_motor_side(const Flow& flow, Costs rest) const {
  for (std::size_t i = 0; i < lambdas; ++i) rest[i] -= lambda_[i];
  return at_length(flow, motor_side_mm_, rest);
}

// In units of the tension in front of the contact; those of the rest are of the one behind it.
WalkBounds::Costs WalkBounds::crossed(const Flow& flow, const Law& law, int slip, At at,
                                      const Costs& rest) const {
  Costs costs = rest;
  if (slip == 0) {
    for (double& cost : costs) cost = std::min(law.decay * cost, law.growth * cost);
    return costs;
  }
  const double ratio = slip > 0 ? law.growth : law.decay;
  const double loss =
      at == At::hand ? std::abs(slip) / static_cast<double>(flow.closing) * std::abs(ratio - 1) : 0;
  for (double& cost : costs) cost = loss + ratio * cost;
  return costs;
}

const WalkBounds::Law& WalkBounds::tip(const Token& token) const {
  return token.tip == TipKind::tube ? tube_ : bearing_;
}

void WalkBounds::read(const Walk& walk, int passed) {
  int alike = 0;
  while (alike < read_ && alike <= passed && has_read(walk, alike + 1)) ++alike;
  read_ = alike;
  walk_ = walk;
  if (read_ == 0) start(walk[0]);
  read_ = std::max(read_, 1);
  for (; read_ <= passed; ++read_) {
    const auto token = static_cast<std::size_t>(2 * read_ - 1);
    pass(walk[token], walk[token + 1], read_);
  }
}

// True if both walks have the end, or the finger and the join, that lead to this level.
bool WalkBounds::has_read(const Walk& walk, int level) const {
  const auto last = 2 * static_cast<std::size_t>(level - 1);
  return walk[last] == walk_[last] && (last == 0 || walk[last - 1] == walk_[last - 1]);
}

void WalkBounds::start(const Token& end) {
  Level& level = levels_[1];
  const bool pulled = end.kind == TokenKind::motor_end;
  level.motor_sides = pulled ? 1 : 0;
  level.pulleys = 0;
  for (int m = 1; m <= most_motor_sides(); ++m) {
    for (int held = 0; held <= 1; ++held) {
      const Flow flow = this->flow(m, held);
      Beginning& beginning = level.beginnings[index(m, held)];
      beginning = {infinity, 0, 1, infinity, 0, 0, 0};
      if (pulled) {
        add_motor_side(flow, beginning);
        cross(flow, sheath_, -flow.closing, At::carriage, beginning);
      }
      add_strand(flow, beginning);
    }
  }
}

// A finger that is held behind this one is the next one, whichever it is.
void WalkBounds::pass(const Token& tip, const Token& join, int finger) {
  const Level& before = levels_[static_cast<std::size_t>(finger)];
  Level& level = levels_[static_cast<std::size_t>(finger) + 1];
  const bool on_carriage = join.kind == TokenKind::movable_pulley;
  level.motor_sides = before.motor_sides + (on_carriage ? 2 : 0);
  level.pulleys = before.pulleys + (tip.tip == TipKind::bearing ? 1 : 0) +
                  (join.kind == TokenKind::tube_join ? 0 : 1);
  const int rest = fingers_ - finger;
  const int last = std::min(most_motor_sides(), level.motor_sides + 2 * (rest - 1) + 1);
  for (int m = std::max(1, level.motor_sides); m <= last; ++m) {
    for (int held = 0; held <= finger + 1; ++held) {
      const Flow flow = this->flow(m, held);
      Beginning beginning = before.beginnings[index(m, std::min(held, finger))];
      // The one before ends where that finger may still be this one or any behind it.
      cross(flow, this->tip(tip), flow.slip_at_tip(finger, before.motor_sides), At::hand,
            beginning);
      add_strand(flow, beginning);
      pass_join(flow, join, finger, beginning);
      add_strand(flow, beginning);
      level.beginnings[index(m, held)] = beginning;
    }
  }
}

void WalkBounds::pass_join(const Flow& flow, const Token& join, int finger,
                           Beginning& beginning) const {
  const int before = levels_[static_cast<std::size_t>(finger)].motor_sides;
  const auto slip = [&](int more) { return flow.slip_behind(finger, before + more); };
  if (join.kind != TokenKind::movable_pulley) {
    const Law& law = join.kind == TokenKind::tube_join ? tube_ : bearing_;
    cross(flow, law, slip(0), At::hand, beginning);
    return;
  }
  cross(flow, sheath_, slip(0), At::carriage, beginning);
  add_motor_side(flow, beginning);
  cross(flow, bearing_, slip(1), At::carriage, beginning);
  add_motor_side(flow, beginning);
  cross(flow, sheath_, slip(2), At::carriage, beginning);
}

// Whatever the tensions at a still contact are, they differ by its friction at most.
void WalkBounds::cross(const Flow& flow, const Law& law, int slip, At at,
                       Beginning& beginning) const {
  if (slip == 0) {
    if (beginning.most_behind > 0) {
      beginning.ratio = std::min(beginning.ratio, beginning.least_behind / beginning.most_behind);
    }
    beginning.least_behind = infinity;
    beginning.most_behind = 0;
    beginning.least *= law.growth;
    beginning.most *= law.decay;
    beginning.loss *= law.decay;
    beginning.motor *= law.growth;
    return;
  }
  const double ratio = slip > 0 ? law.growth : law.decay;
  const double back = slip > 0 ? law.decay : law.growth;
  if (at == At::hand) {
    beginning.loss += std::abs(slip) / static_cast<double>(flow.closing) * std::abs(ratio - 1);
  }
  for (double* each : {&beginning.least, &beginning.most, &beginning.least_behind,
                       &beginning.most_behind, &beginning.loss, &beginning.motor}) {
    *each *= back;
  }
}

void WalkBounds::add_strand(const Flow& flow, Beginning& beginning) const {
  beginning.least = std::min(beginning.least, 1.0);
  beginning.most = std::max(beginning.most, 1.0);
  beginning.least_behind = std::min(beginning.least_behind, 1.0);
  beginning.most_behind = std::max(beginning.most_behind, 1.0);
  beginning.motor += flow.per_mm * strand_mm_;
}

void WalkBounds::add_motor_side(const Flow& flow, Beginning& beginning) const {
  beginning.motor += 1 + flow.per_mm * motor_side_mm_;
}

double WalkBounds::efficiency(const Beginning& beginning, const Costs& rest) const {
  const auto spare = [&](std::size_t i) {
    return beginning.loss + rest[i] - lambda_[i] * beginning.motor;
  };
  double lower = std::max(spare(0), 0.0);
  for (std::size_t i = 1; i < lambdas; ++i) {
    const double next = spare(i);
    if (next < 0) {
      const double part = lower / (lower - next);
      const double lambda = lambda_[i - 1] + part * (lambda_[i] - lambda_[i - 1]);
      return sheath_.decay - lambda;
    }
    lower = next;
  }
  return 0;
}

bool WalkBounds::outline(int motor_sides, TreeOutline& outline) {
  const int next = read_;
  const Level& level = levels_[static_cast<std::size_t>(next)];
  if (level.motor_sides > motor_sides) return false;
  if (std::isinf(costs(motor_sides, 0, next, level.motor_sides)[0])) return false;
  outline.fingers = fingers_;
  outline.parts = {};
  outline.parts.sheaths = motor_sides;
  outline.parts.pulleys = level.pulleys;
  outline.sums.resize(static_cast<std::size_t>(fingers_) + 1);
  for (int held = 0; held <= fingers_; ++held) {
    const Beginning& beginning = level.beginnings[index(motor_sides, std::min(held, next))];
    TreeSums& sums = outline.sums[static_cast<std::size_t>(held)];
    sums = {};
    sums.motor = 1;
    sums.strands.most = 1;
    sums.strands.least = std::min({beginning.ratio, beginning.least / beginning.most,
                                   beginning.least_behind / beginning.most_behind});
    sums.strands.work = efficiency(beginning, costs(motor_sides, held, next, level.motor_sides));
  }
  return true;
}

}  // namespace reeve::search
