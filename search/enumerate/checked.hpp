// Counting numbers that refuse to wrap round, and the things that they number.
#pragma once

#include <cstdint>
#include <utility>

#include "core/error.hpp"

namespace reeve::search {

__extension__ using Wide = unsigned __int128;

inline std::uint64_t narrow(Wide value) {
  if (value >> 63 != 0) {
    throw InputError(
        "these parts and fingers make more than 2^63 routings: fewer fingers or parts are needed");
  }
  return static_cast<std::uint64_t>(value);
}

inline std::uint64_t times(std::uint64_t a, std::uint64_t b) { return narrow(Wide{a} * b); }
inline std::uint64_t plus(std::uint64_t a, std::uint64_t b) { return narrow(Wide{a} + b); }

inline std::uint64_t power(std::uint64_t base, int exponent) {
  std::uint64_t result = 1;
  for (int i = 0; i < exponent; ++i) result = times(result, base);
  return result;
}

inline std::uint64_t factorial(int n) {
  std::uint64_t result = 1;
  for (int i = 2; i <= n; ++i) result = times(result, static_cast<std::uint64_t>(i));
  return result;
}

// n choose k
inline std::uint64_t binomial(std::uint64_t n, std::uint64_t k) {
  if (k > n) return 0;
  std::uint64_t result = 1;
  for (std::uint64_t i = 1; i <= k; ++i) result = narrow(Wide{result} * (n - k + i) / i);
  return result;
}

// Multisets of k things of n kinds.
inline std::uint64_t multichoose(std::uint64_t n, std::uint64_t k) {
  if (k == 0) return 1;
  return n == 0 ? 0 : binomial(n + k - 1, k);
}

// Unordered pairs of n things, by Burnside: the exchange of the sides leaves `twins` as they are.
inline std::uint64_t unordered_pairs(std::uint64_t n, std::uint64_t twins) {
  return narrow((Wide{n} * n + twins) / 2);
}

// An index as a number of mixed radix, read from its last digit on.
class Digits {
 public:
  explicit Digits(std::uint64_t number) : rest_(number) {}

  std::uint64_t rest() const { return rest_; }

  std::uint64_t take(std::uint64_t radix) {
    const std::uint64_t digit = rest_ % radix;
    rest_ /= radix;
    return digit;
  }

  // True if the number is among the first `count`; otherwise subtracts `count`.
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
