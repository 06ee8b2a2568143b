// Which place each design of a ranking has: designs that are equal share one.
//
//   place = rank of the first design that this one equals
//
// Two designs are equal if they are in every ranked objective and in what orders within a front;
// what is left to order them, fewer parts and the word, does not make one better. After two at
// place 1 the next is at 3.
#pragma once

#include <cstddef>
#include <vector>

#include "search/rank/ranking.hpp"

namespace reeve::search {

// Parallel to `ranked`, which is best first and without gaps before what is asked of.
std::vector<std::size_t> places(const std::vector<RankedDesign>& ranked, const Order& order);

}  // namespace reeve::search
