// A tendon that passes a block is two half-walks from it. With t tip, j join kinds, E for what may
// be at an end (M, F, or the tail of a block with all that hangs on it) and x z for an anchored
// tip:
//
//   half-walk  H = (x z + t z E) / (1 − j t z) + E
//   side       S = H + t z / (1 − j t z) where there are beckets
//   block      C = y [ (S² + swap(S)) / 2 − pairs of bare M, F + loops through the pass ]
//              and where it may be a bar as much with H in place of S, and where it may be passed
//              twice y times (S² t z / (1 − j t z) + swap(S) palindromes) / 2, but for bare M, F
//              on both sides
//   root       M C + t z (E² + swap(E)) / 2 + x z E + linked (C² + swap(C)) / 2
//                  + ( A² j / (1 − j t z) + swap(A) palindromes ) / 2 + loops,   A = x z + t z E
//   series     Σ_{q>1} ( H² (y U)^q g^(q−1) + palindromes ) / 2,   g = 1 + j beads between passes,
//              U = (x z + t z E) / (1 − j t z) + linked C: a tendon from a tail to its other end
//
// Identical fingers: ordinary series, swap(f)(z, y) = f(z², y²), and the Euler transform of trees.
// Distinct fingers: exponential series in z, so that only what has no finger equals its reversal,
// swap(f) = f(0, y²), and the exponential of trees.
#include "tests/support/counting.hpp"

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace reeve::testing {
namespace series {
namespace {

__extension__ using Wide = __int128;

std::int64_t narrow(Wide value) {
  const auto result = static_cast<std::int64_t>(value);
  if (result != value) throw std::overflow_error("count exceeds 63 bits");
  return result;
}

std::int64_t power(std::int64_t base, std::size_t exponent) {
  std::int64_t result = 1;
  for (std::size_t i = 0; i < exponent; ++i) result = narrow(Wide{result} * base);
  return result;
}

std::int64_t binomial(std::size_t n, std::size_t k) {
  std::int64_t result = 1;
  for (std::size_t i = 1; i <= k; ++i) {
    result =
        narrow(Wide{result} * static_cast<std::int64_t>(n - k + i) / static_cast<std::int64_t>(i));
  }
  return result;
}

std::int64_t factorial(std::size_t n) {
  std::int64_t result = 1;
  for (std::size_t i = 2; i <= n; ++i) result = narrow(Wide{result} * static_cast<int>(i));
  return result;
}

// Coefficients of z^n y^k, or of z^n y^k / n! where fingers are distinct.
struct Ring {
  std::size_t fingers;
  std::size_t blocks;
  bool identical;
};

class Series {
 public:
  explicit Series(const Ring& ring)
      : ring_(ring), c_(ring.fingers + 1, std::vector<std::int64_t>(ring.blocks + 1, 0)) {}
  // value z^n y^k
  Series(const Ring& ring, std::int64_t value, std::size_t n, std::size_t k) : Series(ring) {
    if (n > ring.fingers || k > ring.blocks) return;
    c_[n][k] = ring.identical ? value : narrow(Wide{value} * factorial(n));
  }

  const Ring& ring() const { return ring_; }
  std::int64_t& at(std::size_t n, std::size_t k) { return c_[n][k]; }
  std::int64_t at(std::size_t n, std::size_t k) const { return c_[n][k]; }

  friend Series operator+(Series a, const Series& b) {
    for (std::size_t n = 0; n < a.c_.size(); ++n)
      for (std::size_t k = 0; k < a.c_[n].size(); ++k)
        a.c_[n][k] = narrow(Wide{a.c_[n][k]} + b.c_[n][k]);
    return a;
  }

  friend Series operator*(const Series& a, const Series& b) {
    Series product(a.ring_);
    for (std::size_t n = 0; n <= a.ring_.fingers; ++n)
      for (std::size_t m = 0; m <= n; ++m) {
        const std::int64_t shuffles = a.ring_.identical ? 1 : binomial(n, m);
        for (std::size_t k = 0; k <= a.ring_.blocks; ++k)
          for (std::size_t l = 0; l <= k; ++l)
            product.c_[n][k] = narrow(product.c_[n][k] + narrow(Wide{shuffles} * a.c_[m][l]) *
                                                             Wide{b.c_[n - m][k - l]});
      }
    return product;
  }

 private:
  Ring ring_;
  std::vector<std::vector<std::int64_t>> c_;
};

Series operator*(std::int64_t factor, const Series& a) {
  return Series(a.ring(), factor, 0, 0) * a;
}

// Every halving is exact in theory; a remainder means that a formula is wrong.
Series half(Series a) {
  for (std::size_t n = 0; n <= a.ring().fingers; ++n)
    for (std::size_t k = 0; k <= a.ring().blocks; ++k) {
      if (a.at(n, k) % 2 != 0) throw std::logic_error("counting formula left a remainder");
      a.at(n, k) /= 2;
    }
  return a;
}

// What an exchange of two equal halves leaves as it is.
Series swap(const Series& a) {
  Series result(a.ring());
  for (std::size_t n = 0; 2 * n <= a.ring().fingers; ++n)
    for (std::size_t k = 0; 2 * k <= a.ring().blocks; ++k)
      if (n == 0 || a.ring().identical) result.at(2 * n, 2 * k) = a.at(n, k);
  return result;
}

struct Kinds {
  std::int64_t tips;
  std::int64_t joins;
  std::int64_t motors;
  std::int64_t ends;
  std::int64_t anchors;
  bool linked;
  bool series;
  bool barred;
  bool becketed;
  bool doubled;
};

// 1 / (1 − j t z): fingers with a join behind each.
Series chains(const Ring& ring, const Kinds& kinds) {
  Series sum(ring);
  for (std::size_t n = 0; n <= ring.fingers; ++n)
    sum = sum + Series(ring, power(kinds.joins * kinds.tips, n), n, 0);
  return sum;
}

// Strings of fingers, from finger to finger.
Series strings(const Ring& ring, const Kinds& kinds) {
  return kinds.tips * (Series(ring, 1, 1, 0) * chains(ring, kinds));
}

// … that read the same both ways.
Series same_strings(const Ring& ring, const Kinds& kinds) {
  Series sum(ring);
  for (std::size_t m = 1; m <= ring.fingers; ++m) {
    if (!ring.identical && m > 1) break;
    sum.at(m, 0) = power(kinds.tips, (m + 1) / 2) * power(kinds.joins, m / 2);
  }
  return sum;
}

// Blocks that a tendon with such sides passes once, or whose loop comes back to it.
Series passed_once(const Ring& ring, const Kinds& kinds, const Series& side) {
  const Series bare(ring, -kinds.ends * (kinds.ends + 1) / 2, 0, 0);
  return half(side * side + swap(side)) + bare +
         half(strings(ring, kinds) + same_strings(ring, kinds));
}

Series passed_twice(const Ring& ring, const Kinds& kinds, const Series& side) {
  const Series bare(ring, kinds.ends, 0, 0);
  return half((side * side + (-1) * bare * bare) * strings(ring, kinds) +
              (swap(side) + (-1) * bare) * same_strings(ring, kinds));
}

Series blocks(const Ring& ring, const Kinds& kinds) {
  const Series z(ring, 1, 1, 0);
  const Series chain = chains(ring, kinds);
  Series below(ring);
  for (std::size_t k = 0; k <= ring.blocks; ++k) {  // each round gets one power of y right
    const Series end = Series(ring, kinds.ends, 0, 0) + below;
    const Series walk = (kinds.anchors * z + kinds.tips * (z * end)) * chain + end;
    const Series side = kinds.becketed ? walk + strings(ring, kinds) : walk;
    Series all = passed_once(ring, kinds, side);
    if (kinds.barred) all = all + passed_once(ring, kinds, walk);
    if (kinds.doubled) all = all + passed_twice(ring, kinds, side);
    below = Series(ring, 1, 0, 1) * all;
  }
  return below;
}

// Of an open root of two or more fingers, what reads the same both ways.
Series palindromes(const Ring& ring, const Kinds& kinds, const Series& last) {
  Series sum(ring);
  if (!ring.identical) return sum;
  for (std::size_t m = 2; m <= ring.fingers; ++m) {
    const std::int64_t beads = power(kinds.joins, m / 2) * power(kinds.tips, (m - 1) / 2);
    sum = sum + swap(last) * Series(ring, beads, m - 2, 0);
  }
  return sum;
}

std::int64_t loops(const Ring& ring, const Kinds& kinds, std::size_t m) {
  const std::int64_t both = kinds.tips * kinds.joins;
  const auto size = static_cast<std::int64_t>(m);
  if (!ring.identical) {
    if (m == 1) return both;
    if (m == 2) return kinds.tips * kinds.tips * kinds.joins * (kinds.joins + 1) / 2;
    return narrow(Wide{power(both, m)} * (factorial(m - 1) / 2));
  }
  std::int64_t fixed = 0;
  for (std::size_t r = 0; r < m; ++r) fixed += power(both, std::gcd(r, m));
  for (std::size_t r = 0; r < m; ++r) {  // reflections, by the tips and joins that each leaves
    const bool through_tips = m % 2 == 1 || r % 2 == 0;
    const std::size_t tips = m / 2 + (through_tips ? 1 : 0);
    fixed += power(kinds.tips, tips) * power(kinds.joins, m % 2 == 1 ? tips : m + 1 - tips);
  }
  if (fixed % (2 * size) != 0) throw std::logic_error("counting formula left a remainder");
  return fixed / (2 * size);
}

Series raised(const Series& base, std::size_t exponent) {
  Series result(base.ring(), 1, 0, 0);
  for (std::size_t i = 0; i < exponent; ++i) result = result * base;
  return result;
}

// Roots that pass two blocks or more, by what hangs on these and at their own ends.
Series roots_in_series(const Ring& ring, const Kinds& kinds, const Series& below) {
  const Series z(ring, 1, 1, 0);
  const Series end = Series(ring, kinds.ends, 0, 0) + below;
  const Series fingers = (kinds.anchors * z + kinds.tips * (z * end)) * chains(ring, kinds);
  const Series walk = fingers + end;
  const Series pass = Series(ring, 1, 0, 1) * (kinds.linked ? fingers + below : fingers);
  Series sum(ring);
  for (std::size_t q = 2; q <= ring.blocks; ++q) {
    const Series all = power(1 + kinds.joins, q - 1) * (walk * walk * raised(pass, q));
    const Series middle = q % 2 == 0 ? Series(ring, 1, 0, 0) : pass;
    const Series same =
        power(1 + kinds.joins, q / 2) * (swap(walk) * raised(swap(pass), q / 2) * middle);
    sum = sum + half(all + same);
  }
  return sum;
}

Series trees(const Ring& ring, const Kinds& kinds) {
  const Series z(ring, 1, 1, 0);
  const Series below = blocks(ring, kinds);
  const Series end = Series(ring, kinds.ends, 0, 0) + below;
  const Series last = kinds.anchors * z + kinds.tips * (z * end);
  Series sum = kinds.motors * below;
  sum = sum + kinds.tips * (z * half(end * end + swap(end))) + kinds.anchors * (z * end);
  if (kinds.linked) sum = sum + half(below * below + swap(below));
  if (kinds.series) sum = sum + roots_in_series(ring, kinds, below);
  sum = sum +
        half(kinds.joins * (last * last * chains(ring, kinds)) + palindromes(ring, kinds, last));
  for (std::size_t m = 1; m <= ring.fingers; ++m) {
    Series closed(ring);
    closed.at(m, 0) = loops(ring, kinds, m);
    sum = sum + closed;
  }
  return sum;
}

// n a = Σ c(m,l) a(n−m, k−l), c(m,l) = Σ_{d | m, l} (m/d) b(m/d, l/d): the logarithmic derivative
// of Π (1 − z^m y^l)^−b(m,l).
Series multisets(const Series& b) {
  const Ring& ring = b.ring();
  Series c(ring);
  for (std::size_t m = 1; m <= ring.fingers; ++m)
    for (std::size_t l = 0; l <= ring.blocks; ++l)
      for (std::size_t d = 1; d * m <= ring.fingers && d * l <= ring.blocks; ++d)
        c.at(d * m, d * l) += static_cast<std::int64_t>(m) * b.at(m, l);
  Series a(ring, 1, 0, 0);
  for (std::size_t n = 1; n <= ring.fingers; ++n)
    for (std::size_t k = 0; k <= ring.blocks; ++k) {
      Wide sum = 0;
      for (std::size_t m = 1; m <= n; ++m)
        for (std::size_t l = 0; l <= k; ++l) sum += Wide{c.at(m, l)} * a.at(n - m, k - l);
      if (sum % static_cast<int>(n) != 0) throw std::logic_error("a remainder was left");
      a.at(n, k) = narrow(sum / static_cast<int>(n));
    }
  return a;
}

// Exponential of the trees: the tree of the last finger takes m − 1 of the others with it.
Series labelled_sets(const Series& b) {
  const Ring& ring = b.ring();
  Series a(ring, 1, 0, 0);
  for (std::size_t n = 1; n <= ring.fingers; ++n)
    for (std::size_t m = 1; m <= n; ++m)
      for (std::size_t k = 0; k <= ring.blocks; ++k)
        for (std::size_t l = 0; l <= k; ++l)
          a.at(n, k) = narrow(a.at(n, k) + narrow(Wide{binomial(n - 1, m - 1)} * b.at(m, l)) *
                                               Wide{a.at(n - m, k - l)});
  return a;
}

}  // namespace
}  // namespace series

RoutingCounts count_trees(const CountedTreeParts& counted, int fingers, int blocks,
                          bool identical_fingers) {
  const CountedParts& parts = counted.parts;
  const auto n = static_cast<std::size_t>(fingers);
  const auto k = static_cast<std::size_t>(blocks);
  const series::Ring ring{n, k, identical_fingers};
  const std::int64_t anchors = counted.anchored ? 1 : 0;
  const int joins = parts.passive_joins + parts.motor_joins;
  const int ends = parts.motor_ends + parts.fixed_ends;
  const auto trees_with = [&](int with_joins, int motor_ends, int with_ends) {
    return series::trees(
        ring, {parts.tube_like_tips, with_joins, motor_ends, with_ends, anchors, counted.linked,
               counted.series, counted.barred, counted.becketed, counted.doubled});
  };
  const auto all = trees_with(joins, parts.motor_ends, ends);
  const auto passive = trees_with(parts.passive_joins, 0, parts.fixed_ends);
  const auto actuated = all + (-1) * passive;
  const auto routings = [&](const series::Series& trees) {
    const auto sets = identical_fingers ? series::multisets(trees) : series::labelled_sets(trees);
    return static_cast<std::uint64_t>(sets.at(n, k));
  };
  return {routings(all), routings(actuated), static_cast<std::uint64_t>(actuated.at(n, k))};
}

}  // namespace reeve::testing
