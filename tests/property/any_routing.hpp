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

}  // namespace testing
}  // namespace reeve
