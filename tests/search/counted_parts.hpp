// The parts of the program in the words of the counting formulas.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/enumerate/parts.hpp"
#include "tests/support/counting.hpp"

namespace reeve::testing {

inline CountedParts counted(const PartSet& parts) {
  const auto on_carriage = [](const std::vector<TokenKind>& kinds) {
    return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), is_on_carriage));
  };
  CountedParts result;
  result.tube_like_tips = static_cast<int>(parts.tips.size());
  result.motor_joins = on_carriage(parts.joins);
  result.passive_joins = static_cast<int>(parts.joins.size()) - result.motor_joins;
  result.motor_ends = on_carriage(parts.ends);
  result.fixed_ends = static_cast<int>(parts.ends.size()) - result.motor_ends;
  return result;
}

inline CountedTreeParts counted_with_trees(const PartSet& parts) {
  const auto motor_beside =
      static_cast<int>(std::count_if(parts.beside.begin(), parts.beside.end(), is_on_carriage));
  return {counted(parts),      parts.anchored, parts.linked,
          parts.series,        parts.bars,     parts.beckets,
          parts.double_passes, parts.motors,   static_cast<int>(parts.beside.size()) - motor_beside,
          motor_beside};
}

// All, actuated, actuated and one tree.
using RoutingNumbers = std::vector<std::uint64_t>;

template <typename Counts>
RoutingNumbers numbers_of(const Counts& counts) {
  return {counts.all, counts.actuated, counts.one_tendon};
}

}  // namespace reeve::testing
