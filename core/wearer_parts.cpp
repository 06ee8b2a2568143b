#include "core/wearer_parts.hpp"

namespace reeve::core {

WearerParts wearer_parts(const Routing& routing) {
  const BlockCount count = block_count(routing);
  WearerParts parts{count.blocks + count.bars, 0};
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (token.kind == TokenKind::finger) parts.strands += 2;
      if (token.kind == TokenKind::anchored_tip) parts.strands += 1;
    }
  }
  return parts;
}

}  // namespace reeve::core
