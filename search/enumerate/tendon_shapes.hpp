// Numbers of tendons without blocks, of identical fingers, up to their symmetries (Burnside).
//
// The formulas are those of counting.hpp. They hold for all numbers that add up and multiply as
// numbers of things do, and that know how many cycles there are of so many equal things: for
// numbers by class of parts (limits/class_counts.hpp), or by power of a renaming of the motors.
// `Numbers` has the type Number, and count(many) of things without any part, sum(a, b),
// product(a, b), divided(a, by) and cycles(a, length).
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>

#include "numerics/floors.hpp"

namespace reeve::search {

// Numbers of kinds. The last finger of a tendon of several comes with its end, or is anchored.
template <typename Number>
struct BeadKinds {
  Number tips;
  Number joins;
  Number ends;
  Number anchors;
};

template <typename Numbers>
class TendonShapes {
 public:
  using Number = typename Numbers::Number;

  TendonShapes(Numbers numbers, BeadKinds<Number> kinds)
      : n_(std::move(numbers)),
        kinds_(std::move(kinds)),
        last_fingers_(n_.sum(n_.product(kinds_.tips, kinds_.ends), kinds_.anchors)) {}

  // Open ones of k fingers.
  Number open(int k) const {
    if (k == 1) {
      const Number to_ends = n_.product(kinds_.tips, pairs(power(kinds_.ends, 2), kinds_.ends));
      return n_.sum(to_ends, n_.product(kinds_.anchors, kinds_.ends));
    }
    const bool finger_in_the_middle = k % 2 == 1;
    const Number walks = n_.product(
        power(last_fingers_, 2), n_.product(power(kinds_.joins, k - 1), power(kinds_.tips, k - 2)));
    const Number same =
        n_.product(mirrored(kinds_.joins, finger_in_the_middle ? 0 : 1, (k - 1) / 2),
                   mirrored(kinds_.tips, finger_in_the_middle ? 1 : 0, (k - 2) / 2));
    return n_.divided(n_.sum(walks, n_.product(n_.cycles(last_fingers_, 2), same)), 2);
  }

  // Closed ones.
  Number loops(int k) const {
    const Number bead = n_.product(kinds_.tips, kinds_.joins);
    Number fixed = reflected(k);
    for (int turn = 0; turn < k; ++turn) {
      const int cycles = std::gcd(turn, k);
      fixed = n_.sum(fixed, n_.cycles(power(bead, cycles), k / cycles));
    }
    return n_.divided(fixed, 2 * static_cast<std::uint64_t>(k));
  }

 private:
  Number power(const Number& number, int exponent) const {
    Number result = n_.count(1);
    for (int i = 0; i < exponent; ++i) result = n_.product(result, number);
    return result;
  }

  // Unordered pairs, of `all` ordered ones.
  Number pairs(const Number& all, const Number& of) const {
    return n_.divided(n_.sum(all, n_.cycles(of, 2)), 2);
  }

  // Some beads that stand alone and some that stand in pairs of equals.
  Number mirrored(const Number& beads, int alone, int pairs) const {
    return n_.product(power(beads, alone), power(n_.cycles(beads, 2), pairs));
  }

  Number rings(int tips_alone, int tip_pairs, int joins_alone, int join_pairs) const {
    return n_.product(mirrored(kinds_.tips, tips_alone, tip_pairs),
                      mirrored(kinds_.joins, joins_alone, join_pairs));
  }

  // Loops that the k reflections leave as they are. An axis passes through two opposite beads of
  // the ring of k fingers and k joins.
  Number reflected(int k) const {
    const int half = k / 2;
    if (k % 2 == 1) return n_.product(n_.count(k), rings(1, half, 1, half));
    return n_.product(n_.count(half),
                      n_.sum(rings(2, half - 1, 0, half), rings(0, half, 2, half - 1)));
  }

  Numbers n_;
  BeadKinds<Number> kinds_;
  Number last_fingers_;
};

}  // namespace reeve::search
