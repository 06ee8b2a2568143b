// Any routing of up to nine fingers, actuated or not, as a RapidCheck generator that shrinks to
// fewer fingers.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <utility>

#include "core/notation.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {

inline void showValue(const Routing& routing, std::ostream& out) { out << to_word(routing); }

namespace testing {

inline rc::Gen<Routing> any_routing(int most_fingers = 9) {
  return rc::gen::map(
      rc::gen::pair(rc::gen::inRange(1, most_fingers + 1), rc::gen::arbitrary<std::uint64_t>()),
      [](const std::pair<int, std::uint64_t>& drawn) {
        Dice dice(drawn.second);
        return with_several_motors(dice,
                                   random_routing(dice, {drawn.first, drawn.first, false, true}));
      });
}

// The same with wrap angles at some of its contacts: few different ones, so that some are alike.
inline rc::Gen<Routing> any_angled_routing(int most_fingers = 9) {
  return rc::gen::map(rc::gen::pair(any_routing(most_fingers), rc::gen::arbitrary<std::uint64_t>()),
                      [](std::pair<Routing, std::uint64_t> drawn) {
                        Dice dice(drawn.second);
                        for (Tendon& tendon : drawn.first.tendons) {
                          for (Token& token : tendon.walk) {
                            if (!has_angle(token.kind) || dice.chance(0.5)) continue;
                            token.angle.millidegrees = dice.chance(0.5) ? 90000 : 22500;
                          }
                        }
                        return drawn.first;
                      });
}

}  // namespace testing
}  // namespace reeve
