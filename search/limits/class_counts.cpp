#include "search/limits/class_counts.hpp"

#include <numeric>

#include "search/enumerate/checked.hpp"

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

PartClass many_times(const PartClasses& classes, PartClass of, int times) {
  PartClass sum = PartClasses::none;
  for (int i = 0; i < times; ++i) sum = classes.plus(sum, of);
  return sum;
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

ClassCounts no_counts(const PartClasses& classes) { return ClassCounts(classes.count(), 0); }

ClassCounts one_of(const PartClasses& classes, PartClass of) {
  ClassCounts counts = no_counts(classes);
  counts[of] = 1;
  return counts;
}

ClassCounts each_of(const PartClasses& classes, const std::vector<PartClass>& things) {
  ClassCounts counts = no_counts(classes);
  for (const PartClass thing : things) ++counts[thing];
  return counts;
}

std::uint64_t sum_of(const ClassCounts& counts) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) sum = plus(sum, count);
  return sum;
}

ClassSet support(const ClassCounts& counts) {
  ClassSet set;
  for (std::size_t c = 0; c < counts.size(); ++c) {
    if (counts[c] > 0) set.set(c);
  }
  return set;
}

void add(ClassCounts& to, const ClassCounts& counts, std::uint64_t many) {
  for (std::size_t c = 0; c < to.size(); ++c) to[c] = plus(to[c], times(many, counts[c]));
}

void subtract(ClassCounts& from, const ClassCounts& counts) {
  for (std::size_t c = 0; c < from.size(); ++c) from[c] -= counts[c];
}

void divide(ClassCounts& counts, std::uint64_t by) {
  for (std::uint64_t& count : counts) count /= by;
}

ClassCounts product(const PartClasses& classes, const ClassCounts& a, const ClassCounts& b) {
  ClassCounts counts = no_counts(classes);
  for (std::size_t x = 0; x < a.size(); ++x) {
    for (std::size_t y = 0; a[x] > 0 && y < b.size(); ++y) {
      if (b[y] == 0) continue;
      std::uint64_t& sum =
          counts[classes.plus(static_cast<PartClass>(x), static_cast<PartClass>(y))];
      sum = plus(sum, times(a[x], b[y]));
    }
  }
  return counts;
}

ClassCounts shifted(const PartClasses& classes, const ClassCounts& counts, PartClass by) {
  ClassCounts moved = no_counts(classes);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    std::uint64_t& sum = moved[classes.plus(static_cast<PartClass>(c), by)];
    sum = plus(sum, counts[c]);
  }
  return moved;
}

ClassCounts repeated(const PartClasses& classes, const ClassCounts& counts, int times) {
  ClassCounts moved = no_counts(classes);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    std::uint64_t& sum = moved[many_times(classes, static_cast<PartClass>(c), times)];
    sum = plus(sum, counts[c]);
  }
  return moved;
}

ClassCounts power(const PartClasses& classes, const ClassCounts& counts, int exponent) {
  ClassCounts result = one_of(classes, PartClasses::none);
  for (int i = 0; i < exponent; ++i) result = product(classes, result, counts);
  return result;
}

// Goes class by class and chooses how many of the `many` things are of this class.
ClassCounts multisets(const PartClasses& classes, const ClassCounts& counts, int many) {
  const auto length = static_cast<std::size_t>(many);
  std::vector<ClassCounts> ways(length + 1, no_counts(classes));
  ways[0][PartClasses::none] = 1;
  for (std::size_t c = 0; c < counts.size(); ++c) {
    if (counts[c] == 0) continue;
    for (std::size_t of_all = length; of_all > 0; --of_all) {
      for (std::size_t of_class = 1; of_class <= of_all; ++of_class) {
        const PartClass sum =
            many_times(classes, static_cast<PartClass>(c), static_cast<int>(of_class));
        add(ways[of_all], shifted(classes, ways[of_all - of_class], sum),
            multichoose(counts[c], of_class));
      }
    }
  }
  return ways[length];
}

ClassSet completed_sums(const PartClasses& classes, const ClassCounts& counts,
                        const ClassSet& wanted) {
  ClassSet set;
  for (std::size_t before = 0; before < classes.count(); ++before) {
    for (std::size_t c = 0; c < counts.size() && !set.test(before); ++c) {
      if (counts[c] == 0) continue;
      set.set(before,
              wanted.test(classes.plus(static_cast<PartClass>(before), static_cast<PartClass>(c))));
    }
  }
  return set;
}

ClassCounts of_trees(const PartClasses& classes, const ClassCounts& trees) {
  ClassCounts counts = no_counts(classes);
  for (std::size_t c = 0; c < trees.size(); ++c) {
    counts[classes.of_tree(static_cast<PartClass>(c))] += trees[c];
  }
  return counts;
}

}  // namespace reeve::search
