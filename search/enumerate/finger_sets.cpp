#include "search/enumerate/finger_sets.hpp"

#include <bit>

namespace reeve::search {

FingerSet fingers_up_to(int fingers, FingerIdentity identity) {
  if (identity == FingerIdentity::identical || fingers == 0) return 0;
  return ~FingerSet{0} >> (64 - fingers);
}

// Finger by finger from the greatest: those sets first that are without it.
FingerSet take_some(FingerSet& set, int many, Digits& digits, FingerIdentity identity) {
  if (identity == FingerIdentity::identical) return 0;
  auto wanted = static_cast<std::uint64_t>(many);
  auto left = static_cast<std::uint64_t>(std::popcount(set));
  std::uint64_t rank = digits.take(binomial(left, wanted));
  FingerSet taken = 0;
  for (FingerSet open = set; wanted > 0; --left) {
    const FingerSet finger = std::bit_floor(open);
    open ^= finger;
    const std::uint64_t without = binomial(left - 1, wanted);
    if (rank < without) continue;
    rank -= without;
    taken |= finger;
    --wanted;
  }
  set ^= taken;
  return taken;
}

FingerSet take_least_and(FingerSet& set, int many, Digits& digits, FingerIdentity identity) {
  const FingerSet least = set & (~set + 1);
  set ^= least;
  return least | take_some(set, many, digits, identity);
}

int take_one(FingerSet& set, Digits& digits, FingerIdentity identity) {
  if (identity == FingerIdentity::identical) return 0;
  FingerSet open = set;
  for (auto skip = digits.take(static_cast<std::uint64_t>(std::popcount(set))); skip > 0; --skip) {
    open &= open - 1;
  }
  const int bit = std::countr_zero(open);
  set ^= FingerSet{1} << bit;
  return bit + 1;
}

}  // namespace reeve::search
