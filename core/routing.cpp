#include "core/routing.hpp"

#include <algorithm>

namespace reeve::core {

int finger_count(const Tendon& tendon) {
  return static_cast<int>(
      std::count_if(tendon.walk.begin(), tendon.walk.end(),
                    [](const Token& token) { return token.kind == TokenKind::finger; }));
}

int finger_count(const Routing& routing) {
  int count = 0;
  for (const Tendon& tendon : routing.tendons) count += finger_count(tendon);
  return count;
}

bool is_actuated(const Tendon& tendon) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(),
                     [](const Token& token) { return is_on_carriage(token.kind); });
}

bool is_actuated(const Routing& routing) {
  return std::all_of(routing.tendons.begin(), routing.tendons.end(),
                     [](const Tendon& tendon) { return is_actuated(tendon); });
}

}  // namespace reeve::core
