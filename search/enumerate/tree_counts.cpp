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

Kinds kinds_of(const PartSet& parts) {
  return {parts.tips.size(), parts.joins.size(), parts.ends.size(), parts.anchored ? 1U : 0U};
}

class Counter {
 public:
  Counter(const PartSet& parts, int fingers, FingerIdentity identity)
      : parts_(parts),
        kinds_(kinds_of(parts)),
        identity_(identity),
        fingers_(fingers),
        counts_{table(), table(), std::vector(static_cast<std::size_t>(fingers), table()),
                table()} {}

  // Halves with k blocks hold branches with k blocks, and those halves with fewer.
  TreeCounts count() {
    for (int k = 0; k <= parts_.blocks; ++k) {
      for (int n = 1; k > 0 && n <= fingers_; ++n) counts_.branches[{n, k}] = branches({n, k});
      for (int n = 0; n <= fingers_; ++n) counts_.halves[{n, k}] = halves({n, k});
      for (int n = 1; k > 0 && n <= fingers_; ++n) counts_.trees[{n, k}] = trees({n, k});
    }
    return counts_;
  }

 private:
  SizeTable table() const { return SizeTable({fingers_, parts_.blocks}); }

  std::uint64_t arranged(int m, int of) const {
    return times(choices_of(m, of, identity_), orders_of(m, identity_));
  }

  std::uint64_t halves(TreeSize size) const {
    const auto [n, k] = size;
    if (k == 0) {
      return n == 0 ? kinds_.ends : times(arranged(n, n), one_sided_strings(parts_, n));
    }
    std::uint64_t sum = counts_.branches[size];
    for (int m = 1; m < n; ++m) {
      sum =
          plus(sum, times(times(arranged(m, n), strings(parts_, m)), counts_.branches[{n - m, k}]));
    }
    return sum;
  }

  std::uint64_t branches(TreeSize size) const {
    const std::uint64_t sum = all_pairs(counts_.halves, 1, size - TreeSize{0, 1});
    return size.blocks == 1 ? plus(sum, loops_through_pass(parts_, size.fingers, identity_)) : sum;
  }

  std::uint64_t trees(TreeSize size) {
    const auto [n, k] = size;
    std::uint64_t sum = may_hang_on_motor(parts_) ? counts_.branches[size] : 0;
    for (int m = 1; m < n; ++m) {
      const TreeSize below{n - m, k};
      sum = plus(
          sum, times(times(arranged(m, n), one_sided_strings(parts_, m)), counts_.branches[below]));
      std::uint64_t& two_tailed = counts_.two_tailed[static_cast<std::size_t>(m)][below];
      two_tailed = count_two_tailed(m, below);
      sum = plus(sum, two_tailed);
    }
    return sum;
  }

  std::uint64_t count_two_tailed(int m, TreeSize below) const {
    const MirroredString string = mirrored(parts_, m, identity_);
    return times(times(choices_of(m, below.fingers + m, identity_), string.middles),
                 all_pairs(counts_.branches, string.halves, below));
  }

  std::uint64_t all_pairs(const SizeTable& table, std::uint64_t variants, TreeSize size) const {
    std::uint64_t sum = 0;
    SizePair split{{}, size};
    do {
      sum = plus(sum, pairs(table, variants, split, identity_));
    } while (next_pair(split));
    return sum;
  }

  const PartSet& parts_;
  Kinds kinds_;
  FingerIdentity identity_;
  int fingers_;
  TreeCounts counts_;
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

bool may_hang_on_motor(const PartSet& parts) {
  return std::find(parts.ends.begin(), parts.ends.end(), TokenKind::motor_end) != parts.ends.end();
}

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

std::uint64_t pairs(const SizeTable& table, std::uint64_t variants, const SizePair& split,
                    FingerIdentity identity) {
  const auto [first, second] = split;
  const std::uint64_t firsts = times(variants, table[first]);
  const std::uint64_t seconds = times(variants, table[second]);
  if (identity == FingerIdentity::distinct) {
    if (first.fingers == 0) return 0;
    const std::uint64_t others =
        choices_of(first.fingers - 1, first.fingers + second.fingers - 1, identity);
    return times(others, times(firsts, seconds));
  }
  if (first == second) return multichoose(firsts, 2);
  const bool lesser = first.fingers != second.fingers ? first.fingers < second.fingers
                                                      : first.blocks < second.blocks;
  return lesser ? times(firsts, seconds) : 0;
}

TreeCounts tree_counts(const PartSet& parts, int fingers, FingerIdentity identity) {
  return Counter(parts, fingers, identity).count();
}

}  // namespace reeve::search
