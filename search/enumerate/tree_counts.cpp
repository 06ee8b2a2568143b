#include "search/enumerate/tree_counts.hpp"

#include <algorithm>

#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

struct Kinds {
  std::uint64_t tips;
  std::uint64_t joins;
  std::uint64_t ends;
  std::uint64_t anchors;
};

std::uint64_t motor_ends(const PartSet& parts) {
  return static_cast<std::uint64_t>(
      std::count(parts.ends.begin(), parts.ends.end(), TokenKind::motor_end));
}

Kinds kinds_of(const PartSet& parts) {
  return {parts.tips.size(), parts.joins.size(), times(parts.ends.size(), end_variants(parts)),
          parts.anchored ? 1U : 0U};
}

// Roots without a finger that hang by one end.
std::uint64_t hanging_ends(const PartSet& parts) {
  std::uint64_t sum = motor_ends(parts);
  for (const TokenKind end : parts.ends) {
    for (const TokenKind beside : parts.beside) sum += may_hang(end, beside) ? 1 : 0;
  }
  return sum;
}

std::size_t index_of(int passes) { return static_cast<std::size_t>(passes); }

class Counter {
 public:
  Counter(const PartPowers& powers, int fingers, FingerIdentity identity)
      : powers_(powers), identity_(identity), fingers_(fingers), blocks_(powers.front().blocks) {
    const SizeTable table({fingers, blocks_});
    const std::vector<SizeTable> by_fingers(static_cast<std::size_t>(fingers), table);
    const std::vector<SizeTable> by_passes(static_cast<std::size_t>(blocks_) + 1, table);
    counts_.assign(powers.size(), {table, table, table, table, by_fingers, by_fingers, table,
                                   by_passes, by_passes, table});
  }

  // Halves with k blocks hold branches with k blocks, and those halves with fewer.
  std::vector<TreeCounts> count() {
    for (int k = 0; k <= blocks_; ++k) {
      for_each_power(k > 0 ? 1 : fingers_ + 1, k,
                     [&](std::size_t p, TreeSize size) { count_branches(p, size); });
      for_each_power(0, k, [&](std::size_t p, TreeSize size) {
        counts_[p].halves[size] = halves(p, size);
        counts_[p].sides[size] = plus(counts_[p].halves[size], to_becket(p, size));
      });
      if (powers_.front().series) count_arms(k);
      for_each_power(k > 0 ? 1 : fingers_ + 1, k, [&](std::size_t p, TreeSize size) {
        counts_[p].trees[size] = trees(p, size);
      });
    }
    return counts_;
  }

 private:
  template <typename Visit>
  void for_each_power(int from_fingers, int blocks, Visit visit) const {
    for (int n = from_fingers; n <= fingers_; ++n) {
      for (std::size_t p = 0; p < powers_.size(); ++p) visit(p, TreeSize{n, blocks});
    }
  }

  std::size_t twice(std::size_t p) const { return 2 * p % powers_.size(); }

  std::uint64_t arranged(int m, int of) const {
    return times(choices_of(m, of, identity_), orders_of(m, identity_));
  }

  std::uint64_t halves(std::size_t p, TreeSize size) const {
    const auto [n, k] = size;
    const SizeTable& branches = counts_[p].branches;
    if (k == 0) {
      return n == 0 ? kinds_of(powers_[p]).ends
                    : times(arranged(n, n), one_sided_strings(powers_[p], n));
    }
    std::uint64_t sum = branches[size];
    for (int m = 1; m < n; ++m) {
      sum = plus(sum, times(times(arranged(m, n), strings(powers_[p], m)), branches[{n - m, k}]));
    }
    return times(end_variants(powers_[p]), sum);
  }

  std::uint64_t to_becket(std::size_t p, TreeSize size) const {
    const auto [n, k] = size;
    if (!powers_[p].beckets || k > 0 || n == 0) return 0;
    return times(arranged(n, n), strings(powers_[p], n));
  }

  void count_branches(std::size_t p, TreeSize size) {
    TreeCounts& counts = counts_[p];
    const TreeCounts& mirror = counts_[twice(p)];
    const TreeSize beyond = size - TreeSize{0, 1};
    const std::uint64_t of_loops = size.blocks == 1 ? loops(p, size.fingers) : 0;
    counts.pulleys[size] =
        plus(of_loops, all_pairs({counts.sides}, {mirror.sides}, beyond, identity_));
    for (int m = 1; powers_[p].double_passes && m < size.fingers; ++m) {
      const TreeSize of_sides = beyond - TreeSize{m, 0};
      std::uint64_t& twice_passed = counts.double_passes[index_of(m)][of_sides];
      twice_passed =
          about_string(m, mirrored(powers_[p], m, identity_), counts.sides,
                       mirrored(powers_[twice(p)], m, identity_), mirror.sides, of_sides);
      counts.pulleys[size] = plus(counts.pulleys[size], twice_passed);
    }
    counts.branches[size] = counts.pulleys[size];
    if (!powers_[p].bars) return;
    const std::uint64_t of_bars = all_pairs({counts.halves}, {mirror.halves}, beyond, identity_);
    counts.branches[size] = plus(counts.pulleys[size], plus(of_loops, of_bars));
  }

  // Counts pairs from the table about a string of m fingers. What a renaming, done twice, leaves is
  // in the mirror.
  std::uint64_t about_string(int m, const MirroredString& string, const SizeTable& table,
                             const MirroredString& mirror, const SizeTable& in_mirror,
                             TreeSize size) const {
    return times(times(choices_of(m, size.fingers + m, identity_), string.middles),
                 all_pairs({table, string.halves}, {in_mirror, mirror.halves}, size, identity_));
  }

  // Through a pass.
  std::uint64_t loops(std::size_t p, int m) const {
    if (identity_ == FingerIdentity::distinct) {
      return loops_through_pass(powers_[p], m, identity_);
    }
    const MirroredString string = mirrored(powers_[p], m, identity_);
    return times(string.middles,
                 unordered_pairs(string.halves, mirrored(powers_[twice(p)], m, identity_).halves));
  }

  void count_arms(int blocks) {
    for_each_power(0, blocks, [&](std::size_t p, TreeSize size) {
      TreeCounts& counts = counts_[p];
      counts.arms[0][size] = counts.halves[size];
      if (size.fingers == 0) return;
      counts.risers[size] = counts.halves[size] - (powers_[p].linked ? 0 : counts.branches[size]);
      for (int passes = 1; passes <= blocks; ++passes) {
        const SizeTable& shorter = counts.arms[index_of(passes - 1)];
        const std::uint64_t beads = beads_before(powers_[p], passes - 1);
        counts.arms[index_of(passes)][size] =
            beside_risers(p, size, [&](TreeSize rest) { return times(beads, shorter[rest]); });
      }
    });
  }

  // Counts a pass with its riser and the others, which are so many of each size.
  template <typename Others>
  std::uint64_t beside_risers(std::size_t p, TreeSize size, Others others) const {
    std::uint64_t sum = 0;
    SizePair split{{}, size - TreeSize{0, 1}};
    do {
      sum = plus(sum, with_riser(counts_[p], split, others(split.second), identity_));
    } while (next_pair(split));
    return sum;
  }

  std::uint64_t in_series(std::size_t p, int passes, TreeSize size) const {
    const std::size_t on_a_side = index_of(passes / 2);
    const auto pairs_with = [&](bool beads, TreeSize of) {
      const auto side = [&](std::size_t power) {
        return PairSide{counts_[power].arms[on_a_side],
                        beads ? beads_before(powers_[power], passes / 2) : 1};
      };
      return all_pairs(side(p), side(twice(p)), of, identity_);
    };
    if (passes % 2 == 0) return times(beads_before(powers_[p], passes), pairs_with(false, size));
    return beside_risers(p, size, [&](TreeSize rest) { return pairs_with(true, rest); });
  }

  std::uint64_t trees(std::size_t p, TreeSize size) {
    const auto [n, k] = size;
    TreeCounts& counts = counts_[p];
    std::uint64_t sum = times(hanging_ends(powers_[p]), counts.branches[size]);
    for (int m = 0; m < n; ++m) {
      const TreeSize below{n - m, k};
      const std::uint64_t on_one_tail =
          times(times(arranged(m, n), end_variants(powers_[p])), one_sided_strings(powers_[p], m));
      if (m > 0) sum = plus(sum, times(on_one_tail, counts.branches[below]));
      std::uint64_t& two_tailed = counts.two_tailed[static_cast<std::size_t>(m)][below];
      two_tailed = count_two_tailed(p, m, below);
      sum = plus(sum, two_tailed);
    }
    for (int passes = 2; powers_[p].series && passes <= k; ++passes) {
      std::uint64_t& roots = counts.in_series[index_of(passes)][size];
      roots = in_series(p, passes, size);
      sum = plus(sum, roots);
    }
    return sum;
  }

  std::uint64_t count_two_tailed(std::size_t p, int m, TreeSize below) const {
    const MirroredString string = between_tails(powers_[p], m, identity_);
    if (string.middles == 0) return 0;
    return about_string(m, string, counts_[p].branches,
                        between_tails(powers_[twice(p)], m, identity_), counts_[twice(p)].branches,
                        below);
  }

  const PartPowers& powers_;
  FingerIdentity identity_;
  int fingers_;
  int blocks_;
  std::vector<TreeCounts> counts_;
};

}  // namespace

std::uint64_t choices_of(int fingers, int of, FingerIdentity identity) {
  return identity == FingerIdentity::identical
             ? 1
             : binomial(static_cast<std::uint64_t>(of), static_cast<std::uint64_t>(fingers));
}

std::uint64_t orders_of(int fingers, FingerIdentity identity) {
  return identity == FingerIdentity::identical ? 1 : factorial(fingers);
}

std::uint64_t strings(const PartSet& parts, int m) {
  return times(power(parts.tips.size(), m), power(parts.joins.size(), m - 1));
}

std::uint64_t one_sided_strings(const PartSet& parts, int m) {
  const Kinds c = kinds_of(parts);
  return times(plus(times(c.tips, c.ends), c.anchors), power(times(c.tips, c.joins), m - 1));
}

MirroredString mirrored(const PartSet& parts, int m, FingerIdentity identity) {
  const Kinds c = kinds_of(parts);
  if (identity == FingerIdentity::distinct) {
    return {times(orders_of(m, identity), strings(parts, m)), 1};
  }
  return {m % 2 == 1 ? c.tips : c.joins, times(power(c.tips, m / 2), power(c.joins, (m - 1) / 2))};
}

std::uint64_t loops_through_pass(const PartSet& parts, int m, FingerIdentity identity) {
  if (identity == FingerIdentity::distinct) {
    return times(m == 1 ? 1 : factorial(m) / 2, strings(parts, m));
  }
  const MirroredString string = mirrored(parts, m, identity);
  return times(string.middles, multichoose(string.halves, 2));
}

MirroredString between_tails(const PartSet& parts, int m, FingerIdentity identity) {
  if (m == 0) return {parts.beside.size() + (parts.linked ? 1 : 0), 1};
  MirroredString string = mirrored(parts, m, identity);
  string.halves = times(string.halves, end_variants(parts));
  return string;
}

bool may_hang(TokenKind end, TokenKind beside) {
  return is_on_carriage(end) || is_on_carriage(beside);
}

bool may_hang_on_motor(const PartSet& parts) { return motor_ends(parts) > 0; }

std::uint64_t PairSide::count(TreeSize size) const { return times(variants, table[size]); }

bool next_pair(SizePair& split) {
  const TreeSize size{split.first.fingers + split.second.fingers,
                      split.first.blocks + split.second.blocks};
  if (split.first.blocks < size.blocks) {
    ++split.first.blocks;
  } else {
    if (split.first.fingers == size.fingers) return false;
    split.first = {split.first.fingers + 1, 0};
  }
  split.second = size - split.first;
  return true;
}

std::uint64_t pairs(const PairSide& side, const PairSide& twice, const SizePair& split,
                    FingerIdentity identity) {
  const auto [first, second] = split;
  if (identity == FingerIdentity::distinct) {
    if (first.fingers == 0) return 0;
    const std::uint64_t others =
        choices_of(first.fingers - 1, first.fingers + second.fingers - 1, identity);
    return times(others, times(side.count(first), side.count(second)));
  }
  if (first == second) return unordered_pairs(side.count(first), twice.count(first));
  const bool lesser = first.fingers != second.fingers ? first.fingers < second.fingers
                                                      : first.blocks < second.blocks;
  return lesser ? times(side.count(first), side.count(second)) : 0;
}

std::uint64_t all_pairs(const PairSide& side, const PairSide& twice, TreeSize size,
                        FingerIdentity identity) {
  std::uint64_t sum = 0;
  SizePair split{{}, size};
  do {
    sum = plus(sum, pairs(side, twice, split, identity));
  } while (next_pair(split));
  return sum;
}

std::uint64_t with_riser(const TreeCounts& counts, const SizePair& split, std::uint64_t others,
                         FingerIdentity identity) {
  const auto [riser, rest] = split;
  return times(choices_of(riser.fingers, riser.fingers + rest.fingers, identity),
               times(counts.risers[riser], others));
}

std::vector<TreeCounts> tree_counts(const PartPowers& powers, int fingers,
                                    FingerIdentity identity) {
  return Counter(powers, fingers, identity).count();
}

}  // namespace reeve::search
