// A tendon over k fingers is a string of beads in which tips and joins alternate:
//
//   path   e t j t j ... j t e    k tips, k - 1 joins, 2 ends
//   loop   t j t j ... t j (t)    k tips, k joins, closed
//
// Swapping the two strands of a finger changes nothing in that string, so strands do not appear
// below. All part kinds are symmetric: a string read backwards is the same tendon.
//
// Symbols: t, j, e are the numbers of tip, join and end kinds, k the fingers of one tendon, n the
// fingers of the routing.
#include "tests/support/counting.hpp"

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace reeve::testing {
namespace {

using Count = std::uint64_t;

Count add(Count a, Count b) {
  Count sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) throw std::overflow_error("count exceeds 64 bits");
  return sum;
}

Count multiply(Count a, Count b) {
  Count product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw std::overflow_error("count exceeds 64 bits");
  return product;
}

// Every division below is exact in theory; a remainder means that a formula is wrong.
Count divide_exactly(Count a, Count b) {
  if (a % b != 0) throw std::logic_error("counting formula left a remainder");
  return a / b;
}

// 0^0 = 1: no joins to choose from is no obstacle to a tendon without joins.
Count power(Count base, Count exponent) {
  Count result = 1;
  for (Count i = 0; i < exponent; ++i) result = multiply(result, base);
  return result;
}

Count product(Count a, Count b, Count c) { return multiply(multiply(a, b), c); }

Count factorial(Count k) {
  Count result = 1;
  for (Count i = 2; i <= k; ++i) result = multiply(result, i);
  return result;
}

// C(n, k) = prod_{i=1..k} (n - k + i) / i; each partial product is itself a binomial.
Count binomial(Count n, Count k) {
  Count result = 1;
  for (Count i = 1; i <= k; ++i) result = divide_exactly(multiply(result, n - k + i), i);
  return result;
}

struct Kinds {
  Count tips;
  Count joins;
  Count ends;
};

// Two equal halves may carry the same choice: x(x + 1)/2 unordered pairs of x kinds.
Count unordered_pairs(Count kinds) { return divide_exactly(multiply(kinds, add(kinds, 1)), 2); }

// Paths up to reversal, by Burnside over {identity, reversal}:
//
//   ( t^k j^(k-1) e^2  +  t^ceil(k/2) j^ceil((k-1)/2) e ) / 2
//
// The second term counts palindromes: the beads mirror in pairs, but for the one in the middle.
Count unlabelled_paths(const Kinds& kinds, Count k) {
  const Count strings =
      product(power(kinds.tips, k), power(kinds.joins, k - 1), power(kinds.ends, 2));
  const Count palindromes =
      product(power(kinds.tips, (k + 1) / 2), power(kinds.joins, k / 2), kinds.ends);
  return divide_exactly(add(strings, palindromes), 2);
}

// Strings fixed by the k rotations. Turning by r fingers has gcd(k, r) cycles on the tips and as
// many on the joins; by totients it is sum_{d | k} phi(d) (t j)^(k/d), here summed over r itself.
Count fixed_by_rotations(const Kinds& kinds, Count k) {
  const Count tip_and_join = multiply(kinds.tips, kinds.joins);
  Count fixed = 0;
  for (Count r = 0; r < k; ++r) fixed = add(fixed, power(tip_and_join, std::gcd(k, r)));
  return fixed;
}

// Strings fixed by the k reflections. An axis meets the loop of 2k beads in two opposite beads.
//
//   k odd:  opposite beads are a tip and a join,    k axes:    t^((k+1)/2) j^((k+1)/2) each
//   k even: opposite beads are two tips,          k/2 axes:    t^(k/2+1)   j^(k/2)     each
//                              or two joins,      k/2 axes:    t^(k/2)     j^(k/2+1)   each
//
// These hold for k = 1 and k = 2 too, as long as the group is taken with 2k elements. For k = 1 the
// reflection is walking the loop backwards, which fixes both beads: (tj + tj)/2 = tj. For k = 2 the
// two reflections exchange only the joins and only the tips.
Count fixed_by_reflections(const Kinds& kinds, Count k) {
  const Count half = k / 2;
  if (k % 2 == 1) return product(k, power(kinds.tips, half + 1), power(kinds.joins, half + 1));
  const Count through_tips = product(half, power(kinds.tips, half + 1), power(kinds.joins, half));
  const Count through_joins = product(half, power(kinds.tips, half), power(kinds.joins, half + 1));
  return add(through_tips, through_joins);
}

// Loops up to the dihedral group of 2k elements, by Burnside: mean number of fixed strings.
Count unlabelled_loops(const Kinds& kinds, Count k) {
  const Count fixed = add(fixed_by_rotations(kinds, k), fixed_by_reflections(kinds, k));
  return divide_exactly(fixed, multiply(2, k));
}

// Paths over k numbered fingers up to reversal. For k >= 2 no string equals its reverse, since the
// numbers differ: k!/2 t^k j^(k-1) e^2. For k = 1 reversal only exchanges the ends: t e(e+1)/2.
Count labelled_paths(const Kinds& kinds, Count k) {
  if (k == 1) return multiply(kinds.tips, unordered_pairs(kinds.ends));
  const Count orders = divide_exactly(factorial(k), 2);
  return multiply(orders,
                  product(power(kinds.tips, k), power(kinds.joins, k - 1), power(kinds.ends, 2)));
}

// Loops over k numbered fingers up to rotation and reflection. For k >= 3 none of the 2k symmetries
// but the identity keeps every number in place: k!/(2k) t^k j^k. Otherwise some do:
//   k = 1: there is one cyclic order, and both symmetries fix tip and join: t j;
//   k = 2: the reflection through both tips exchanges the joins between them: t^2 j(j+1)/2.
Count labelled_loops(const Kinds& kinds, Count k) {
  if (k == 1) return multiply(kinds.tips, kinds.joins);
  if (k == 2) return multiply(power(kinds.tips, 2), unordered_pairs(kinds.joins));
  const Count orders = divide_exactly(factorial(k - 1), 2);
  return product(orders, power(kinds.tips, k), power(kinds.joins, k));
}

// Element k is the number of single tendons over exactly k fingers; element 0 is unused.
using Tendons = std::vector<Count>;
using TendonCounter = Count (*)(const Kinds&, Count k);

Tendons tendons_up_to(std::size_t n, const Kinds& kinds, TendonCounter paths, TendonCounter loops) {
  Tendons tendons(n + 1, 0);
  for (std::size_t k = 1; k <= n; ++k) tendons[k] = add(paths(kinds, k), loops(kinds, k));
  return tendons;
}

// Multisets of tendons with n fingers in all, b_k tendons having k fingers: the Euler transform
//
//   sum_n a_n x^n = prod_k (1 - x^k)^(-b_k)
//
// whose logarithmic derivative gives  n a_n = sum_{k=1..n} c_k a_{n-k},  c_k = sum_{d | k} d b_d.
Count multisets(const Tendons& b) {
  const std::size_t n = b.size() - 1;
  std::vector<Count> c(n + 1, 0);
  for (std::size_t d = 1; d <= n; ++d)
    for (std::size_t k = d; k <= n; k += d) c[k] = add(c[k], multiply(d, b[d]));

  std::vector<Count> a(n + 1, 0);
  a[0] = 1;
  for (std::size_t m = 1; m <= n; ++m) {
    Count sum = 0;
    for (std::size_t k = 1; k <= m; ++k) sum = add(sum, multiply(c[k], a[m - k]));
    a[m] = divide_exactly(sum, m);
  }
  return a[n];
}

// Sets of tendons on n numbered fingers: the exponential formula  sum_n a_n x^n/n! =
// exp(sum_k b_k x^k/k!). The tendon of the last finger takes k - 1 of the other n - 1 with it:
//
//   a_n = sum_{k=1..n} C(n-1, k-1) b_k a_{n-k}
Count labelled_sets(const Tendons& b) {
  const std::size_t n = b.size() - 1;
  std::vector<Count> a(n + 1, 0);
  a[0] = 1;
  for (std::size_t m = 1; m <= n; ++m)
    for (std::size_t k = 1; k <= m; ++k)
      a[m] = add(a[m], product(binomial(m - 1, k - 1), b[k], a[m - k]));
  return a[n];
}

Count checked(int kinds) {
  if (kinds < 0) throw std::invalid_argument("number of part kinds is negative");
  return static_cast<Count>(kinds);
}

std::size_t checked_fingers(int fingers) {
  if (fingers < 1) throw std::invalid_argument("number of fingers is less than 1");
  return static_cast<std::size_t>(fingers);
}

Kinds all_kinds(const CountedParts& parts) {
  return {checked(parts.tube_like_tips),
          add(checked(parts.passive_joins), checked(parts.motor_joins)),
          add(checked(parts.motor_ends), checked(parts.fixed_ends))};
}

Kinds kinds_without_motor(const CountedParts& parts) {
  return {checked(parts.tube_like_tips), checked(parts.passive_joins), checked(parts.fixed_ends)};
}

// A tendon is not actuated exactly when all its joins and ends are without motor, and a symmetry
// never changes that: actuated tendons are all tendons less those made of the motorless kinds.
Tendons difference(const Tendons& all, const Tendons& without_motor) {
  Tendons actuated(all.size(), 0);
  for (std::size_t k = 1; k < all.size(); ++k) actuated[k] = all[k] - without_motor[k];
  return actuated;
}

RoutingCounts count(const CountedParts& parts, int fingers, TendonCounter paths,
                    TendonCounter loops, Count (*collections)(const Tendons&)) {
  const std::size_t n = checked_fingers(fingers);
  const Tendons all = tendons_up_to(n, all_kinds(parts), paths, loops);
  const Tendons actuated =
      difference(all, tendons_up_to(n, kinds_without_motor(parts), paths, loops));
  return {collections(all), collections(actuated), actuated[n]};
}

}  // namespace

RoutingCounts count_identical(const CountedParts& parts, int fingers) {
  return count(parts, fingers, unlabelled_paths, unlabelled_loops, multisets);
}

RoutingCounts count_distinct(const CountedParts& parts, int fingers) {
  return count(parts, fingers, labelled_paths, labelled_loops, labelled_sets);
}

}  // namespace reeve::testing
