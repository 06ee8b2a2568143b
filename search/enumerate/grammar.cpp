#include "search/enumerate/grammar.hpp"

#include <algorithm>
#include <bit>

namespace reeve::search {
namespace {

void give_number(int finger, Token& token) { token.finger = static_cast<std::uint8_t>(finger); }

}  // namespace

FingerSet fingers_up_to(int fingers, FingerIdentity identity) {
  if (identity == FingerIdentity::identical || fingers == 0) return 0;
  return ~FingerSet{0} >> (64 - fingers);
}

std::uint64_t choices_of(int fingers, int of, FingerIdentity identity) {
  return identity == FingerIdentity::identical
             ? 1
             : binomial(static_cast<std::uint64_t>(of), static_cast<std::uint64_t>(fingers));
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

Grammar::Sort Grammar::add(Node node, const std::vector<std::uint64_t>& sizes) {
  nodes_.push_back(std::move(node));
  sizes_.insert(sizes_.end(), sizes.begin(), sizes.end());
  return nodes_.size() - 1;
}

// `size_at` gives the size that a power leaves.
template <typename SizeAt>
std::vector<std::uint64_t> Grammar::at_powers(SizeAt size_at) const {
  std::vector<std::uint64_t> sizes;
  for (std::size_t p = 0; p < powers_; ++p) sizes.push_back(size_at(p));
  return sizes;
}

Grammar::Sort Grammar::kinds(std::vector<Kind> kinds, const std::vector<std::uint64_t>& sizes) {
  return add({.form = Form::kinds, .kinds = std::move(kinds)}, sizes);
}

Grammar::Sort Grammar::kinds(std::vector<Kind> kinds) {
  const std::uint64_t size = kinds.size();
  return this->kinds(std::move(kinds), std::vector<std::uint64_t>(powers_, size));
}

Grammar::Sort Grammar::row(const std::vector<Sort>& kinds) {
  if (identity_ == FingerIdentity::distinct) return arranged(Form::row, kinds);
  Sort together = kinds.back();
  for (std::size_t i = kinds.size() - 1; i-- > 0;) together = both(kinds[i], together);
  return together;
}

// A finger is every second of the kinds, from the first on.
Grammar::Sort Grammar::arranged(Form form, const std::vector<Sort>& kinds) {
  const int fingers = (static_cast<int>(kinds.size()) + 1) / 2;
  const std::uint64_t orders = factorial(fingers);
  return add({.form = form, .of = kinds, .fingers = fingers}, at_powers([&](std::size_t p) {
               std::uint64_t size = form == Form::ring && fingers > 1 ? orders / 2 : orders;
               for (const Sort sort : kinds) size = times(size, this->size(sort, p));
               return size;
             }));
}

Grammar::Sort Grammar::choice(std::vector<Sort> sorts) {
  std::vector<std::uint64_t> sizes = at_powers([&](std::size_t p) {
    std::uint64_t sum = 0;
    for (const Sort sort : sorts) sum = plus(sum, size(sort, p));
    return sum;
  });
  int fingers = 0;
  for (const Sort sort : sorts) fingers = std::max(fingers, nodes_[sort].fingers);
  return add({.form = Form::choice, .of = std::move(sorts), .fingers = fingers}, sizes);
}

Grammar::Sort Grammar::two(Form form, Sort first, Sort second) {
  const int own = nodes_[first].fingers;
  const int all = own + nodes_[second].fingers;
  const auto choices = [&] {
    return form == Form::labelled ? choices_of(own - 1, all - 1, identity_)
                                  : choices_of(own, all, identity_);
  };
  return add({.form = form, .of = {first, second}, .fingers = all}, at_powers([&](std::size_t p) {
               const std::uint64_t things = times(size(first, p), size(second, p));
               return things == 0 ? 0 : times(choices(), things);
             }));
}

Grammar::Sort Grammar::multiset(Sort of, int many) {
  return add({.form = Form::multiset, .of = {of}, .many = many}, at_powers([&](std::size_t p) {
               return many == 2 ? unordered_pairs(size(of, p), size(of, 2 * p % powers_))
                                : multichoose(size(of, p), static_cast<std::uint64_t>(many));
             }));
}

Grammar::Sort Grammar::part(Form form, Sort of, const Token& token) {
  return add({.form = form, .of = {of}, .fingers = nodes_[of].fingers, .token = token},
             at_powers([&](std::size_t p) { return size(of, p); }));
}

Grammar::Thing Grammar::chosen(const Thing& thing) const {
  Digits digits(thing.index);
  const auto sort = std::find_if(nodes_[thing.sort].of.begin(), nodes_[thing.sort].of.end(),
                                 [&](Sort each) { return digits.is_among(size(each)); });
  return {*sort, digits.rest(), thing.fingers};
}

std::pair<Grammar::Thing, Grammar::Thing> Grammar::split(const Thing& thing) const {
  const Node& node = nodes_[thing.sort];
  Digits digits(thing.index);
  FingerSet others = thing.fingers;
  const int many = nodes_[node.of[0]].fingers;
  const FingerSet own = node.form == Form::labelled
                            ? take_least_and(others, many - 1, digits, identity_)
                            : take_some(others, many, digits, identity_);
  const std::uint64_t first = digits.take(size(node.of[0]));
  return {{node.of[0], first, own}, {node.of[1], digits.rest(), others}};
}

Grammar::Members Grammar::members(const Thing& thing) const {
  const Node& node = nodes_[thing.sort];
  std::uint64_t index = thing.index;
  Members members;
  for (auto many = static_cast<std::uint64_t>(node.many); many > 0; --many) {
    members.push_back({node.of[0], greatest_of_multiset(size(node.of[0]), many, index)});
  }
  return members;
}

void Grammar::append_kind(Sort kinds, Digits& digits, Walk& walk) const {
  const Kind& kind = nodes_[kinds].kinds[digits.take(size(kinds))];
  walk.insert(walk.end(), kind.begin(), kind.end());
}

void Grammar::append_row(const Node& row, Digits& digits, FingerSet fingers, Walk& walk) const {
  for (const Sort kinds : row.of) {
    const std::size_t begin = walk.size();
    append_kind(kinds, digits, walk);
    if (is_of_finger(walk[begin].kind))
      give_number(take_one(fingers, digits, identity_), walk[begin]);
  }
}

// All kinds, then all fingers; those at the ends are what the others leave.
void Grammar::append_ring(const Node& ring, Digits& digits, FingerSet fingers, Walk& walk) const {
  const std::size_t begin = walk.size();
  for (const Sort kinds : ring.of) append_kind(kinds, digits, walk);
  for (std::size_t i = begin + 2; i + 1 < walk.size(); i += 2) {
    give_number(take_one(fingers, digits, identity_), walk[i]);
  }
  give_number(static_cast<int>(std::bit_width(fingers)), walk.back());
  give_number(std::countr_zero(fingers) + 1, walk[begin]);
}

void Grammar::append_tokens(const Thing& thing, Walk& walk) const {
  const Node& node = nodes_[thing.sort];
  Digits digits(thing.index);
  if (node.form == Form::kinds) append_kind(thing.sort, digits, walk);
  if (node.form == Form::row) append_row(node, digits, thing.fingers, walk);
  if (node.form == Form::ring) append_ring(node, digits, thing.fingers, walk);
}

}  // namespace reeve::search
