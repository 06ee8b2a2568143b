// Digits of an index, and the things that they number.
#pragma once

#include <cstdint>
#include <utility>

#include "search/enumerate/checked.hpp"

namespace reeve::search {

// A number of mixed radix, read from its last digit on.
class Digits {
 public:
  explicit Digits(std::uint64_t number) : rest_(number) {}

  std::uint64_t rest() const { return rest_; }

  std::uint64_t take(std::uint64_t radix) {
    const std::uint64_t digit = rest_ % radix;
    rest_ /= radix;
    return digit;
  }

  // Whether the number is among the first `count`; otherwise takes these off.
  bool is_among(std::uint64_t count) {
    if (rest_ < count) return true;
    rest_ -= count;
    return false;
  }

 private:
  std::uint64_t rest_;
};

// Multisets of m of the numbers below n, greatest number first, have the indices below
// multichoose(n, m). Gives the greatest number, and leaves the index of the others, which are a
// multiset of m - 1: the greatest is a if multichoose(a, m) <= index < multichoose(a + 1, m).
inline std::uint64_t greatest_of_multiset(std::uint64_t n, std::uint64_t m, std::uint64_t& index) {
  if (m == 1) return std::exchange(index, 0);
  std::uint64_t low = 0;
  std::uint64_t high = n;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (multichoose(middle, m) <= index ? low : high) = middle;
  }
  index -= multichoose(low, m);
  return low;
}

}  // namespace reeve::search
