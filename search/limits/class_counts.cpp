#include "search/limits/class_counts.hpp"

#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

PartClass many_times(const PartClasses& classes, PartClass of, int times) {
  PartClass sum = PartClasses::none;
  for (int i = 0; i < times; ++i) sum = classes.plus(sum, of);
  return sum;
}

}  // namespace

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

// Class by class: how many of its things are among the so many.
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
