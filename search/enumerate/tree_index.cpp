#include "search/enumerate/tree_index.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace reeve::search {
namespace {

void clear(SplitTendon& tendon) {
  for (HalfTendon* half : {&tendon.left, &tendon.right}) {
    half->tokens.clear();
    half->tail.reset();
  }
  tendon.middle.clear();
  tendon.closed = false;
  tendon.risers.clear();
}

}  // namespace

FingerSet fingers_up_to(int fingers, FingerIdentity identity) {
  if (identity == FingerIdentity::identical || fingers == 0) return 0;
  return ~FingerSet{0} >> (64 - fingers);
}

// Finger by finger from the greatest: those sets first that are without it.
FingerSet take_some(FingerSet& set, int many, Digits& digits, FingerIdentity identity) {
  if (identity == FingerIdentity::identical) return 0;
  auto wanted = static_cast<std::uint64_t>(many);
  auto left = static_cast<std::uint64_t>(std::popcount(set));
  std::uint64_t rank = digits.take(binomial(left, wanted));
  FingerSet taken = 0;
  for (FingerSet open = set; wanted > 0; --left) {
    const FingerSet finger = std::bit_floor(open);
    open ^= finger;
    const std::uint64_t without = binomial(left - 1, wanted);
    if (rank < without) continue;
    rank -= without;
    taken |= finger;
    --wanted;
  }
  set ^= taken;
  return taken;
}

FingerSet take_least_and(FingerSet& set, int many, Digits& digits, FingerIdentity identity) {
  const FingerSet least = set & (~set + 1);
  set ^= least;
  return least | take_some(set, many, digits, identity);
}

int take_one(FingerSet& set, Digits& digits, FingerIdentity identity) {
  if (identity == FingerIdentity::identical) return 0;
  FingerSet open = set;
  for (auto skip = digits.take(static_cast<std::uint64_t>(std::popcount(set))); skip > 0; --skip) {
    open &= open - 1;
  }
  const int bit = std::countr_zero(open);
  set ^= FingerSet{1} << bit;
  return bit + 1;
}

void TreeDecoder::append_join(Digits& digits, Walk& walk) const {
  walk.push_back(plain(parts_.joins[digits.take(parts_.joins.size())]));
}

void TreeDecoder::append_finger(FingerSet& fingers, Digits& digits, Walk& walk) const {
  const TipKind tip = parts_.tips[digits.take(parts_.tips.size())];
  walk.push_back(finger(fingers == 0 ? 0 : take_one(fingers, digits, identity_), tip));
}

void TreeDecoder::append_string(int m, FingerSet& fingers, Digits& digits, Walk& walk) const {
  for (int i = 0; i < m; ++i) {
    if (i > 0) append_join(digits, walk);
    append_finger(fingers, digits, walk);
  }
}

// Through m fingers, the last of which is an anchored tip or has an end behind it.
void TreeDecoder::append_to_end(int m, FingerSet& fingers, Digits& digits, Walk& walk) const {
  append_string(m - 1, fingers, digits, walk);
  if (m > 1) append_join(digits, walk);
  const std::uint64_t anchors = parts_.anchored ? 1 : 0;
  const std::uint64_t ends = parts_.ends.size();
  const std::uint64_t with_end = parts_.tips.size() * ends;
  const std::uint64_t kind = digits.take(anchors + with_end * end_variants(parts_));
  const int number = take_one(fingers, digits, identity_);
  if (kind < anchors) {
    walk.push_back(anchored_tip(number));
  } else {
    const std::uint64_t tip = (kind - anchors) % with_end / ends;
    walk.push_back(finger(number, parts_.tips[tip]));
    append_beside((kind - anchors) / with_end, walk);
    walk.push_back(plain(parts_.ends[(kind - anchors) % ends]));
  }
}

void TreeDecoder::append_beside(std::uint64_t variant, Walk& walk) const {
  if (variant > 0) walk.push_back(plain(parts_.beside[variant - 1]));
}

void TreeDecoder::append_middle(int m, std::uint64_t middles, FingerSet& fingers, Digits& digits,
                                Walk& walk) const {
  FingerSet own = take_some(fingers, m, digits, identity_);
  if (identity_ == FingerIdentity::distinct) return append_string(m, own, digits, walk);
  const std::uint64_t kind = digits.take(middles);
  walk.push_back(m % 2 == 1 ? finger(0, parts_.tips[kind]) : plain(parts_.joins[kind]));
}

// Half of a string of m fingers, from the bead beside its middle to its end.
void TreeDecoder::append_mirrored(int m, std::uint64_t index, Walk& walk) const {
  Digits digits(index);
  FingerSet none = 0;
  for (int bead = m - 2; bead >= 0; --bead) {
    if (bead % 2 == 0) {
      append_finger(none, digits, walk);
    } else {
      append_join(digits, walk);
    }
  }
}

std::uint64_t TreeDecoder::tailed_halves(int m, TreeSize size) const {
  const std::uint64_t arranged =
      choices_of(m, size.fingers, identity_) * orders_of(m, identity_) * strings(parts_, m);
  return arranged * counts_.branches[size - TreeSize{m, 0}];
}

void TreeDecoder::decode_half(const TreeIndex& half, HalfTendon& tendon) const {
  const TreeSize size = half.size;
  Digits digits(half.index);
  FingerSet fingers = half.fingers;
  if (size == TreeSize{}) {
    const std::uint64_t end = digits.take(parts_.ends.size());
    append_beside(digits.rest(), tendon.tokens);
    tendon.tokens.push_back(plain(parts_.ends[end]));
    return;
  }
  if (size.blocks == 0) {
    append_to_end(size.fingers, fingers, digits, tendon.tokens);
    return;
  }
  const std::uint64_t variant = digits.take(end_variants(parts_));
  if (digits.is_among(counts_.branches[size])) {
    append_beside(variant, tendon.tokens);
    tendon.tail = TreeIndex{size, digits.rest(), fingers};
    return;
  }
  int m = 1;
  while (!digits.is_among(tailed_halves(m, size))) ++m;
  FingerSet own = take_some(fingers, m, digits, identity_);
  append_string(m, own, digits, tendon.tokens);
  append_beside(variant, tendon.tokens);
  tendon.tail = TreeIndex{size - TreeSize{m, 0}, digits.rest(), fingers};
}

void TreeDecoder::decode_side(const TreeIndex& side, HalfTendon& tendon) const {
  Digits digits(side.index);
  if (digits.is_among(counts_.halves[side.size])) return decode_half(side, tendon);
  FingerSet fingers = side.fingers;
  append_string(side.size.fingers, fingers, digits, tendon.tokens);
  tendon.tokens.push_back(block(TokenKind::becket, 0));
}

TreeDecoder::Pair TreeDecoder::decode_pair(const SizeTable& table, std::uint64_t variants,
                                           TreeSize size, FingerSet fingers, Digits& digits) const {
  SizePair split{{}, size};
  while (!digits.is_among(pairs({table, variants}, split, identity_))) next_pair(split);
  const std::uint64_t firsts = variants * table[split.first];
  if (identity_ == FingerIdentity::identical && split.first == split.second) {
    std::uint64_t lesser = digits.rest();
    const std::uint64_t greater = greatest_of_multiset(firsts, 2, lesser);
    return {{split.first, lesser}, {split.second, greater}};
  }
  FingerSet others = fingers;
  const FingerSet own = identity_ == FingerIdentity::identical
                            ? 0
                            : take_least_and(others, split.first.fingers - 1, digits, identity_);
  const std::uint64_t first = digits.take(firsts);
  return {{split.first, first, own}, {split.second, digits.rest(), others}};
}

// About the bead in its middle; with distinct fingers the first number is less than the last.
void TreeDecoder::append_loop(int m, FingerSet fingers, Digits& digits, Walk& walk) const {
  if (identity_ == FingerIdentity::identical) {
    const MirroredString string = mirrored(parts_, m, identity_);
    Walk half;
    Walk middle;
    append_middle(m, string.middles, fingers, digits, middle);
    std::uint64_t other = digits.rest();
    append_mirrored(m, greatest_of_multiset(string.halves, 2, other), half);
    walk.insert(walk.end(), half.rbegin(), half.rend());
    walk.insert(walk.end(), middle.begin(), middle.end());
    append_mirrored(m, other, walk);
    return;
  }
  const std::size_t begin = walk.size();
  FingerSet none = 0;
  for (int i = 0; i < m; ++i) {
    if (i > 0) append_join(digits, walk);
    append_finger(none, digits, walk);
  }
  for (int i = 1; i + 1 < m; ++i) {
    const int number = take_one(fingers, digits, identity_);
    walk[begin + 2 * static_cast<std::size_t>(i)].finger = static_cast<std::uint8_t>(number);
  }
  walk.back().finger = static_cast<std::uint8_t>(std::bit_width(fingers));
  walk[begin].finger = static_cast<std::uint8_t>(std::countr_zero(fingers) + 1);
}

bool TreeDecoder::is_bar(const TreeIndex& branch) const {
  return branch.index >= counts_.pulleys[branch.size];
}

Token TreeDecoder::tail_of(const TreeIndex& branch) const {
  return block(is_bar(branch) ? TokenKind::bar_pivot : TokenKind::block_tail, 0);
}

// A side that passes the block once more pulls it by two more strands, and by one if it ends there.
int TreeDecoder::sides_below(const HalfTendon& half) const {
  const auto many = [&](TokenKind kind) {
    return static_cast<int>(std::count_if(half.tokens.begin(), half.tokens.end(),
                                          [&](const Token& token) { return token.kind == kind; }));
  };
  const int strands = 1 + many(TokenKind::block_pass);
  return half.tail ? strands * sides_below(*half.tail) : strands + many(TokenKind::becket);
}

int TreeDecoder::sides_below(const TreeIndex& branch) const {
  SplitTendon sides;
  decode_passing(branch, sides);
  return sides_below(sides.left) + sides_below(sides.right);
}

ArmRatio TreeDecoder::arms_between(const SplitTendon& sides) const {
  const int left = sides_below(sides.left);
  const int right = sides_below(sides.right);
  const int common = std::gcd(left, right);
  return {static_cast<std::uint16_t>(left / common), static_cast<std::uint16_t>(right / common)};
}

void TreeDecoder::decode_branch(const TreeIndex& branch, SplitTendon& tendon) const {
  decode_passing(branch, tendon);
  if (is_bar(branch)) tendon.middle.front() = bar(0, arms_between(tendon));
}

void TreeDecoder::decode_passing(const TreeIndex& branch, SplitTendon& tendon) const {
  clear(tendon);
  Digits digits(branch.index);
  const bool is_pulley = digits.is_among(counts_.pulleys[branch.size]);
  const int n = branch.size.fingers;
  const TreeSize beyond = branch.size - TreeSize{0, 1};
  if (is_pulley && parts_.double_passes) {
    for (int m = 1; m < n; ++m) {
      const TreeSize of_sides = beyond - TreeSize{m, 0};
      if (!digits.is_among(counts_.double_passes[static_cast<std::size_t>(m)][of_sides])) continue;
      return decode_double_pass(m, of_sides, branch.fingers, digits, tendon);
    }
  }
  tendon.middle.push_back(block(TokenKind::block_pass, 0));
  if (beyond.blocks == 0 && digits.is_among(loops_through_pass(parts_, n, identity_))) {
    tendon.closed = true;
    append_loop(n, branch.fingers, digits, tendon.middle);
    return;
  }
  const SizeTable& table = is_pulley ? counts_.sides : counts_.halves;
  const Pair sides = decode_pair(table, 1, beyond, branch.fingers, digits);
  decode_side(sides.first, tendon.left);
  decode_side(sides.second, tendon.right);
}

void TreeDecoder::decode_double_pass(int m, TreeSize of_sides, FingerSet fingers, Digits& digits,
                                     SplitTendon& tendon) const {
  const MirroredString string = mirrored(parts_, m, identity_);
  append_middle(m, string.middles, fingers, digits, tendon.middle);
  Pair sides = decode_pair(counts_.sides, string.halves, of_sides, fingers, digits);
  const auto append_side = [&](TreeIndex& side, HalfTendon& half) {
    if (identity_ == FingerIdentity::identical) {
      append_mirrored(m, side.index % string.halves, half.tokens);
    }
    half.tokens.push_back(block(TokenKind::block_pass, 0));
    side.index /= string.halves;
    decode_side(side, half);
  };
  append_side(sides.first, tendon.left);
  append_side(sides.second, tendon.right);
}

void TreeDecoder::decode_two_tailed(int m, TreeSize below, FingerSet fingers, Digits& digits,
                                    SplitTendon& tendon) const {
  const MirroredString string = between_tails(parts_, m, identity_);
  if (m == 0) {
    append_beside(digits.take(string.middles) + (parts_.linked ? 0 : 1), tendon.middle);
  } else {
    append_middle(m, string.middles, fingers, digits, tendon.middle);
  }
  Pair branches = decode_pair(counts_.branches, string.halves, below, fingers, digits);
  const auto append_half = [&](TreeIndex& branch, HalfTendon& half) {
    Digits variant(branch.index % string.halves);
    branch.index /= string.halves;
    half.tail = branch;
    if (m == 0) return;
    const std::uint64_t beside = variant.take(end_variants(parts_));
    if (identity_ == FingerIdentity::identical) append_mirrored(m, variant.rest(), half.tokens);
    append_beside(beside, half.tokens);
  };
  append_half(branches.first, tendon.left);
  append_half(branches.second, tendon.right);
}

template <typename Others>
TreeIndex TreeDecoder::decode_pass(const TreeIndex& whole, Others others, Walk& walk,
                                   SplitTendon& tendon) const {
  Digits digits(whole.index);
  SizePair split{{}, whole.size - TreeSize{0, 1}};
  while (!digits.is_among(with_riser(counts_, split, others(split.second), identity_))) {
    next_pair(split);
  }
  FingerSet rest = whole.fingers;
  const FingerSet own = take_some(rest, split.first.fingers, digits, identity_);
  // Risers are the halves behind those that are a tail alone.
  const std::uint64_t tails = counts_.halves[split.first] - counts_.risers[split.first];
  const std::uint64_t riser = tails + digits.take(counts_.risers[split.first]);
  decode_half({split.first, riser, own}, tendon.risers.emplace_back());
  walk.push_back(block(TokenKind::block_pass, static_cast<int>(tendon.risers.size())));
  return {split.second, digits.rest(), rest};
}

void TreeDecoder::append_bead(std::uint64_t bead, Walk& walk) const {
  if (bead > 0) walk.push_back(plain(parts_.joins[bead - 1]));
}

void TreeDecoder::decode_arm(int passes, const TreeIndex& arm, HalfTendon& half,
                             SplitTendon& tendon) const {
  if (passes == 0) return decode_half(arm, half);
  const SizeTable& shorter = counts_.arms[static_cast<std::size_t>(passes - 1)];
  const std::uint64_t beads = beads_before(parts_, passes - 1);
  const TreeIndex rest = decode_pass(
      arm, [&](TreeSize size) { return beads * shorter[size]; }, half.tokens, tendon);
  decode_beaded(passes - 1, rest, half, tendon);
}

void TreeDecoder::decode_beaded(int passes, TreeIndex arm, HalfTendon& half,
                                SplitTendon& tendon) const {
  const std::uint64_t beads = beads_before(parts_, passes);
  append_bead(arm.index % beads, half.tokens);
  arm.index /= beads;
  decode_arm(passes, arm, half, tendon);
}

void TreeDecoder::decode_in_series(int passes, const TreeIndex& tree, SplitTendon& tendon) const {
  const int on_a_side = passes / 2;
  const SizeTable& arms = counts_.arms[static_cast<std::size_t>(on_a_side)];
  const std::uint64_t beads = beads_before(parts_, on_a_side);
  Digits digits(tree.index);
  if (passes % 2 == 0) {
    append_bead(digits.take(beads), tendon.middle);
    const Pair pair = decode_pair(arms, 1, tree.size, tree.fingers, digits);
    decode_arm(on_a_side, pair.first, tendon.left, tendon);
    decode_arm(on_a_side, pair.second, tendon.right, tendon);
    return;
  }
  const PairSide side{arms, beads};
  const auto pairs_of = [&](TreeSize size) { return all_pairs(side, side, size, identity_); };
  const TreeIndex both = decode_pass(tree, pairs_of, tendon.middle, tendon);
  digits = Digits(both.index);
  const Pair pair = decode_pair(arms, beads, both.size, both.fingers, digits);
  decode_beaded(on_a_side, pair.first, tendon.left, tendon);
  decode_beaded(on_a_side, pair.second, tendon.right, tendon);
}

// A root of an end and a tail, or of an end, a join and a tail.
bool TreeDecoder::decode_hanging(const TreeIndex& tree, Digits& digits, SplitTendon& tendon) const {
  const std::uint64_t branches = counts_.branches[tree.size];
  const auto is_among = [&] {
    if (!digits.is_among(branches)) return false;
    tendon.right.tail = TreeIndex{tree.size, digits.rest(), tree.fingers};
    return true;
  };
  if (may_hang_on_motor(parts_) && is_among()) {
    tendon.left.tokens.push_back(motor_end());
    return true;
  }
  for (const TokenKind end : parts_.ends) {
    for (const TokenKind beside : parts_.beside) {
      if (!may_hang(end, beside) || !is_among()) continue;
      tendon.left.tokens.assign({plain(beside), plain(end)});
      return true;
    }
  }
  return false;
}

void TreeDecoder::decode_root(const TreeIndex& tree, SplitTendon& tendon) const {
  clear(tendon);
  const auto [n, k] = tree.size;
  Digits digits(tree.index);
  FingerSet fingers = tree.fingers;
  if (decode_hanging(tree, digits, tendon)) return;
  for (int m = 0; m < n; ++m) {
    const TreeSize below{n - m, k};
    const std::uint64_t arranged = choices_of(m, n, identity_) * orders_of(m, identity_);
    const std::uint64_t strings = end_variants(parts_) * one_sided_strings(parts_, m);
    if (m > 0 && digits.is_among(arranged * strings * counts_.branches[below])) {
      FingerSet own = take_some(fingers, m, digits, identity_);
      append_to_end(m, own, digits, tendon.left.tokens);
      append_beside(digits.take(end_variants(parts_)), tendon.right.tokens);
      tendon.right.tail = TreeIndex{below, digits.rest(), fingers};
      return;
    }
    if (digits.is_among(counts_.two_tailed[static_cast<std::size_t>(m)][below])) {
      decode_two_tailed(m, below, fingers, digits, tendon);
      return;
    }
  }
  int passes = 2;
  while (!digits.is_among(counts_.in_series[static_cast<std::size_t>(passes)][tree.size])) ++passes;
  decode_in_series(passes, {tree.size, digits.rest(), tree.fingers}, tendon);
}

}  // namespace reeve::search
