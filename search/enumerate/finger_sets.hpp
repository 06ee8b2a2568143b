// Sets of distinct fingers, chosen by digits of an index. With identical fingers there is nothing
// to choose: every set is empty and every finger 0, and no digits are taken.
#pragma once

#include <cstdint>

#include "core/canonical.hpp"
#include "search/enumerate/digits.hpp"

namespace reeve::search {

// Bit f − 1 is finger f.
using FingerSet = std::uint64_t;

FingerSet fingers_up_to(int fingers, FingerIdentity identity);

// Takes so many out of the set; choices_of(many, size of the set) ways.
FingerSet take_some(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … the least and so many besides it; choices_of(many, size of the set - 1) ways.
FingerSet take_least_and(FingerSet& set, int many, Digits& digits, FingerIdentity identity);
// … any one; as many ways as the set has fingers.
int take_one(FingerSet& set, Digits& digits, FingerIdentity identity);

}  // namespace reeve::search
