#include "search/enumerate/tree_generator.hpp"

#include <algorithm>
#include <bit>

#include "core/walk_image.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

std::strong_ordering compare_with_reversal(const Walk& walk) {
  for (std::size_t i = 0, j = walk.size(); j-- > 0; ++i) {
    if (const auto order = compare_shapes(walk[i], reversed(walk[j])); order != 0) return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare_blocks(const Tendon& a, const Tendon& b) {
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return x.block <=> y.block; });
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

GeneratorOptions without_blocks(GeneratorOptions options, int fingers) {
  options.parts.blocks = 0;
  options.fingers = fingers;
  return options;
}

}  // namespace

void TreeWriter::write(const TreeIndex& tree, TendonList& list) {
  const std::size_t begin = list.used;
  decoder_.decode_root(tree, tendon_);
  const std::size_t in_series = tendon_.risers.size();
  branches_.assign(in_series, {});
  write_tendon(tendon_, 0, branches_, list);
  write_risers(list);
  write_below(branches_, list, in_series);
  if (in_series == 0) {
    if (decoder_.has_bars()) number_blocks_in_order({&list.tendons[begin], list.used - begin});
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
    riser.middle.push_back(block(TokenKind::block_tail, static_cast<int>(i) + 1));
    riser.right = tendon_.risers[i];
    write_tendon(riser, 0, branches_, list);
  }
}

// Level by level: each tendon adds the branches that hang on it. Branch i hangs on block i + 1.
void TreeWriter::write_below(std::vector<TreeIndex>& branches, TendonList& list, std::size_t from) {
  for (std::size_t i = from; i < branches.size(); ++i) {
    decoder_.decode_branch(branches[i], tendon_);
    write_tendon(tendon_, static_cast<int>(i) + 1, branches, list);
  }
}

// Puts tails in place of the branches. They get their numbers when the walking direction is
// settled.
void TreeWriter::join_halves(const SplitTendon& split, Tendon& tendon) const {
  tendon.closed = split.closed;
  tendon.walk.clear();
  if (split.left.tail) tendon.walk.push_back(decoder_.tail_of(*split.left.tail));
  tendon.walk.insert(tendon.walk.end(), split.left.tokens.rbegin(), split.left.tokens.rend());
  tendon.walk.insert(tendon.walk.end(), split.middle.begin(), split.middle.end());
  tendon.walk.insert(tendon.walk.end(), split.right.tokens.begin(), split.right.tokens.end());
  if (split.right.tail) tendon.walk.push_back(decoder_.tail_of(*split.right.tail));
}

void TreeWriter::write_tendon(SplitTendon& split, int own_block, std::vector<TreeIndex>& branches,
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

TreeGenerator::TreeGenerator(const GeneratorOptions& options)
    : options_(options),
      counts_(tree_counts(options.parts, options.fingers, options.identity)),
      decoder_(options_.parts, counts_, options.identity),
      writer_(decoder_),
      sets_(counts_.trees, options.identity) {
  const int n = options.fingers;
  const auto blocks_at_most = static_cast<std::size_t>(options.parts.blocks);
  trees_.reserve(blocks_at_most);
  spans_.reserve(blocks_at_most);
  list_.tendons.reserve(2 * blocks_at_most);  // a root, and a tendon for each block
  if (!options.one_tendon) {
    for (int fingers = 1; fingers < n; ++fingers) {
      others_.emplace_back(without_blocks(options, fingers));
    }
  }
  for (int blocks = 1; blocks <= options.parts.blocks; ++blocks) {
    for (int fingers = n; fingers > (options.one_tendon ? n - 1 : 0); --fingers) {
      add_cell({fingers, blocks});
    }
  }
}

std::uint64_t TreeGenerator::sets_of(TreeSize size) const {
  return options_.one_tendon ? counts_.trees[size] : sets_.count(size);
}

void TreeGenerator::add_cell(TreeSize size) {
  const int n = options_.fingers;
  Cell cell{size, times(choices_of(size.fingers, n, options_.identity), sets_of(size)), 1};
  if (size.fingers < n) cell.tendons = others(cell).total();
  if (cell.sets == 0 || cell.tendons == 0) return;
  cells_.push_back(cell);
  total_ = plus(total_, times(cell.sets, cell.tendons));
}

TendonGenerator& TreeGenerator::others(const Cell& cell) {
  return others_[static_cast<std::size_t>(options_.fingers - cell.size.fingers - 1)];
}

void TreeGenerator::seek(std::uint64_t index) {
  Digits digits(index);
  for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
    if (digits.is_among(cells_[cell_].sets * cells_[cell_].tendons)) break;
  }
  if (cell_ == cells_.size()) return;
  tendons_ = digits.take(cells_[cell_].tendons);
  set_ = digits.rest();
  set_is_listed_ = false;
}

bool TreeGenerator::next(Routing& routing) {
  if (cell_ == cells_.size()) return false;
  if (!set_is_listed_) start_set();
  if (cells_[cell_].size.fingers < options_.fingers) others(cells_[cell_]).next(beside_);
  write(routing);
  advance();
  return true;
}

void TreeGenerator::advance() {
  if (++tendons_ < cells_[cell_].tendons) return;
  tendons_ = 0;
  set_is_listed_ = false;
  if (++set_ < cells_[cell_].sets) return;
  set_ = 0;
  ++cell_;
}

void TreeGenerator::start_set() {
  decode_set();
  beside_.tendons.clear();
  const Cell& cell = cells_[cell_];
  if (cell.size.fingers < options_.fingers) others(cell).seek(tendons_);
  set_is_listed_ = true;
}

void TreeGenerator::make(std::size_t cell, std::uint64_t set, const Routing& of_others,
                         Routing& routing) {
  if (!set_is_listed_ || cell_ != cell || set_ != set) {
    cell_ = cell;
    set_ = set;
    decode_set();
    set_is_listed_ = true;
  }
  beside_ = of_others;
  write(routing);
}

void TreeGenerator::decode_set() {
  const Cell& cell = cells_[cell_];
  Digits digits(set_);
  other_fingers_ = fingers_up_to(options_.fingers, options_.identity);
  const FingerSet fingers = take_some(other_fingers_, cell.size.fingers, digits, options_.identity);
  if (options_.one_tendon) {
    trees_.assign(1, {cell.size, digits.rest(), fingers});
  } else {
    sets_.decode(cell.size, digits.rest(), fingers, trees_);
  }
  list_trees();
}

void TreeGenerator::list_trees() {
  list_.used = 0;
  spans_.clear();
  for (const TreeIndex& tree : trees_) {
    const std::size_t begin = list_.used;
    writer_.write(tree, list_);
    spans_.push_back({tree.size.fingers, begin, list_.used});
  }
  std::sort(spans_.begin(), spans_.end(),
            [&](const Span& a, const Span& b) { return precedes(a, b); });
}

bool TreeGenerator::precedes(const Span& a, const Span& b) const {
  if (a.fingers != b.fingers) return a.fingers > b.fingers;
  const auto at = [&](std::size_t i) {
    return list_.tendons.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto order = [&](auto compare) {
    return std::lexicographical_compare_three_way(at(a.begin), at(a.end), at(b.begin), at(b.end),
                                                  compare);
  };
  const auto shapes = order([](const Tendon& x, const Tendon& y) { return compare_shapes(x, y); });
  // Shapes tell all but by which of several blocks in series a tendon is reached.
  return shapes != 0 ? shapes < 0 : order(compare_blocks) < 0;
}

void TreeGenerator::append_tree(const Span& span, std::size_t& tendon, BlockCount& blocks,
                                Routing& routing) const {
  const BlockCount before = blocks;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    Tendon& written = routing.tendons[tendon++];
    written = list_.tendons[i];
    for (Token& token : written.walk) {
      if (!is_of_block(token.kind)) continue;
      token.block = static_cast<std::uint8_t>(token.block + before.of(token));
      blocks.of(token) = std::max<int>(blocks.of(token), token.block);
    }
  }
}

// A tendon precedes a tree of as many fingers, whose root has fewer of them.
void TreeGenerator::write(Routing& routing) {
  routing.tendons.resize(list_.used + beside_.tendons.size());
  if (options_.identity == FingerIdentity::distinct) number_others();
  std::size_t tendon = 0;
  BlockCount blocks;
  auto span = spans_.begin();
  for (const Tendon& other : beside_.tendons) {
    for (; span != spans_.end() && span->fingers > finger_count(other); ++span) {
      append_tree(*span, tendon, blocks, routing);
    }
    routing.tendons[tendon++] = other;
  }
  for (; span != spans_.end(); ++span) append_tree(*span, tendon, blocks, routing);
  if (options_.identity == FingerIdentity::distinct) {
    routing = canonical(routing, FingerIdentity::distinct);
  } else {
    number_in_order(routing);
  }
}

// The tendons beside the trees come with the numbers 1, 2, … for the fingers that are left.
void TreeGenerator::number_others() {
  std::uint8_t numbers[max_fingers] = {};
  std::size_t many = 0;
  for (FingerSet rest = other_fingers_; rest != 0; rest &= rest - 1) {
    numbers[many++] = static_cast<std::uint8_t>(std::countr_zero(rest) + 1);
  }
  for (Tendon& tendon : beside_.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) token.finger = numbers[token.finger - 1];
    }
  }
}

}  // namespace reeve::search
