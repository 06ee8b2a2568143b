// The parts of the program in the words of the counting formulas.
#pragma once

#include <algorithm>
#include <vector>

#include "search/enumerate/parts.hpp"
#include "tests/support/tree_counting.hpp"

namespace reeve::testing {

inline CountedTreeParts counted_with_trees(const PartSet& parts) {
  const auto on_carriage = [](const std::vector<TokenKind>& kinds) {
    return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), is_on_carriage));
  };
  CountedTreeParts result;
  result.parts.tube_like_tips = static_cast<int>(parts.tips.size());
  result.parts.motor_joins = on_carriage(parts.joins);
  result.parts.passive_joins = static_cast<int>(parts.joins.size()) - result.parts.motor_joins;
  result.parts.motor_ends = on_carriage(parts.ends);
  result.parts.fixed_ends = static_cast<int>(parts.ends.size()) - result.parts.motor_ends;
  result.anchored = parts.anchored;
  return result;
}

}  // namespace reeve::testing
