#include "search/enumerate/counting.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "search/enumerate/checked.hpp"
#include "search/enumerate/tree_grammar.hpp"

namespace reeve::search {
namespace {

struct Choices {
  std::uint64_t tips;
  std::uint64_t joins;
  std::uint64_t ends;
  std::uint64_t anchors;

  // The last finger of a tendon of several, with its end or as one.
  std::uint64_t last_fingers() const { return plus(times(tips, ends), anchors); }
};

Choices choices(const PartSet& parts) {
  return {parts.tips.size(), parts.joins.size(), times(parts.ends.size(), 1 + parts.beside.size()),
          parts.anchored ? 1U : 0U};
}

// PowerChoices has the choices of each power of a renaming of the motors; see PartPowers.
class PowerChoices {
 public:
  explicit PowerChoices(const PartPowers& powers) {
    for (const PartSet& parts : powers) choices_.push_back(choices(parts));
  }

  const Choices& at(std::size_t power) const { return choices_[power % choices_.size()]; }

 private:
  std::vector<Choices> choices_;
};

// Counts open walks of one finger, but 1x at both of its ends. `twice` has the choices of the
// renaming done twice.
std::uint64_t single_open(const Choices& c, const Choices& twice) {
  return plus(times(c.tips, unordered_pairs(c.ends, twice.ends)), times(c.anchors, c.ends));
}

// Counts walks through k > 1 fingers, from one end to the other.
std::uint64_t open_walks(const Choices& c, int k) {
  return times(power(c.last_fingers(), 2), times(power(c.joins, k - 1), power(c.tips, k - 2)));
}

std::uint64_t loop_walks(const Choices& c, int k) { return power(times(c.tips, c.joins), k); }

// A palindrome of renamed motors has what the renaming, done twice, leaves as it is, but for the
// join in its middle.
std::uint64_t open_shapes(const PowerChoices& all, std::size_t p, int k) {
  const Choices& c = all.at(p);
  const Choices& twice = all.at(2 * p);
  if (k == 1) return single_open(c, twice);
  const std::uint64_t palindromes =
      times(times(twice.last_fingers(), k % 2 == 0 ? c.joins : 1),
            times(power(twice.joins, (k - 1) / 2), power(c.tips, (k - 1) / 2)));
  return plus(open_walks(c, k), palindromes) / 2;
}

// Walks that the k reflections of a loop leave as they are. An axis passes through two opposite
// beads of the ring of k fingers and k joins.
std::uint64_t reflected_loops(const Choices& c, const Choices& twice, int k) {
  const auto uk = static_cast<std::uint64_t>(k);
  const int half = k / 2;
  const auto walks = [&](int tips, std::uint64_t joins_on_axis, int pairs_of_joins) {
    return times(power(c.tips, tips), times(joins_on_axis, power(twice.joins, pairs_of_joins)));
  };
  if (k % 2 == 1) return times(uk, walks(half + 1, c.joins, half));
  return times(uk / 2,
               plus(walks(half + 1, 1, half), walks(half, times(c.joins, c.joins), half - 1)));
}

std::uint64_t loop_shapes(const PowerChoices& all, std::size_t p, int k) {
  std::uint64_t fixed = reflected_loops(all.at(p), all.at(2 * p), k);
  for (int turn = 0; turn < k; ++turn) {
    const int cycles = std::gcd(turn, k);
    fixed = plus(fixed, loop_walks(all.at(p * static_cast<std::size_t>(k / cycles)), cycles));
  }
  return fixed / (2 * static_cast<std::uint64_t>(k));
}

std::uint64_t labelled_open(const Choices& c, int k) {
  if (k == 1) return single_open(c, c);
  const std::uint64_t walks = open_walks(c, k);
  return walks == 0 ? 0 : times(walks, factorial(k) / 2);
}

std::uint64_t labelled_loops(const Choices& c, int k) {
  if (k == 1) return times(c.tips, c.joins);
  if (k == 2) return times(power(c.tips, 2), c.joins * (c.joins + 1) / 2);
  const std::uint64_t walks = loop_walks(c, k);
  return walks == 0 ? 0 : times(walks, factorial(k - 1) / 2);
}

TendonCounts tendon_counts(const PowerChoices& all, std::size_t p, int fingers,
                           FingerIdentity identity) {
  const Choices& c = all.at(p);
  TendonCounts counts{0};
  for (int k = 1; k <= fingers; ++k) {
    counts.push_back(identity == FingerIdentity::identical
                         ? plus(open_shapes(all, p, k), loop_shapes(all, p, k))
                         : plus(labelled_open(c, k), labelled_loops(c, k)));
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
  const PowerChoices choices(powers);
  TreeGrammar grammar(powers, fingers, identity);
  std::vector<SizeTable> all;
  for (std::size_t p = 0; p < powers.size(); ++p) {
    SizeTable& trees = all.emplace_back(TreeSize{fingers, powers.front().blocks});
    const TendonCounts tendons = tendon_counts(choices, p, fingers, identity);
    for_each_size(trees.largest(), [&](TreeSize size) {
      trees[size] = size.blocks == 0 ? tendons[static_cast<std::size_t>(size.fingers)]
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
  return tendon_counts(PowerChoices({parts}), 0, fingers, identity);
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
