// Plates: rigid bodies with three ties that are not in line.
#pragma once

#include <vector>

#include "core/word.hpp"

namespace reeve::core {

// Replaces each plate by two bars, one of which hangs on an arm of the other. A plate's balance of
// one force and two moments gives each tie a fixed part of the pull, as those bars do:
// `1x-W1-2x+3x-W1k/1:2+W1-M` is `1x-W2-2x+3x-W1/1:2-W2+W1-M`. A third tie (W1k) comes as bar_arms
// at an end of its walk, with the ratio of its tension to that of both others. A fourth tie gives a
// bar third arms, which the BlockLedger refuses. Throws InputError.
void replace_plates(const Word& word, std::vector<PlacedWalk>& walks);

}  // namespace reeve::core
