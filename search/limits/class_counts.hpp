// Numbers of things in each class of parts (part_classes.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "search/enumerate/parts.hpp"
#include "search/limits/part_classes.hpp"

namespace reeve::search {

using ClassCounts = std::vector<std::uint64_t>;  // [class]

ClassCounts no_counts(const PartClasses& classes);
void add(ClassCounts& to, const ClassCounts& counts, std::uint64_t times = 1);
void subtract(ClassCounts& from, const ClassCounts& counts);

// One of the first and one of the second.
ClassCounts product(const PartClasses& classes, const ClassCounts& a, const ClassCounts& b);
ClassCounts shifted(const PartClasses& classes, const ClassCounts& counts, PartClass by);
// Counts multisets of `many` things.
ClassCounts multisets(const PartClasses& classes, const ClassCounts& counts, int many);
// Sums that some of these things complete to a wanted one.
ClassSet completed_sums(const PartClasses& classes, const ClassCounts& counts,
                        const ClassSet& wanted);
// Trees as they stand among others: PartClasses::of_tree.
ClassCounts of_trees(const PartClasses& classes, const ClassCounts& trees);

// Returns the number of tendons without blocks in each class of parts, by the formulas of
// enumerate/tendon_shapes.hpp. Element [k] has the tendons through k fingers up to
// their symmetries; [0] is empty.
std::vector<ClassCounts> shape_counts(const PartClasses& classes, const PartSet& parts,
                                      int fingers);

// Counts multisets of tendons: sets[largest][r] pass r fingers in all, none more than `largest`.
std::vector<std::vector<ClassCounts>> shape_sets(const PartClasses& classes,
                                                 const std::vector<ClassCounts>& shapes);

}  // namespace reeve::search
