#include "search/enumerate/counting.hpp"

#include <algorithm>
#include <numeric>

#include "search/enumerate/checked.hpp"
#include "search/enumerate/tree_sets.hpp"

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

// Of one finger, and not 1x at both of its ends.
std::uint64_t single_open(const Choices& c) {
  return plus(times(c.tips, c.ends * (c.ends + 1) / 2), times(c.anchors, c.ends));
}

// Of k > 1 fingers, from one end to the other.
std::uint64_t open_walks(const Choices& c, int k) {
  return times(power(c.last_fingers(), 2), times(power(c.joins, k - 1), power(c.tips, k - 2)));
}

std::uint64_t loop_walks(const Choices& c, int k) { return power(times(c.tips, c.joins), k); }

std::uint64_t open_shapes(const Choices& c, int k) {
  if (k == 1) return single_open(c);
  const std::uint64_t palindromes =
      times(c.last_fingers(), times(power(c.joins, k / 2), power(c.tips, (k - 1) / 2)));
  return plus(open_walks(c, k), palindromes) / 2;
}

// Walks that the k reflections of a loop leave as they are. An axis passes through two opposite
// beads of the ring of k fingers and k joins.
std::uint64_t reflected_loops(const Choices& c, int k) {
  const auto uk = static_cast<std::uint64_t>(k);
  const int half = k / 2;
  if (k % 2 == 1) return times(uk, times(power(c.tips, half + 1), power(c.joins, half + 1)));
  const std::uint64_t through_fingers = times(power(c.tips, half + 1), power(c.joins, half));
  const std::uint64_t through_joins = times(power(c.tips, half), power(c.joins, half + 1));
  return times(uk / 2, plus(through_fingers, through_joins));
}

std::uint64_t loop_shapes(const Choices& c, int k) {
  std::uint64_t fixed = reflected_loops(c, k);
  for (int turn = 0; turn < k; ++turn) {
    fixed = plus(fixed, loop_walks(c, std::gcd(turn, k)));
  }
  return fixed / (2 * static_cast<std::uint64_t>(k));
}

std::uint64_t labelled_open(const Choices& c, int k) {
  if (k == 1) return single_open(c);
  const std::uint64_t walks = open_walks(c, k);
  return walks == 0 ? 0 : times(walks, factorial(k) / 2);
}

std::uint64_t labelled_loops(const Choices& c, int k) {
  if (k == 1) return times(c.tips, c.joins);
  if (k == 2) return times(power(c.tips, 2), c.joins * (c.joins + 1) / 2);
  const std::uint64_t walks = loop_walks(c, k);
  return walks == 0 ? 0 : times(walks, factorial(k - 1) / 2);
}

// ways[r] counts the multisets of the sizes seen so far.
std::vector<std::uint64_t> multisets(const TendonCounts& tendons, int largest) {
  const std::size_t fingers = tendons.size() - 1;
  std::vector<std::uint64_t> ways(fingers + 1, 0);
  ways[0] = 1;
  for (std::size_t size = 1; size <= static_cast<std::size_t>(largest); ++size) {
    for (std::size_t r = fingers; r >= size; --r) {
      for (std::size_t many = 1; many * size <= r; ++many) {
        const std::uint64_t choices = multichoose(tendons[size], many);
        ways[r] = plus(ways[r], times(choices, ways[r - many * size]));
      }
    }
  }
  return ways;
}

// The tendon of the first finger takes k - 1 of the others; the rest is counted the same way.
std::vector<std::uint64_t> labelled_sets(const TendonCounts& tendons, int largest) {
  std::vector<std::uint64_t> ways{1};
  for (std::size_t n = 1; n < tendons.size(); ++n) {
    std::uint64_t sum = 0;
    for (std::size_t k = 1; k <= std::min(n, static_cast<std::size_t>(largest)); ++k) {
      sum = plus(sum, times(times(binomial(n - 1, k - 1), tendons[k]), ways[n - k]));
    }
    ways.push_back(sum);
  }
  return ways;
}

// A tendon without blocks is a tree by itself.
SizeTable all_trees(const PartSet& parts, int fingers, FingerIdentity identity) {
  SizeTable all = tree_counts(parts, fingers, identity).trees;
  const TendonCounts tendons = tendon_counts(parts, fingers, identity);
  for (int n = 1; n <= fingers; ++n) all[{n, 0}] = tendons[static_cast<std::size_t>(n)];
  return all;
}

std::uint64_t routings(const SizeTable& trees, int fingers, FingerIdentity identity) {
  const TreeSets sets(trees, identity);
  std::uint64_t sum = 0;
  for (int blocks = 0; blocks <= trees.largest().blocks; ++blocks) {
    sum = plus(sum, sets.count({fingers, blocks}));
  }
  return sum;
}

}  // namespace

TendonCounts tendon_counts(const PartSet& parts, int fingers, FingerIdentity identity) {
  const Choices c{parts.tips.size(), parts.joins.size(), parts.ends.size(),
                  parts.anchored ? 1U : 0U};
  TendonCounts counts{0};
  for (int k = 1; k <= fingers; ++k) {
    counts.push_back(identity == FingerIdentity::identical
                         ? plus(open_shapes(c, k), loop_shapes(c, k))
                         : plus(labelled_open(c, k), labelled_loops(c, k)));
  }
  return counts;
}

std::vector<std::uint64_t> tendon_sets(const TendonCounts& tendons, int largest,
                                       FingerIdentity identity) {
  return identity == FingerIdentity::identical ? multisets(tendons, largest)
                                               : labelled_sets(tendons, largest);
}

RoutingCounts count_routings(const PartSet& parts, int fingers, FingerIdentity identity) {
  const SizeTable all = all_trees(parts, fingers, identity);
  const SizeTable passive = all_trees(passive_parts(parts), fingers, identity);
  SizeTable actuated(all.largest());
  for_each_size(all.largest(), [&](TreeSize size) { actuated[size] = all[size] - passive[size]; });
  RoutingCounts counts{routings(all, fingers, identity), routings(actuated, fingers, identity), 0};
  for (int blocks = 0; blocks <= parts.blocks; ++blocks) {
    counts.one_tendon = plus(counts.one_tendon, actuated[{fingers, blocks}]);
  }
  return counts;
}

}  // namespace reeve::search
