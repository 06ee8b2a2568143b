#include "search/enumerate/counting.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "search/enumerate/checked.hpp"
#include "search/enumerate/tendon_shapes.hpp"
#include "search/enumerate/tree_grammar.hpp"

namespace reeve::search {
namespace {

// PowerNumbers counts the things that each power of a renaming of the motors leaves (PartPowers).
class PowerNumbers {
 public:
  using Number = std::vector<std::uint64_t>;

  explicit PowerNumbers(std::size_t powers) : powers_(powers) {}

  Number count(int many) const { return Number(powers_, static_cast<std::uint64_t>(many)); }

  Number sum(Number a, const Number& b) const {
    for (std::size_t p = 0; p < powers_; ++p) a[p] = plus(a[p], b[p]);
    return a;
  }

  Number product(Number a, const Number& b) const {
    for (std::size_t p = 0; p < powers_; ++p) a[p] = times(a[p], b[p]);
    return a;
  }

  Number divided(Number a, std::uint64_t by) const {
    for (std::uint64_t& number : a) number /= by;
    return a;
  }

  // A cycle of so many equal things is left if the renaming, done as many times, leaves one.
  Number cycles(const Number& a, int length) const {
    Number result;
    for (std::size_t p = 0; p < powers_; ++p) {
      result.push_back(a[p * static_cast<std::size_t>(length) % powers_]);
    }
    return result;
  }

 private:
  std::size_t powers_;
};

BeadKinds<PowerNumbers::Number> kinds_at_powers(const PartPowers& powers) {
  BeadKinds<PowerNumbers::Number> kinds;
  for (const PartSet& parts : powers) {
    kinds.tips.push_back(parts.tips.size());
    kinds.joins.push_back(parts.joins.size());
    kinds.ends.push_back(times(parts.ends.size(), 1 + parts.beside.size()));
    kinds.anchors.push_back(parts.anchored ? 1 : 0);
  }
  return kinds;
}

std::uint64_t labelled_open(const BeadKinds<std::uint64_t>& c, int k) {
  if (k == 1) return plus(times(c.tips, c.ends * (c.ends + 1) / 2), times(c.anchors, c.ends));
  const std::uint64_t last_fingers = plus(times(c.tips, c.ends), c.anchors);
  const std::uint64_t walks =
      times(power(last_fingers, 2), times(power(c.joins, k - 1), power(c.tips, k - 2)));
  return walks == 0 ? 0 : times(walks, factorial(k) / 2);
}

std::uint64_t labelled_loops(const BeadKinds<std::uint64_t>& c, int k) {
  if (k == 1) return times(c.tips, c.joins);
  if (k == 2) return times(power(c.tips, 2), c.joins * (c.joins + 1) / 2);
  const std::uint64_t walks = power(times(c.tips, c.joins), k);
  return walks == 0 ? 0 : times(walks, factorial(k - 1) / 2);
}

// Tendons by [fingers][power]. Motors that are told apart are not renamed.
std::vector<PowerNumbers::Number> tendons(const PartPowers& powers, int fingers,
                                          FingerIdentity identity) {
  const PowerNumbers numbers(powers.size());
  const auto kinds = kinds_at_powers(powers);
  const TendonShapes shapes(numbers, kinds);
  const BeadKinds<std::uint64_t> of_all{kinds.tips[0], kinds.joins[0], kinds.ends[0],
                                        kinds.anchors[0]};
  std::vector<PowerNumbers::Number> counts{numbers.count(0)};
  for (int k = 1; k <= fingers; ++k) {
    if (identity == FingerIdentity::identical) {
      counts.push_back(numbers.sum(shapes.open(k), shapes.loops(k)));
    } else {
      counts.push_back({plus(labelled_open(of_all, k), labelled_loops(of_all, k))});
    }
  }
  return counts;
}

// A number for each size.
class SizeTable {
 public:
  explicit SizeTable(TreeSize largest)
      : largest_(largest), counts_(at({largest.fingers + 1, 0}), 0) {}

  TreeSize largest() const { return largest_; }
  std::uint64_t& operator[](TreeSize size) { return counts_[at(size)]; }
  std::uint64_t operator[](TreeSize size) const { return counts_[at(size)]; }

 private:
  std::size_t at(TreeSize size) const {
    const auto columns = static_cast<std::size_t>(largest_.blocks) + 1;
    return static_cast<std::size_t>(size.fingers) * columns + static_cast<std::size_t>(size.blocks);
  }

  TreeSize largest_;
  std::vector<std::uint64_t> counts_;
};

// Multisets, by the size of all their trees, of b_s trees of size s:
//   Σ sets(n,k) z^n y^k = Π_s Σ_m multichoose(b_s, m) (z^fingers y^blocks)^m
SizeTable multisets(const SizeTable& trees) {
  SizeTable sets(trees.largest());
  sets[{}] = 1;
  for_each_size(trees.largest(), [&](TreeSize of_tree) {
    if (trees[of_tree] == 0) return;
    SizeTable with(trees.largest());
    for_each_size(trees.largest(), [&](TreeSize size) {
      for (int many = 0; is_within(many * of_tree, size); ++many) {
        const auto of_size = multichoose(trees[of_tree], static_cast<std::uint64_t>(many));
        with[size] = plus(with[size], times(of_size, sets[size - many * of_tree]));
      }
    });
    sets = with;
  });
  return sets;
}

// Sets of trees with distinct fingers: the least finger's tree takes some of the others, and the
// rest is such a set.
SizeTable labelled_sets(const SizeTable& trees) {
  SizeTable sets(trees.largest());
  sets[{}] = 1;
  for_each_size(trees.largest(), [&](TreeSize size) {
    for_each_size(size, [&](TreeSize first) {
      if (trees[first] == 0) return;
      const auto others = choices_of(first.fingers - 1, size.fingers - 1, FingerIdentity::distinct);
      sets[size] = plus(sets[size], times(times(others, trees[first]), sets[size - first]));
    });
  });
  return sets;
}

SizeTable sets_of(const SizeTable& trees, FingerIdentity identity) {
  return identity == FingerIdentity::identical ? multisets(trees) : labelled_sets(trees);
}

// A tendon without blocks is a tree by itself.
std::vector<SizeTable> all_trees(const PartPowers& powers, int fingers, FingerIdentity identity) {
  const auto without_blocks = tendons(powers, fingers, identity);
  TreeGrammar grammar(powers, fingers, identity);
  std::vector<SizeTable> all;
  for (std::size_t p = 0; p < powers.size(); ++p) {
    SizeTable& trees = all.emplace_back(TreeSize{fingers, powers.front().blocks});
    for_each_size(trees.largest(), [&](TreeSize size) {
      trees[size] = size.blocks == 0 ? without_blocks[static_cast<std::size_t>(size.fingers)][p]
                                     : grammar.grammar().size(grammar.tree(size), p);
    });
  }
  return all;
}

// Renaming the motors again and again takes a tree round a cycle of trees. A routing that is left
// as it is has whole cycles, each as one thing of the size of all its trees.
SizeTable cycles_of_trees(const std::vector<SizeTable>& powers) {
  const TreeSize largest = powers.front().largest();
  SizeTable cycles(largest);
  std::vector<SizeTable> exact(powers.size() + 1, SizeTable(largest));  // trees, by cycle's length
  for (std::size_t length = 1; length <= powers.size(); ++length) {
    if (powers.size() % length != 0) continue;
    const int many = static_cast<int>(length);
    for_each_size(largest, [&](TreeSize size) {
      exact[length][size] = powers[length % powers.size()][size];
      for (std::size_t d = 1; d < length; ++d) {
        if (length % d == 0) exact[length][size] -= exact[d][size];
      }
      const TreeSize whole{many * size.fingers, many * size.blocks};
      if (whole.fingers > largest.fingers || whole.blocks > largest.blocks) return;
      cycles[whole] = plus(cycles[whole], exact[length][size] / length);
    });
  }
  return cycles;
}

std::uint64_t routings(const SizeTable& trees, int fingers, FingerIdentity identity) {
  const SizeTable sets = sets_of(trees, identity);
  std::uint64_t sum = 0;
  for (int blocks = 0; blocks <= trees.largest().blocks; ++blocks) {
    sum = plus(sum, sets[{fingers, blocks}]);
  }
  return sum;
}

// Counts the routings that a renaming of the motors leaves as they are.
RoutingCounts fixed_routings(const PartPowers& powers, int fingers, FingerIdentity identity) {
  const std::vector<SizeTable> all = all_trees(powers, fingers, identity);
  const SizeTable passive =
      all_trees({with_carriages(powers.front(), 0)}, fingers, identity).front();
  std::vector<SizeTable> actuated = all;
  for (SizeTable& trees : actuated) {
    for_each_size(trees.largest(), [&](TreeSize size) { trees[size] -= passive[size]; });
  }
  RoutingCounts counts{routings(cycles_of_trees(all), fingers, identity),
                       routings(cycles_of_trees(actuated), fingers, identity), 0};
  const SizeTable& single = actuated[1 % actuated.size()];
  for (int blocks = 0; blocks <= powers.front().blocks; ++blocks) {
    counts.one_tendon = plus(counts.one_tendon, single[{fingers, blocks}]);
  }
  return counts;
}

// Applies `combine` to each of the three numbers.
template <typename Combine>
RoutingCounts combined(const RoutingCounts& a, const RoutingCounts& b, Combine combine) {
  return {combine(a.all, b.all), combine(a.actuated, b.actuated),
          combine(a.one_tendon, b.one_tendon)};
}

RoutingCounts operator*(std::uint64_t many, const RoutingCounts& counts) {
  return combined(counts, counts, [&](std::uint64_t a, std::uint64_t) { return times(many, a); });
}

RoutingCounts operator+(const RoutingCounts& a, const RoutingCounts& b) {
  return combined(a, b, [](std::uint64_t x, std::uint64_t y) { return plus(x, y); });
}

RoutingCounts operator-(const RoutingCounts& a, const RoutingCounts& b) {
  return combined(a, b, [](std::uint64_t x, std::uint64_t y) { return x - y; });
}

// Renamings of the motors, by the number of carriages that each of their powers leaves as they are.
std::map<std::vector<int>, std::uint64_t> renamings(int motors) {
  std::map<std::vector<int>, std::uint64_t> many;
  std::vector<std::size_t> number(static_cast<std::size_t>(motors));
  std::iota(number.begin(), number.end(), std::size_t{0});
  const std::vector<std::size_t> as_it_was = number;
  do {
    std::vector<int> fixed;
    std::vector<std::size_t> renamed = as_it_was;
    do {
      int same = 0;
      for (std::size_t m = 0; m < number.size(); ++m) same += renamed[m] == m ? 1 : 0;
      fixed.push_back(same);
      for (std::size_t& each : renamed) each = number[each];
    } while (renamed != as_it_was);
    ++many[fixed];
  } while (std::next_permutation(number.begin(), number.end()));
  return many;
}

// Counts routings of identical motors, of which some may have nothing to pull.
RoutingCounts with_up_to(int motors, const PartSet& parts, int fingers) {
  RoutingCounts sum;
  for (const auto& [fixed, many] : renamings(motors)) {
    PartPowers powers;
    for (const int carriages : fixed) powers.push_back(with_carriages(parts, carriages));
    sum = sum + many * fixed_routings(powers, fingers, FingerIdentity::identical);
  }
  const std::uint64_t orders = factorial(motors);
  return combined(sum, sum, [&](std::uint64_t a, std::uint64_t) { return a / orders; });
}

// Counts routings of motors that are told apart, by inclusion and exclusion of those that pull
// something.
RoutingCounts with_all_of(int motors, const PartSet& parts, int fingers) {
  RoutingCounts sum[2];
  for (int used = 0; used <= motors; ++used) {
    const auto choices =
        binomial(static_cast<std::uint64_t>(motors), static_cast<std::uint64_t>(used));
    RoutingCounts& side = sum[(motors - used) % 2];
    side = side + choices * fixed_routings({with_carriages(parts, used)}, fingers,
                                           FingerIdentity::distinct);
  }
  return sum[0] - sum[1];
}

}  // namespace

TendonCounts tendon_counts(const PartSet& parts, int fingers, FingerIdentity identity) {
  TendonCounts counts;
  for (const auto& of_size : tendons({parts}, fingers, identity)) counts.push_back(of_size.front());
  return counts;
}

std::vector<std::uint64_t> tendon_sets(const TendonCounts& tendons, int largest,
                                       FingerIdentity identity) {
  const int fingers = static_cast<int>(tendons.size()) - 1;
  SizeTable trees({fingers, 0});
  for (int n = 1; n <= largest; ++n) trees[{n, 0}] = tendons[static_cast<std::size_t>(n)];
  const SizeTable sets = sets_of(trees, identity);
  std::vector<std::uint64_t> ways;
  for (int n = 0; n <= fingers; ++n) ways.push_back(sets[{n, 0}]);
  return ways;
}

RoutingCounts count_routings(const PartSet& parts, int fingers, FingerIdentity identity) {
  if (parts.motors == 1) return fixed_routings({parts}, fingers, identity);
  if (identity == FingerIdentity::distinct) return with_all_of(parts.motors, parts, fingers);
  return with_up_to(parts.motors, parts, fingers) - with_up_to(parts.motors - 1, parts, fingers);
}

}  // namespace reeve::search
