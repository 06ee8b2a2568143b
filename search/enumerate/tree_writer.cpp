#include "search/enumerate/tree_writer.hpp"

#include <algorithm>

#include "core/walk_image.hpp"

namespace reeve::search {
namespace {

// With tails for the branches, which get their numbers when the way to walk is settled.
void join_halves(const SplitTendon& split, Tendon& tendon) {
  tendon.closed = split.closed;
  tendon.walk.clear();
  const Token tail = block(TokenKind::block_tail, 0);
  if (split.left.tail) tendon.walk.push_back(tail);
  tendon.walk.insert(tendon.walk.end(), split.left.tokens.rbegin(), split.left.tokens.rend());
  tendon.walk.insert(tendon.walk.end(), split.middle.begin(), split.middle.end());
  tendon.walk.insert(tendon.walk.end(), split.right.tokens.begin(), split.right.tokens.end());
  if (split.right.tail) tendon.walk.push_back(tail);
}

std::strong_ordering compare_with_reversal(const Walk& walk) {
  for (std::size_t i = 0, j = walk.size(); j-- > 0; ++i) {
    if (const auto order = compare_shapes(walk[i], walk[j]); order != 0) return order;
  }
  return std::strong_ordering::equal;
}

bool is_lesser(const Walk& walk, Image a, Image b) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = compare_shapes(image_token(walk, a, i), image_token(walk, b, i));
    if (order != 0) return order < 0;
  }
  return false;
}

void walk_loop_from_least(Tendon& tendon) {
  Image least = as_it_stands;
  bool first = true;
  for_each_image(tendon, [&](Image image) {
    if (first || is_lesser(tendon.walk, image, least)) least = image;
    first = false;
    return true;
  });
  tendon = walked(tendon, least);
}

}  // namespace

void TreeWriter::write(const TreeIndex& tree, TendonList& list) {
  branches_.clear();
  decoder_.decode_root(tree, tendon_);
  write_tendon(tendon_, 0, branches_, list);
  write_below(branches_, list);
}

// Level by level: each tendon adds the branches that hang on it. Branch i hangs on block i + 1.
void TreeWriter::write_below(std::vector<TreeIndex>& branches, TendonList& list) {
  for (std::size_t i = 0; i < branches.size(); ++i) {
    decoder_.decode_branch(branches[i], tendon_);
    write_tendon(tendon_, static_cast<int>(i) + 1, branches, list);
  }
}

void TreeWriter::write_tendon(SplitTendon& split, int own_block, std::vector<TreeIndex>& branches,
                              TendonList& list) {
  Tendon& tendon = list.add();
  join_halves(split, tendon);
  if (tendon.closed) {
    walk_loop_from_least(tendon);
  } else if (stands_backwards(split, tendon.walk)) {
    std::reverse(tendon.walk.begin(), tendon.walk.end());
    std::swap(split.left.tail, split.right.tail);
  }
  for (const auto* half : {&split.left, &split.right}) {
    if (!half->tail) continue;
    branches.push_back(*half->tail);
    Token& tail = half == &split.left ? tendon.walk.front() : tendon.walk.back();
    tail.block = static_cast<std::uint8_t>(branches.size());
  }
  for (Token& token : tendon.walk) {
    if (token.kind == TokenKind::block_pass) token.block = static_cast<std::uint8_t>(own_block);
  }
}

bool TreeWriter::stands_backwards(const SplitTendon& split, const Walk& walk) const {
  const auto order = compare_with_reversal(walk);
  if (order != 0) return order > 0;
  return split.left.tail && split.right.tail && precedes(*split.right.tail, *split.left.tail);
}

// Rare: tendon by tendon, as they would be listed.
bool TreeWriter::precedes(const TreeIndex& a, const TreeIndex& b) const {
  if (a == b) return false;
  TreeWriter writer(decoder_);
  TendonList first;
  TendonList second;
  std::vector<TreeIndex> branches{a};
  writer.write_below(branches, first);
  branches.assign(1, b);
  writer.write_below(branches, second);
  return std::lexicographical_compare(
      first.tendons.begin(), first.tendons.end(), second.tendons.begin(), second.tendons.end(),
      [](const Tendon& x, const Tendon& y) { return compare_shapes(x, y) < 0; });
}

}  // namespace reeve::search
