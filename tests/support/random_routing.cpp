#include "tests/support/random_routing.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/notation.hpp"

namespace reeve::testing {

int Dice::integer(int low, int high) {
  const auto choices = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<int>(engine_() % choices);
}

double Dice::real(double low, double high) {
  const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
  return low + unit * (high - low);
}

double Dice::log_real(double low, double high) {
  return std::exp(real(std::log(low), std::log(high)));
}

bool Dice::chance(double probability) { return real(0, 1) < probability; }

namespace {

TokenKind random_join(Dice& dice) {
  return dice.pick<TokenKind>(
      {TokenKind::tube_join, TokenKind::bearing_join, TokenKind::movable_pulley});
}

Token random_end(Dice& dice) { return dice.chance(0.5) ? motor_end() : fixed_end(); }

Token random_finger(Dice& dice, int number) {
  return finger(number, dice.chance(0.3) ? TipKind::bearing : TipKind::tube);
}

void add_joins(Dice& dice, int count, Tendon& tendon) {
  for (int i = 0; i < count; ++i) tendon.walk.push_back(plain(random_join(dice)));
}

int joins_between_fingers(Dice& dice) { return dice.chance(0.85) ? 1 : dice.integer(2, 3); }
int joins_at_an_end(Dice& dice) { return dice.chance(0.85) ? 0 : dice.integer(1, 2); }

Tendon random_loop(Dice& dice, const std::vector<int>& fingers) {
  Tendon loop{{}, true};
  for (const int number : fingers) {
    loop.walk.push_back(random_finger(dice, number));
    add_joins(dice, joins_between_fingers(dice), loop);
  }
  return loop;
}

Tendon random_open(Dice& dice, const std::vector<int>& fingers) {
  Tendon tendon;
  tendon.walk.push_back(random_end(dice));
  add_joins(dice, joins_at_an_end(dice), tendon);
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    if (i > 0) add_joins(dice, joins_between_fingers(dice), tendon);
    tendon.walk.push_back(random_finger(dice, fingers[i]));
  }
  add_joins(dice, joins_at_an_end(dice), tendon);
  tendon.walk.push_back(random_end(dice));
  return tendon;
}

void actuate(Dice& dice, Tendon& tendon) {
  if (is_actuated(tendon)) return;
  if (!tendon.closed) {
    (dice.chance(0.5) ? tendon.walk.front() : tendon.walk.back()) = motor_end();
    return;
  }
  tendon.walk.back() = plain(TokenKind::movable_pulley);  // a loop's walk ends with a join
}

std::vector<std::vector<int>> random_groups(Dice& dice, int fingers) {
  std::vector<int> order(static_cast<std::size_t>(fingers));
  std::iota(order.begin(), order.end(), 1);
  dice.shuffle(order);
  std::vector<std::vector<int>> groups;
  for (const int number : order) {
    if (groups.empty() || dice.chance(0.3)) groups.emplace_back();
    groups.back().push_back(number);
  }
  return groups;
}

}  // namespace

Routing random_routing(Dice& dice, const RoutingRange& range) {
  Routing routing;
  std::vector<std::vector<int>> groups =
      random_groups(dice, dice.integer(range.least_fingers, range.most_fingers));
  if (range.bare_tendons && dice.chance(0.03)) groups.emplace_back();
  for (const std::vector<int>& fingers : groups) {
    const bool loop = !fingers.empty() && dice.chance(0.35);
    routing.tendons.push_back(loop ? random_loop(dice, fingers) : random_open(dice, fingers));
    if (range.actuated) actuate(dice, routing.tendons.back());
  }
  return routing;
}

namespace {

// Fingers to pass, and ends at fingertips, in any order.
struct FingerParts {
  std::vector<Token> passed;
  std::vector<Token> ends;
};

FingerParts random_finger_parts(Dice& dice, int fingers) {
  FingerParts parts;
  for (int f = 1; f <= fingers; ++f) {
    if (dice.chance(0.25)) {
      parts.passed.push_back(random_finger(dice, f));
      continue;
    }
    parts.ends.push_back(anchored_tip(f));
    if (dice.chance(0.3))
      parts.ends.push_back(anchored_tip(f));
    else if (dice.chance(0.6))
      parts.ends.push_back(anchored_tip(f, TipKind::back));
  }
  dice.shuffle(parts.ends);
  return parts;
}

Token taken(std::vector<Token>& tokens) {
  const Token last = tokens.back();
  tokens.pop_back();
  return last;
}

}  // namespace

Routing random_shared_routing(Dice& dice) {
  FingerParts parts = random_finger_parts(dice, dice.integer(1, 4));
  Routing routing;
  while (!parts.ends.empty() || !parts.passed.empty()) {
    Tendon tendon;
    tendon.walk.push_back(parts.ends.empty() ? random_end(dice) : taken(parts.ends));
    add_joins(dice, 1, tendon);
    while (!parts.passed.empty() && dice.chance(0.5)) {
      tendon.walk.push_back(taken(parts.passed));
      add_joins(dice, 1, tendon);
    }
    const bool both = !parts.ends.empty() && dice.chance(0.4);
    tendon.walk.push_back(both ? taken(parts.ends) : random_end(dice));
    if (!is_actuated(tendon)) tendon.walk[1] = plain(TokenKind::movable_pulley);
    routing.tendons.push_back(tendon);
  }
  return routing;
}

Routing with_several_motors(Dice& dice, Routing routing) {
  const int most = dice.chance(0.4) ? 1 : dice.integer(2, 4);
  std::map<int, std::uint8_t> number;  // of the carriages drawn, in the order of the word
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (!is_on_carriage(token.kind)) continue;
      const int drawn = dice.integer(1, most);
      const auto next = static_cast<std::uint8_t>(number.size() + 1);
      token.carriage = number.emplace(drawn, next).first->second;
    }
  }
  return routing;
}

namespace {

double random_mu(Dice& dice) { return dice.chance(0.15) ? 0 : dice.log_real(1e-4, 0.4); }

ContactLaw random_law(Dice& dice, double angle) { return {random_mu(dice), angle}; }

FingerHardware random_finger_hardware(Dice& dice, int number) {
  FingerHardware finger;
  finger.finger = number;
  if (dice.chance(0.5)) finger.tip_mu = random_mu(dice);
  if (dice.chance(0.5)) finger.tip_angle_rad = dice.real(0, 4);
  if (dice.chance(0.5)) finger.sheath_mu = random_mu(dice);
  if (dice.chance(0.5)) finger.sheath_angle_rad = dice.real(0, 8);
  if (dice.chance(0.5)) finger.strand_mm = dice.log_real(20, 500);
  if (dice.chance(0.5)) finger.closing = dice.log_real(0.1, 10);
  return finger;
}

ContactHardware random_contact_hardware(Dice& dice, const Network& network,
                                        const TendonSpan& tendon) {
  const int contacts = static_cast<int>(tendon.contacts);
  const auto k = static_cast<std::size_t>(dice.integer(0, contacts - 1));
  const auto [left, right] = ends_of(tendon, k);
  ContactHardware contact{
      segment_name(network.segments[left]), segment_name(network.segments[right]), {}, {}};
  if (dice.chance(0.5)) std::swap(contact.segment, contact.other_segment);
  if (dice.chance(0.7)) contact.mu = random_mu(dice);
  if (dice.chance(0.7)) contact.angle_rad = dice.real(0, 6);
  return contact;
}

}  // namespace

Hardware random_hardware(Dice& dice, const Network& network) {
  Hardware hardware;
  hardware.tube = random_law(dice, std::numbers::pi);
  hardware.bearing = random_law(dice, std::numbers::pi);
  hardware.sheath = random_law(dice, dice.real(0.5, 8));
  hardware.strand_mm = dice.log_real(20, 500);
  hardware.motor_side_mm = dice.log_real(20, 500);
  hardware.hand_mm = dice.log_real(20, 500);
  for (int number = 1; number <= network.fingers; ++number) {
    if (dice.chance(0.4)) hardware.fingers.push_back(random_finger_hardware(dice, number));
  }
  while (dice.chance(0.4)) {
    const TendonSpan& tendon = dice.pick(network.tendons);
    if (tendon.contacts == 0) continue;
    hardware.contacts.push_back(random_contact_hardware(dice, network, tendon));
  }
  return hardware;
}

Grasp random_grasp(Dice& dice, int fingers) {
  Grasp grasp;
  for (int number = 1; number <= fingers; ++number) {
    if (dice.chance(0.3)) grasp.held |= hold({number}).held;
  }
  return grasp;
}

Trial random_trial(std::uint64_t seed, const RoutingRange& range) {
  Dice dice(seed);
  Trial trial;
  trial.seed = seed;
  trial.routing = random_routing(dice, range);
  trial.network = expand(trial.routing);
  trial.hardware = random_hardware(dice, trial.network);
  trial.grasp = random_grasp(dice, trial.network.fingers);
  trial.direction = dice.chance(0.5) ? Direction::pull : Direction::release;
  return trial;
}

std::string to_text(const Trial& trial) {
  return "seed " + std::to_string(trial.seed) + ": " + to_word(trial.routing) + ", held " +
         to_text(trial.grasp) + (trial.direction == Direction::pull ? ", pull" : ", release");
}

}  // namespace reeve::testing
