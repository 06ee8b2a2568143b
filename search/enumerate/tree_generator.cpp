#include "search/enumerate/tree_generator.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/walk_image.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {
namespace {

std::strong_ordering compare_blocks(const Tendon& a, const Tendon& b) {
  return std::lexicographical_compare_three_way(
      a.walk.begin(), a.walk.end(), b.walk.begin(), b.walk.end(),
      [](const Token& x, const Token& y) { return x.block <=> y.block; });
}

// The tendons that blocks tie together, and the others.
struct TiedTendons {
  Routing tied;
  Routing others;
};

TiedTendons tied_tendons(const Routing& routing) {
  TiedTendons result;
  for (const Tendon& tendon : routing.tendons) {
    const bool is_tied = std::any_of(tendon.walk.begin(), tendon.walk.end(),
                                     [](const Token& token) { return is_of_block(token.kind); });
    (is_tied ? result.tied : result.others).tendons.push_back(tendon);
  }
  return result;
}

}  // namespace

TreeGenerator::TreeGenerator(const GeneratorOptions& options, const PartClasses& classes)
    : options_(options),
      classes_(classes),
      grammar_({options.parts}, options.fingers, options.identity),
      writer_(grammar_.grammar()),
      parts_(classes, grammar_.grammar()),
      beside_(options, classes) {
  const int n = options.fingers;
  const auto blocks_at_most = static_cast<std::size_t>(options.parts.blocks);
  spans_.reserve(blocks_at_most);
  list_.tendons.reserve(2 * blocks_at_most);  // a root, and a tendon for each block
  for (int blocks = 1; blocks <= options.parts.blocks; ++blocks) {
    for (int fingers = n; fingers > (options.one_tendon ? n - 1 : 0); --fingers) {
      add_cell({fingers, blocks});
    }
  }
}

void TreeGenerator::add_cell(TreeSize size) {
  const Grammar::Sort of_sets = options_.one_tendon ? grammar_.tree(size) : grammar_.sets(size);
  const std::uint64_t choices = choices_of(size.fingers, options_.fingers, options_.identity);
  Cell cell{.size = size,
            .others = options_.fingers - size.fingers,
            .of_sets = of_sets,
            .sets = times(choices, grammar().size(of_sets)),
            .begin = total_};
  cell.tendons = cell.others == 0 ? 1 : beside_.total(cell.others);
  if (cell.sets == 0 || cell.tendons == 0) return;
  if (has_limits()) cell.goal = goal(cell.others);
  cells_.push_back(cell);
  total_ = plus(total_, times(cell.sets, cell.tendons));
}

// The goal of the trees that stand beside tendons of so many fingers.
NumberedParts::Goal TreeGenerator::goal(int others) {
  const ClassSet& whole = classes_.admitted_classes();
  if (others == 0) return parts_.goal(whole);
  return parts_.goal(completed_sums(classes_, beside_.shapes().counts(others), whole));
}

ClassCounts TreeGenerator::counts_before(std::uint64_t index) {
  ClassCounts sum = no_counts(classes_);
  LimitedTendons& tendons = beside_.shapes();
  for (const Cell& cell : cells_) {
    if (cell.begin >= index) break;
    const std::uint64_t within = std::min(index - cell.begin, cell.sets * cell.tendons);
    const std::uint64_t set = within / cell.tendons;
    const std::uint64_t rest = within % cell.tendons;
    const ClassCounts sets = parts_.counts_before(cell.of_sets, set);
    add(sum, cell.others == 0 ? sets : product(classes_, sets, tendons.counts(cell.others)));
    if (rest == 0) continue;
    add(sum, shifted(classes_, tendons.counts_before(cell.others, rest),
                     parts_.parts_of(cell.of_sets, set)));
  }
  return sum;
}

std::optional<std::uint64_t> TreeGenerator::index_of(const Routing& routing) {
  const auto [tied, others] = tied_tendons(routing);
  const BlockCount count = block_count(routing);
  const TreeSize size{finger_count(tied), count.blocks + count.bars};
  const auto cell = std::find_if(cells_.begin(), cells_.end(),
                                 [&](const Cell& each) { return each.size == size; });
  if (cell == cells_.end()) return std::nullopt;
  std::optional<std::uint64_t> beside = 0;
  if (!others.tendons.empty()) beside = beside_.shapes().place_of(others);
  if (!beside) return std::nullopt;
  cell_ = static_cast<std::size_t>(cell - cells_.begin());
  of_others_ = others;
  const NumberedParts::Goal equivalent = parts_.goal(ClassSet().set(classes_.of(tied)));
  Routing made;
  for (auto set = parts_.first(cell->of_sets, 0, equivalent); set;
       set = parts_.first(cell->of_sets, set->index + 1, equivalent)) {
    list_set(set->index);
    write(made);
    if (made == routing) return cell->begin + set->index * cell->tendons + *beside;
  }
  return std::nullopt;
}

void TreeGenerator::seek(std::uint64_t index) {
  set_.reset();
  next_set_ = 0;
  Digits digits(index);
  for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
    if (digits.is_among(cells_[cell_].sets * cells_[cell_].tendons)) break;
  }
  if (cell_ == cells_.size()) return;
  const std::uint64_t beside = digits.take(cells_[cell_].tendons);
  next_set_ = digits.rest();
  if (beside == 0) return;
  const Grammar::Sort of_sets = cells_[cell_].of_sets;
  const PartClass parts = has_limits() ? parts_.parts_of(of_sets, next_set_) : PartClasses::none;
  start_set({next_set_, parts}, beside);
}

void TreeGenerator::start_set(NumberedParts::Found set, std::uint64_t beside) {
  set_ = set.index;
  next_set_ = set.index + 1;
  list_set(set.index);
  const int others = cells_[cell_].others;
  is_alone_ = others == 0;
  if (!is_alone_) beside_.seek(others, set.parts, beside);
}

bool TreeGenerator::next_set() {
  set_.reset();
  for (; cell_ < cells_.size(); ++cell_, next_set_ = 0) {
    const Cell& cell = cells_[cell_];
    ++steps_;
    if (!has_limits()) {
      if (next_set_ == cell.sets) continue;
      start_set({next_set_, PartClasses::none}, 0);
      return true;
    }
    const auto found = parts_.first(cell.of_sets, next_set_, cell.goal);
    if (!found) continue;
    start_set(*found, 0);
    return true;
  }
  return false;
}

bool TreeGenerator::next_beside(std::uint64_t& index) {
  if (!set_) return false;
  if (cells_[cell_].others > 0) return beside_.next(of_others_, index);
  of_others_.tendons.clear();
  index = 0;
  return std::exchange(is_alone_, false);
}

bool TreeGenerator::next(Routing& routing, std::uint64_t& index) {
  std::uint64_t beside = 0;
  while (!next_beside(beside)) {
    if (!next_set()) return false;
  }
  write(routing);
  index = cells_[cell_].begin + *set_ * cells_[cell_].tendons + beside;
  return true;
}

void TreeGenerator::list_set(std::uint64_t set) {
  const Cell& cell = cells_[cell_];
  Digits digits(set);
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
  routing.tendons.resize(list_.used + of_others_.tendons.size());
  if (options_.identity == FingerIdentity::distinct) number_others();
  std::size_t tendon = 0;
  BlockCount blocks;
  auto span = spans_.begin();
  for (const Tendon& other : of_others_.tendons) {
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
  for (Tendon& tendon : of_others_.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) token.finger = numbers[token.finger - 1];
    }
  }
}

}  // namespace reeve::search
