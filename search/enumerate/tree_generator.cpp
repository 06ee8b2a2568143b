#include "search/enumerate/tree_generator.hpp"

#include <algorithm>
#include <bit>

#include "core/walk_image.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

std::strong_ordering compare_blocks(const Tendon& a, const Tendon& b) {
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return x.block <=> y.block; });
}

GeneratorOptions without_blocks(GeneratorOptions options, int fingers) {
  options.parts.blocks = 0;
  options.fingers = fingers;
  return options;
}

}  // namespace

TreeGenerator::TreeGenerator(const GeneratorOptions& options)
    : options_(options),
      grammar_({options.parts}, options.fingers, options.identity),
      writer_(grammar_.grammar()) {
  const int n = options.fingers;
  const auto blocks_at_most = static_cast<std::size_t>(options.parts.blocks);
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

void TreeGenerator::add_cell(TreeSize size) {
  const int n = options_.fingers;
  const Grammar::Sort of_sets = options_.one_tendon ? grammar_.tree(size) : grammar_.sets(size);
  const std::uint64_t choices = choices_of(size.fingers, n, options_.identity);
  Cell cell{size, of_sets, times(choices, grammar().size(of_sets)), 1};
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
  list_set();
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
    list_set();
    set_is_listed_ = true;
  }
  beside_ = of_others;
  write(routing);
}

void TreeGenerator::list_set() {
  const Cell& cell = cells_[cell_];
  Digits digits(set_);
  other_fingers_ = fingers_up_to(options_.fingers, options_.identity);
  const FingerSet fingers = take_some(other_fingers_, cell.size.fingers, digits, options_.identity);
  list_.used = 0;
  spans_.clear();
  list_trees({cell.of_sets, digits.rest(), fingers});
  std::sort(spans_.begin(), spans_.end(),
            [&](const Span& a, const Span& b) { return precedes(a, b); });
}

void TreeGenerator::list_trees(const Grammar::Thing& set) {
  using Form = Grammar::Form;
  const Grammar::Form form = grammar().node(set.sort).form;
  if (form == Form::choice) {
    list_trees(grammar().chosen(set));
  } else if (form == Form::both || form == Form::labelled) {
    const auto [first, second] = grammar().split(set);
    list_trees(first);
    list_trees(second);
  } else if (form == Form::multiset) {
    for (const Grammar::Thing& tree : grammar().members(set)) list_trees(tree);
  } else if (form == Form::tree) {
    Span span{0, list_.used, 0};
    writer_.write(set, list_);
    span.end = list_.used;
    for (std::size_t t = span.begin; t < span.end; ++t) {
      span.fingers += finger_count(list_.tendons[t]);
    }
    spans_.push_back(span);
  }
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
