#include "core/bars.hpp"

#include <algorithm>
#include <array>

namespace reeve::core {
namespace {

bool each_block_is_passed_once(const Routing& routing) {
  std::array<int, block_keys> passes{};
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (token.kind == TokenKind::becket) return false;
      if (token.kind == TokenKind::block_pass) ++passes[block_key(token)];
    }
  }
  // A block that nothing passes hangs on beckets.
  return std::all_of(passes.begin(), passes.end(), [](int count) { return count <= 1; });
}

Token as_of_bar(Token token) {
  if (token.kind == TokenKind::block_pass) token.kind = TokenKind::bar_arms;
  if (token.kind == TokenKind::block_tail) token.kind = TokenKind::bar_pivot;
  return token;
}

}  // namespace

std::optional<Routing> with_bars(const Routing& routing) {
  const BlockCount count = block_count(routing);
  if (count.blocks == 0 || count.bars > 0 || !each_block_is_passed_once(routing)) {
    return std::nullopt;
  }
  Routing barred = routing;
  for (Tendon& tendon : barred.tendons) {
    for (Token& token : tendon.walk) token = as_of_bar(token);
  }
  return barred;
}

}  // namespace reeve::core
