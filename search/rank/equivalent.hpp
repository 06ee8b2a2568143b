// Designs that the ranking cannot tell apart: equal in every ranked objective and in what orders
// within a front.
#pragma once

#include <cstddef>
#include <vector>

#include "core/canonical.hpp"
#include "core/routing.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

// Returns the place of each design, parallel to `ranked`, which is best first and without gaps
// before what is asked of. Designs that are equal share one:
//
//   place = rank of the first design that this one equals
//
// What is left to order them, fewer parts and the word, does not make one better. After two at
// place 1 the next is at 3.
std::vector<std::size_t> places(const std::vector<RankedDesign>& ranked, const Order& order);

// Ranks designs and returns their places in the order in which they are given.
std::vector<std::size_t> places_of(std::vector<Design> designs, const Order& order);

// Returns the canonical routing with a tube in place of every bearing that could be one.
Routing without_bearings(Routing routing, FingerIdentity identity);

// Two designs are alike if they are equal, and would be one routing with tubes in place of all
// bearings at fingertips and joins: what bearings one has beyond the other change nothing that is
// ranked. The first of them in the ranking has fewest parts and stands for all.
//
// Returns for each design the index of the first that it is like: its own if there is none before
// it. `ranked` is best first and `routings` begins parallel to it.
std::vector<std::size_t> first_equivalent(const std::vector<RankedDesign>& ranked,
                                          const std::vector<Routing>& routings, const Order& order,
                                          FingerIdentity identity);

}  // namespace reeve::search
