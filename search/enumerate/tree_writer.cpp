#include "search/enumerate/tree_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/canonical.hpp"
#include "core/walk_image.hpp"

namespace reeve::search {
namespace {

void clear(SplitTendon& tendon) {
  for (HalfTendon* half : {&tendon.left, &tendon.middle, &tendon.right}) {
    half->tokens.clear();
    half->beside_tail.clear();
    half->tail.reset();
  }
  tendon.closed = false;
  tendon.risers.clear();
}

bool is_bar(const SplitTendon& tendon) {
  const Walk& middle = tendon.middle.tokens;
  return !middle.empty() && middle.front().kind == TokenKind::bar_arms;
}

std::strong_ordering compare_with_reversal(const Walk& walk) {
  for (std::size_t i = 0, j = walk.size(); j-- > 0; ++i) {
    if (const auto order = compare_shapes(walk[i], reversed(walk[j])); order != 0) return order;
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

void TreeWriter::read_sides(const Thing& left, const Thing& right, SplitTendon& tendon) const {
  read(left, tendon.left, tendon);
  read(right, tendon.right, tendon);
}

void TreeWriter::read(const Thing& thing, HalfTendon& half, SplitTendon& tendon) const {
  using Form = Grammar::Form;
  const Grammar::Node& node = grammar_.node(thing.sort);
  const auto inner = [&] { return Thing{node.of[0], thing.index, thing.fingers}; };
  switch (node.form) {
    case Form::kinds:
    case Form::row:
    case Form::ring:
      return grammar_.append_tokens(thing, half.tokens);
    case Form::choice:
      return read(grammar_.chosen(thing), half, tendon);
    case Form::both: {
      const auto [first, second] = grammar_.split(thing);
      read(first, half, tendon);
      return read(second, half, tendon);
    }
    case Form::sides:
    case Form::labelled: {
      const auto [left, right] = grammar_.split(thing);
      return read_sides(left, right, tendon);
    }
    case Form::multiset: {
      const Grammar::Members members = grammar_.members(thing);
      return read_sides(members[1], members[0], tendon);
    }
    case Form::tail:
      half.tail = inner();
      return;
    case Form::beside_tail:
      return grammar_.append_tokens(inner(), half.beside_tail);
    case Form::loop:
      tendon.closed = true;
      return read(inner(), half, tendon);
    case Form::riser:
      read(inner(), tendon.risers.emplace_back(), tendon);
      half.tokens.push_back(block(TokenKind::block_pass, static_cast<int>(tendon.risers.size())));
      return;
    case Form::hung:
    case Form::tree:
      return read(inner(), half, tendon);
  }
}

void TreeWriter::read_branch(const Thing& branch, SplitTendon& tendon) const {
  clear(tendon);
  read(branch, tendon.middle, tendon);
  if (is_bar(tendon)) tendon.middle.tokens.front() = bar(0, arms_between(tendon));
}

// A side that passes the block once more pulls it by two more strands, and by one if it ends there.
int TreeWriter::sides_below(const HalfTendon& half) const {
  const auto many = [&](TokenKind kind) {
    return static_cast<int>(std::count_if(half.tokens.begin(), half.tokens.end(),
                                          [&](const Token& token) { return token.kind == kind; }));
  };
  const int strands = 1 + many(TokenKind::block_pass);
  return half.tail ? strands * sides_below(*half.tail) : strands + many(TokenKind::becket);
}

int TreeWriter::sides_below(const Thing& branch) const {
  SplitTendon sides;
  read(branch, sides.middle, sides);
  return sides_below(sides.left) + sides_below(sides.right);
}

ArmRatio TreeWriter::arms_between(const SplitTendon& sides) const {
  const int left = sides_below(sides.left);
  const int right = sides_below(sides.right);
  const int common = std::gcd(left, right);
  return {static_cast<std::uint16_t>(left / common), static_cast<std::uint16_t>(right / common)};
}

Token TreeWriter::tail_of(Thing branch) const {
  if (grammar_.node(branch.sort).form == Grammar::Form::choice) branch = grammar_.chosen(branch);
  return grammar_.node(branch.sort).token;
}

void TreeWriter::write(const Thing& tree, TendonList& list) {
  const std::size_t begin = list.used;
  clear(tendon_);
  read(tree, tendon_.middle, tendon_);
  const std::size_t in_series = tendon_.risers.size();
  branches_.assign(in_series, {});
  write_tendon(tendon_, 0, branches_, list);
  write_risers(list);
  write_below(branches_, list, in_series);
  if (in_series == 0) {
    number_blocks_in_order({&list.tendons[begin], list.used - begin});
    return;
  }
  const auto first = list.tendons.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto end = list.tendons.begin() + static_cast<std::ptrdiff_t>(list.used);
  // Fingers keep the numbers that they have.
  const Routing written = canonical({{first, end}}, FingerIdentity::distinct);
  std::copy(written.tendons.begin(), written.tendons.end(), first);
}

void TreeWriter::write_risers(TendonList& list) {
  for (std::size_t i = 0; i < tendon_.risers.size(); ++i) {
    SplitTendon riser;
    riser.middle.tokens.push_back(block(TokenKind::block_tail, static_cast<int>(i) + 1));
    riser.right = tendon_.risers[i];
    write_tendon(riser, 0, branches_, list);
  }
}

// Level by level: each tendon adds the branches that hang on it. Branch i hangs on block i + 1.
void TreeWriter::write_below(std::vector<Thing>& branches, TendonList& list, std::size_t from) {
  for (std::size_t i = from; i < branches.size(); ++i) {
    read_branch(branches[i], tendon_);
    write_tendon(tendon_, static_cast<int>(i) + 1, branches, list);
  }
}

// Puts tails in place of the branches. They get their numbers when the walking direction is
// settled.
void TreeWriter::join_halves(const SplitTendon& split, Tendon& tendon) const {
  const Walk& middle = split.middle.tokens;
  const auto behind_pass = middle.begin() + (split.closed ? 1 : 0);
  Walk& walk = tendon.walk;
  tendon.closed = split.closed;
  walk.assign(middle.begin(), behind_pass);
  const auto& [left, beside_left, left_tail] = split.left;
  if (left_tail) walk.push_back(tail_of(*left_tail));
  walk.insert(walk.end(), beside_left.rbegin(), beside_left.rend());
  walk.insert(walk.end(), left.rbegin(), left.rend());
  walk.insert(walk.end(), behind_pass, middle.end());
  const auto& [right, beside_right, right_tail] = split.right;
  walk.insert(walk.end(), right.begin(), right.end());
  walk.insert(walk.end(), beside_right.begin(), beside_right.end());
  if (right_tail) walk.push_back(tail_of(*right_tail));
}

void TreeWriter::write_tendon(SplitTendon& split, int own_block, std::vector<Thing>& branches,
                              TendonList& list) {
  Tendon& tendon = list.add();
  join_halves(split, tendon);
  if (tendon.closed) {
    walk_loop_from_least(tendon);
  } else if (stands_backwards(split, tendon.walk)) {
    tendon = walked(tendon, {tendon.walk.size() - 1, true});
    std::swap(split.left.tail, split.right.tail);
  }
  for (const auto* half : {&split.left, &split.right}) {
    if (!half->tail) continue;
    branches.push_back(*half->tail);
    Token& tail = half == &split.left ? tendon.walk.front() : tendon.walk.back();
    tail.block = static_cast<std::uint8_t>(branches.size());
  }
  for (Token& token : tendon.walk) {
    if (!is_of_block(token.kind) || token.block > 0) continue;
    token.block = static_cast<std::uint8_t>(own_block);
  }
}

bool TreeWriter::stands_backwards(const SplitTendon& split, const Walk& walk) const {
  const auto order = compare_with_reversal(walk);
  if (order != 0) return order > 0;
  return split.left.tail && split.right.tail && precedes(*split.right.tail, *split.left.tail);
}

// Rare: tendon by tendon, as they would be listed.
bool TreeWriter::precedes(const Thing& a, const Thing& b) const {
  if (a == b) return false;
  TreeWriter writer(grammar_);
  TendonList first;
  TendonList second;
  std::vector<Thing> branches{a};
  writer.write_below(branches, first);
  branches.assign(1, b);
  writer.write_below(branches, second);
  return std::lexicographical_compare(
      first.tendons.begin(), first.tendons.end(), second.tendons.begin(), second.tendons.end(),
      [](const Tendon& x, const Tendon& y) { return compare_shapes(x, y) < 0; });
}

}  // namespace reeve::search
