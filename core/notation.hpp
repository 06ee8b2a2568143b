// The notation of routings: words such as `M-1-T-2-F`, `1-P-2b-P-1+M-3-F` or `M-Y1+1x-Y1-2x`.
//
//   routing = tendon { "+" tendon }
//   tendon  = end "-" { finger | join "-" } end        an open walk
//           | finger "-" join { "-" … } "-" finger     a loop: back to its first finger
//   end     = "M" [ motor ] | "F" | number "x" | block | block "k" | bar | bar "k" [ ratio ]
//   join    = "T" | "B" | "P" [ motor ] | block | bar [ ratio ]
//   finger  = number [ "b" ]      block = "Y" number      bar = "W" number
//   ratio   = "/" number ":" number
//   motor   = "2" … "6"                                the first motor has no number
//
// Two fingers need a join between them. Joins and ends may stand side by side; the stretch of
// tendon between them is then a stretch at the hand (h1, h2, …), so that a test bench such as `M-F`
// is a routing too. A block is its tail as an end and a pass as a join; a bar its pivot as an end
// and both its arms as a join, with the ratio of the tensions of the left and the right neighbour.
// A bar with a third tie is a plate, and is read as two bars (plates.hpp). Printing and parsing
// round-trip exactly (ratios in lowest terms); which of the words of one routing is the canonical
// one is decided in canonical.hpp.
#pragma once

#include <string>
#include <string_view>

#include "core/routing.hpp"

namespace reeve::core {

// Throws InputError with the word, the column (from 1), the token and what was expected.
Routing parse_routing(std::string_view word);

std::string to_word(const Routing& routing);

}  // namespace reeve::core
