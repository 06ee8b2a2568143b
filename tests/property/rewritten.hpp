// Other ways to write a routing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/notation.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {

// Its tendons in any order, each walked in any direction and loops entered at any finger.
inline Routing disguised(Routing routing, Dice& dice) {
  for (Tendon& tendon : routing.tendons) {
    if (dice.chance(0.5)) {
      std::reverse(tendon.walk.begin(), tendon.walk.end());
      for (Token& token : tendon.walk) token = reversed(token);
    }
    while (tendon.closed && (tendon.walk.front().kind != TokenKind::finger || dice.chance(0.5))) {
      std::rotate(tendon.walk.begin(), tendon.walk.begin() + 1, tendon.walk.end());
    }
  }
  dice.shuffle(routing.tendons);
  return routing;
}

// 0, and then 1 … n in any order.
inline std::vector<std::uint8_t> shuffled_numbers(int n, Dice& dice) {
  std::vector<std::uint8_t> numbers(static_cast<std::size_t>(n));
  std::iota(numbers.begin(), numbers.end(), std::uint8_t{1});
  dice.shuffle(numbers);
  numbers.insert(numbers.begin(), 0);
  return numbers;
}

// Its fingers, motors and blocks under other numbers.
inline Routing renamed(Routing routing, Dice& dice) {
  const std::vector<std::uint8_t> block = shuffled_numbers(max_blocks, dice);
  const std::vector<std::uint8_t> finger = shuffled_numbers(finger_count(routing), dice);
  const std::vector<std::uint8_t> motor = shuffled_numbers(carriage_count(routing), dice);
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      token.block = block[token.block];
      token.finger = finger[token.finger];
      if (is_on_carriage(token.kind)) token.carriage = motor[token.carriage];
    }
  }
  return routing;
}

}  // namespace reeve::testing
