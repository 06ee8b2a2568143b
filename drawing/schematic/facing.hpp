// Which way blocks and joins face, and how deep below the fingers they lie.
//
// A line that leaves one port downward and arrives at a lower one from above runs straight on; two
// ports that face the same way need a bend. Blocks and joins are turned so that bends are few: the
// blocks that only fingers hang on then lie nearest to the fingers, upright, those above them
// nearer to the sheaths; a block whose tail pulls at a finger is inverted, with its tackle below.
#pragma once

#include "drawing/schematic/fittings.hpp"

namespace reeve::drawing {

// Sets `inverted`, `level` and `carrier`, and adds the bends of lines that would run upward.
void face(Fittings& all);

}  // namespace reeve::drawing
