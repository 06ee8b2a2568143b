// Numbers of routings that a set of parts makes.
//
// With t tip kinds, J join kinds, E end kinds, x = 1 where tips may be anchored and 0 elsewhere,
// and A = tE + x (a last finger with its end, or as one), the tendons through k fingers are, up to
// their symmetries (an end with a join beside it is an end kind of its own),
//   identical fingers (Burnside)
//     open   half of A^2 J^(k-1) t^(k-2) plus the palindromes A J^(k/2) t^((k-1)/2)
//                                                   (k = 1: t E (E+1) / 2 + xE)
//     loops  (1/2k) [ Σ_{r<k} (tJ)^gcd(r,k) + walks that the k reflections leave as they are ]
//   distinct fingers
//     open   A^2 J^(k-1) t^(k-2) k! / 2             (k = 1 as above)
//     loops  t^k J^k (k-1)! / 2                     (k = 1: tJ; k = 2: t^2 J (J+1) / 2)
// A routing is a multiset of tendon shapes (identical fingers) or a set of labelled tendons. With
// floating blocks, of trees of tendons (tree_grammar.hpp); a tendon without blocks is
// a tree, too. What hangs on no motor is made of the parts that are not on the carriage.
//
// With K motors every join and end on a carriage is K kinds, and every motor pulls something.
// Identical motors: for each renaming π of them (Burnside), what it leaves as it is, a mean over
// the K! renamings; less the same for K - 1 motors. In the formulas a bead that is its own mirror
// image is then one that π leaves as it is, one of two that are exchanged one that π² does, and one
// of a cycle of L beads one that π^L does. Of a multiset of trees, π permutes the trees in cycles.
// Distinct fingers tell the motors apart, too: inclusion and exclusion over those that are used.
// Numbers beyond 2^63 are refused with an InputError.
#pragma once

#include <cstdint>
#include <vector>

#include "core/canonical.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

// Tendons by number of fingers: [k] for k = 1 … fingers; [0] is 0.
using TendonCounts = std::vector<std::uint64_t>;

TendonCounts tendon_counts(const PartSet& parts, int fingers, FingerIdentity identity);

// sets[r], r = 0 … fingers: sets of tendons, none with more than `largest` fingers, that pass r
// fingers in all. Distinct fingers: of r given fingers.
std::vector<std::uint64_t> tendon_sets(const TendonCounts& tendons, int largest,
                                       FingerIdentity identity);

struct RoutingCounts {
  std::uint64_t all = 0;
  std::uint64_t actuated = 0;    // every tree hangs on the carriage
  std::uint64_t one_tendon = 0;  // actuated, and a single tree
};

// Counts routings of 0 to parts.blocks floating blocks and exactly parts.motors motors.
RoutingCounts count_routings(const PartSet& parts, int fingers, FingerIdentity identity);

}  // namespace reeve::search
