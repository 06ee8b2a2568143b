// Counting numbers that refuse to wrap round.
#pragma once

#include <cstdint>

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

}  // namespace reeve::search
