#include "search/limits/class_counts.hpp"

#include "search/enumerate/checked.hpp"
#include "search/enumerate/tendon_shapes.hpp"

namespace reeve::search {
namespace {

PartClass many_times(const PartClasses& classes, PartClass of, int times) {
  PartClass sum = PartClasses::none;
  for (int i = 0; i < times; ++i) sum = classes.plus(sum, of);
  return sum;
}

// The number of things of each class, as TendonShapes asks for it.
struct ClassNumbers {
  using Number = ClassCounts;

  const PartClasses& classes;

  Number count(int many) const {
    Number counts = no_counts(classes);
    counts[PartClasses::none] = static_cast<std::uint64_t>(many);
    return counts;
  }
  Number sum(Number a, const Number& b) const {
    add(a, b);
    return a;
  }
  Number product(const Number& a, const Number& b) const { return search::product(classes, a, b); }
  Number divided(Number a, std::uint64_t by) const {
    for (std::uint64_t& number : a) number /= by;
    return a;
  }
  // Counts the same thing taken `length` times.
  Number cycles(const Number& a, int length) const {
    Number moved = no_counts(classes);
    for (std::size_t c = 0; c < a.size(); ++c) {
      std::uint64_t& sum = moved[many_times(classes, static_cast<PartClass>(c), length)];
      sum = plus(sum, a[c]);
    }
    return moved;
  }
};

BeadKinds<ClassCounts> kinds_by_class(const PartClasses& classes, const PartSet& parts) {
  const auto kinds = [&](const std::vector<TokenKind>& of) {
    ClassCounts counts = no_counts(classes);
    for (const TokenKind kind : of) ++counts[classes.of(plain(kind))];
    return counts;
  };
  ClassCounts beside = kinds(parts.beside);
  ++beside[PartClasses::none];  // an end alone
  BeadKinds<ClassCounts> beads{no_counts(classes), kinds(parts.joins),
                               product(classes, kinds(parts.ends), beside), no_counts(classes)};
  for (const TipKind tip : parts.tips) ++beads.tips[classes.of(finger(0, tip))];
  if (parts.anchored) ++beads.anchors[classes.of(anchored_tip(0))];
  return beads;
}

}  // namespace

std::vector<ClassCounts> shape_counts(const PartClasses& classes, const PartSet& parts,
                                      int fingers) {
  const TendonShapes shapes(ClassNumbers{classes}, kinds_by_class(classes, parts));
  std::vector<ClassCounts> counts{no_counts(classes)};
  for (int k = 1; k <= fingers; ++k) {
    counts.push_back(shapes.open(k));
    add(counts.back(), shifted(classes, shapes.loops(k), classes.of_loop()));
  }
  return counts;
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

void add(ClassCounts& to, const ClassCounts& counts, std::uint64_t many) {
  for (std::size_t c = 0; c < to.size(); ++c) to[c] = plus(to[c], times(many, counts[c]));
}

void subtract(ClassCounts& from, const ClassCounts& counts) {
  for (std::size_t c = 0; c < from.size(); ++c) from[c] -= counts[c];
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
