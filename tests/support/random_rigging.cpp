#include "tests/support/random_rigging.hpp"

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/notation.hpp"

namespace reeve::testing {
namespace {

Token tied(TokenKind kind, int number) { return core::block(kind, number); }

struct Parts {
  std::vector<Token> ends;
  std::vector<Token> inner;
};

void add_fingers(Dice& dice, int count, Parts& parts) {
  const double through = dice.real(0, 1);
  for (int number = 1; number <= count; ++number) {
    if (dice.chance(through)) {
      parts.inner.push_back(finger(number, dice.chance(0.3) ? TipKind::bearing : TipKind::tube));
    } else {
      parts.ends.push_back(anchored_tip(number));
    }
  }
}

void add_bar(Dice& dice, int number, Parts& parts) {
  const auto arm = [&] { return static_cast<std::uint16_t>(dice.integer(1, 4)); };
  const bool even = dice.chance(0.6);
  const std::uint16_t left = even ? std::uint16_t{1} : arm();
  parts.inner.push_back(bar(number, even ? ArmRatio{} : ArmRatio{left, arm()}));
  parts.ends.push_back(tied(TokenKind::bar_pivot, number));
}

void add_block(Dice& dice, int number, Parts& parts) {
  const int passes = dice.chance(0.7) ? 1 : dice.integer(0, 3);
  for (int i = 0; i < passes; ++i) parts.inner.push_back(tied(TokenKind::block_pass, number));
  if (passes == 0 || dice.chance(0.3)) parts.ends.push_back(tied(TokenKind::becket, number));
  const int tails = dice.chance(0.95) ? 1 : 2;
  for (int i = 0; i < tails; ++i) parts.ends.push_back(tied(TokenKind::block_tail, number));
}

void add_joins(Dice& dice, Parts& parts) {
  while (dice.chance(0.3)) {
    parts.inner.push_back(plain(dice.pick<TokenKind>(
        {TokenKind::tube_join, TokenKind::bearing_join, TokenKind::movable_pulley})));
  }
}

Token join(Dice& dice) {
  return plain(dice.pick<TokenKind>(
      {TokenKind::tube_join, TokenKind::bearing_join, TokenKind::movable_pulley}));
}

// Fingers side by side need a join between them.
void append(Dice& dice, const Token& token, Tendon& tendon) {
  const bool beside = !tendon.walk.empty() && is_of_finger(tendon.walk.back().kind);
  if (beside && is_of_finger(token.kind)) tendon.walk.push_back(join(dice));
  tendon.walk.push_back(token);
}

Tendon loop_of(Dice& dice, std::vector<Token>& inner) {
  Tendon tendon{{}, true};
  tendon.walk.push_back(inner.back());
  inner.pop_back();
  while (!inner.empty() && dice.chance(0.5)) {
    append(dice, inner.back(), tendon);
    inner.pop_back();
  }
  if (is_of_finger(tendon.walk.back().kind)) tendon.walk.push_back(join(dice));
  return tendon;
}

Routing routing_of(Dice& dice, Parts parts) {
  dice.shuffle(parts.inner);
  Routing routing;
  while (!parts.inner.empty() && parts.inner.back().kind == TokenKind::finger && dice.chance(0.3)) {
    routing.tendons.push_back(loop_of(dice, parts.inner));
  }
  const std::size_t least = parts.ends.size() / 2 + 1;
  while (parts.ends.size() < 2 * least || dice.chance(0.2)) {
    parts.ends.push_back(dice.chance(0.6) ? motor_end() : fixed_end());
  }
  if (parts.ends.size() % 2 == 1) parts.ends.push_back(motor_end());
  dice.shuffle(parts.ends);
  const std::size_t tendons = parts.ends.size() / 2;
  for (std::size_t t = 0; t < tendons; ++t) {
    Tendon tendon;
    tendon.walk.push_back(parts.ends[2 * t]);
    const bool last = t + 1 == tendons;
    while (!parts.inner.empty() && (last || dice.chance(0.6))) {
      append(dice, parts.inner.back(), tendon);
      parts.inner.pop_back();
    }
    append(dice, parts.ends[2 * t + 1], tendon);
    routing.tendons.push_back(tendon);
  }
  return routing;
}

bool is_allowed(const Routing& routing) {
  try {
    return parse_routing(to_word(routing)) == routing;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Routing random_rigging(Dice& dice, const RiggingRange& range) {
  while (true) {
    Parts parts;
    add_fingers(dice, dice.integer(1, range.most_fingers), parts);
    const int count = dice.integer(0, range.most_blocks);
    int blocks = 0;
    for (int i = 1; i <= count; ++i) {
      if (dice.chance(0.3)) {
        add_bar(dice, i - blocks, parts);
      } else {
        add_block(dice, ++blocks, parts);
      }
    }
    add_joins(dice, parts);
    const Routing routing = routing_of(dice, std::move(parts));
    if (is_allowed(routing)) return routing;
  }
}

}  // namespace reeve::testing
