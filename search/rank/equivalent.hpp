// Designs that the ranking cannot tell apart, and that differ in their bearings alone.
//
// Two designs are alike if they are equal in every ranked objective and in what orders within a
// front, and would be one routing with tubes in place of all bearings at fingertips and joins: what
// bearings one has beyond the other change nothing that is ranked. The first of them in the ranking
// has fewest parts and stands for all.
#pragma once

#include <cstddef>
#include <vector>

#include "core/canonical.hpp"
#include "core/routing.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::search {

// With a tube wherever a bearing could be one; canonical.
Routing without_bearings(Routing routing, FingerIdentity identity);

// For each design the place of the first that it is like: its own if there is none before it.
// `ranked` is best first and `routings` begins parallel to it.
std::vector<std::size_t> first_equivalent(const std::vector<RankedDesign>& ranked,
                                          const std::vector<Routing>& routings, const Order& order,
                                          FingerIdentity identity);

}  // namespace reeve::search
