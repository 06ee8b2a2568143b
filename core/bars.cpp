#include "core/bars.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

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

// Returns the ratio in whole numbers, of two as near the one with the smaller numbers.
std::optional<ArmRatio> arm_ratio(double left, double right) {
  if (left < right) {
    const auto swapped = arm_ratio(right, left);
    return swapped ? std::optional(ArmRatio{swapped->right, swapped->left}) : std::nullopt;
  }
  constexpr std::uint16_t finest = 1000;
  constexpr double exact = 1e-9;
  constexpr double largest = std::numeric_limits<std::uint16_t>::max();
  std::optional<ArmRatio> nearest;
  double least_miss = std::numeric_limits<double>::infinity();
  for (std::uint16_t part = 1; part <= finest; ++part) {
    const double wanted = left / right * part;
    if (std::round(wanted) > largest) break;
    const double miss = std::abs(std::round(wanted) / wanted - 1);
    if (miss > least_miss - exact) continue;
    least_miss = miss;
    nearest = ArmRatio{static_cast<std::uint16_t>(std::round(wanted)), part};
  }
  return nearest;
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

std::optional<Routing> whiffletree(const std::vector<double>& pulls) {
  const int bars = static_cast<int>(pulls.size()) - 1;
  if (bars < 1 || bars > max_blocks) return std::nullopt;
  Routing routing;
  routing.tendons.push_back({{motor_end(), block(TokenKind::bar_pivot, 1)}, false});
  double rest = std::accumulate(pulls.begin(), pulls.end(), 0.0);
  for (int i = 1; i <= bars; ++i) {
    const double pull = pulls[static_cast<std::size_t>(i) - 1];
    rest -= pull;
    const auto arms = arm_ratio(pull, rest);
    if (!arms) return std::nullopt;
    const Token further = i < bars ? block(TokenKind::bar_pivot, i + 1) : anchored_tip(i + 1);
    routing.tendons.push_back({{anchored_tip(i), bar(i, *arms), further}, false});
  }
  return routing;
}

}  // namespace reeve::core
