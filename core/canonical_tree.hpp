// The canonical order of the tendons that blocks and bars tie together.
//
// A tree begins with a tendon that passes no block, the least in the order of canonical.hpp; then
// come, block by block in the order in which the words name them, the other tendons of that block.
// Blocks, and bars likewise, are numbered as they appear. Which of two tendons, or of two ways to
// walk one, is the lesser is decided by their shapes, then by what hangs on their blocks: tendons
// and blocks get ranks, which are refined by each other's until no more can be told apart
// (colour refinement). In a tree what still ties is alike.
#pragma once

#include <vector>

#include "core/canonical.hpp"

namespace reeve::core {

// All tendons of one tree.
std::vector<Tendon> canonical_tree(const std::vector<Tendon>& tendons, FingerIdentity identity);

}  // namespace reeve::core
