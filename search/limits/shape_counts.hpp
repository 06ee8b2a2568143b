// How many tendons without blocks there are of each class of parts: the formulas of
// enumerate/counting.hpp for identical fingers, with a count for each class in place of numbers.
#pragma once

#include <vector>

#include "search/enumerate/parts.hpp"
#include "search/limits/class_counts.hpp"

namespace reeve::search {

// Tendons through k fingers up to their symmetries, [k]; [0] is none.
std::vector<ClassCounts> shape_counts(const PartClasses& classes, const PartSet& parts,
                                      int fingers);

// Of multisets of tendons: sets[largest][r] pass r fingers in all, none more than `largest`.
std::vector<std::vector<ClassCounts>> shape_sets(const PartClasses& classes,
                                                 const std::vector<ClassCounts>& shapes);

}  // namespace reeve::search
