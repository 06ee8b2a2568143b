// The parts of the program in the words of the counting formulas.
#pragma once

#include <algorithm>
#include <vector>

#include "search/enumerate/parts.hpp"
#include "tests/support/tree_counting.hpp"

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
  return {counted(parts), parts.anchored};
}

}  // namespace reeve::testing
