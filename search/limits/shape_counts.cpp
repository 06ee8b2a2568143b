#include "search/limits/shape_counts.hpp"

#include <numeric>

namespace reeve::search {
namespace {

// The beads of a walk, and its last finger with its end, or as one.
struct Beads {
  ClassCounts tips;
  ClassCounts joins;
  ClassCounts ends;
  ClassCounts last_fingers;
};

Beads beads_of(const PartClasses& classes, const PartSet& parts) {
  const auto kinds = [&](const std::vector<TokenKind>& of) {
    ClassCounts counts = no_counts(classes);
    for (const TokenKind kind : of) ++counts[classes.of(plain(kind))];
    return counts;
  };
  Beads beads{no_counts(classes), kinds(parts.joins), kinds(parts.ends), {}};
  for (const TipKind tip : parts.tips) ++beads.tips[classes.of(finger(0, tip))];
  beads.last_fingers = product(classes, beads.tips, beads.ends);
  if (parts.anchored) ++beads.last_fingers[classes.of(anchored_tip(0))];
  return beads;
}

// Some beads that stand alone and some that stand in pairs of equals.
ClassCounts mirrored_beads(const PartClasses& classes, const ClassCounts& beads, int alone,
                           int pairs) {
  return product(classes, power(classes, beads, alone),
                 power(classes, repeated(classes, beads, 2), pairs));
}

ClassCounts open_of_one(const PartClasses& classes, const PartSet& parts, const Beads& beads) {
  ClassCounts counts = product(classes, beads.tips, multisets(classes, beads.ends, 2));
  if (parts.anchored) add(counts, shifted(classes, beads.ends, classes.of(anchored_tip(0))));
  return counts;
}

// Half of all walks and of those that read the same backwards.
ClassCounts open_of_several(const PartClasses& classes, const Beads& beads, int k) {
  ClassCounts counts = power(classes, beads.last_fingers, 2);
  counts = product(classes, counts, power(classes, beads.joins, k - 1));
  counts = product(classes, counts, power(classes, beads.tips, k - 2));
  const bool finger_in_the_middle = k % 2 == 1;
  ClassCounts same = repeated(classes, beads.last_fingers, 2);
  same = product(classes, same,
                 mirrored_beads(classes, beads.joins, finger_in_the_middle ? 0 : 1, (k - 1) / 2));
  same = product(classes, same,
                 mirrored_beads(classes, beads.tips, finger_in_the_middle ? 1 : 0, (k - 2) / 2));
  add(counts, same);
  divide(counts, 2);
  return counts;
}

ClassCounts rings(const PartClasses& classes, const Beads& beads, int tips_alone, int tip_pairs,
                  int joins_alone, int join_pairs) {
  return product(classes, mirrored_beads(classes, beads.tips, tips_alone, tip_pairs),
                 mirrored_beads(classes, beads.joins, joins_alone, join_pairs));
}

// Rings that the k reflections leave as they are.
ClassCounts reflected_rings(const PartClasses& classes, const Beads& beads, int k) {
  const int half = k / 2;
  ClassCounts counts = no_counts(classes);
  if (k % 2 == 1) {
    add(counts, rings(classes, beads, 1, half, 1, half), static_cast<std::uint64_t>(k));
    return counts;
  }
  add(counts, rings(classes, beads, 2, half - 1, 0, half), static_cast<std::uint64_t>(half));
  add(counts, rings(classes, beads, 0, half, 2, half - 1), static_cast<std::uint64_t>(half));
  return counts;
}

ClassCounts closed_shapes(const PartClasses& classes, const Beads& beads, int k) {
  ClassCounts fixed = reflected_rings(classes, beads, k);
  const ClassCounts bead = product(classes, beads.tips, beads.joins);
  for (int turn = 0; turn < k; ++turn) {
    const int period = std::gcd(turn, k);
    add(fixed, repeated(classes, power(classes, bead, period), k / period));
  }
  divide(fixed, 2 * static_cast<std::uint64_t>(k));
  return shifted(classes, fixed, classes.of_loop());
}

}  // namespace

std::vector<ClassCounts> shape_counts(const PartClasses& classes, const PartSet& parts,
                                      int fingers) {
  const Beads beads = beads_of(classes, parts);
  std::vector<ClassCounts> shapes{no_counts(classes)};
  for (int k = 1; k <= fingers; ++k) {
    shapes.push_back(k == 1 ? open_of_one(classes, parts, beads)
                            : open_of_several(classes, beads, k));
    add(shapes.back(), closed_shapes(classes, beads, k));
  }
  return shapes;
}

std::vector<std::vector<ClassCounts>> shape_sets(const PartClasses& classes,
                                                 const std::vector<ClassCounts>& shapes) {
  const std::size_t fingers = shapes.size() - 1;
  std::vector<std::vector<ClassCounts>> sets(
      1, std::vector<ClassCounts>(fingers + 1, no_counts(classes)));
  sets[0][0][PartClasses::none] = 1;
  for (std::size_t size = 1; size <= fingers; ++size) {
    const ClassCounts trees = of_trees(classes, shapes[size]);
    std::vector<ClassCounts> with(fingers + 1, no_counts(classes));
    for (std::size_t many = 0; many * size <= fingers; ++many) {
      const ClassCounts of_size = multisets(classes, trees, static_cast<int>(many));
      for (std::size_t r = many * size; r <= fingers; ++r) {
        add(with[r], product(classes, of_size, sets[size - 1][r - many * size]));
      }
    }
    sets.push_back(std::move(with));
  }
  return sets;
}

}  // namespace reeve::search
