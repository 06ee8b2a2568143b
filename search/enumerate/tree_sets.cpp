#include "search/enumerate/tree_sets.hpp"

namespace reeve::search {
namespace {

constexpr TreeSize none{};

TreeSize operator*(int many, const TreeSize& size) {
  return {many * size.fingers, many * size.blocks};
}

bool fit(int many, const TreeSize& size, const TreeSize& into) {
  return many * size.fingers <= into.fingers && many * size.blocks <= into.blocks;
}

}  // namespace

TreeSets::TreeSets(const SizeTable& trees, FingerIdentity identity)
    : trees_(trees), identity_(identity) {
  for_each_size(trees.largest(), [&](TreeSize size) {
    if (trees[size] > 0) sizes_.push_back(size);
  });
  sets_.assign(identity == FingerIdentity::identical ? sizes_.size() + 1 : 1,
               SizeTable(trees.largest()));
  sets_.back()[none] = 1;
  if (identity == FingerIdentity::identical) {
    count_multisets();
  } else {
    count_labelled();
  }
}

void TreeSets::count_multisets() {
  for (std::size_t i = sizes_.size(); i-- > 0;) {
    for_each_size(trees_.largest(), [&](TreeSize size) {
      for (int many = 0; fit(many, sizes_[i], size); ++many) {
        const std::uint64_t of_size =
            multichoose(trees_[sizes_[i]], static_cast<std::uint64_t>(many));
        const std::uint64_t others = sets_[i + 1][size - many * sizes_[i]];
        sets_[i][size] = plus(sets_[i][size], times(of_size, others));
      }
    });
  }
}

std::uint64_t TreeSets::with_first(TreeSize first, TreeSize size) const {
  const std::uint64_t others = choices_of(first.fingers - 1, size.fingers - 1, identity_);
  return times(times(others, trees_[first]), sets_.front()[size - first]);
}

void TreeSets::count_labelled() {
  for_each_size(trees_.largest(), [&](TreeSize size) {
    for (const TreeSize& first : sizes_) {
      if (!fit(1, first, size)) continue;
      sets_.front()[size] = plus(sets_.front()[size], with_first(first, size));
    }
  });
}

std::uint64_t TreeSets::count(TreeSize size) const { return sets_.front()[size]; }

void TreeSets::decode(TreeSize size, std::uint64_t index, FingerSet fingers,
                      std::vector<TreeIndex>& set) const {
  set.clear();
  Digits digits(index);
  if (identity_ == FingerIdentity::identical) {
    decode_multiset(size, digits, set);
  } else {
    decode_labelled(size, digits, fingers, set);
  }
}

void TreeSets::decode_multiset(TreeSize size, Digits& digits, std::vector<TreeIndex>& set) const {
  for (std::size_t i = 0; size != none; ++i) {
    const std::uint64_t trees = trees_[sizes_[i]];
    std::uint64_t many = 0;
    const auto with_many = [&] {
      const TreeSize others = size - static_cast<int>(many) * sizes_[i];
      return multichoose(trees, many) * sets_[i + 1][others];
    };
    while (!digits.is_among(with_many())) ++many;
    if (many == 0) continue;
    std::uint64_t index = digits.take(multichoose(trees, many));
    for (; many > 0; --many) {
      set.push_back({sizes_[i], greatest_of_multiset(trees, many, index)});
      size = size - sizes_[i];
    }
  }
}

void TreeSets::decode_labelled(TreeSize size, Digits& digits, FingerSet fingers,
                               std::vector<TreeIndex>& set) const {
  while (size != none) {
    std::size_t i = 0;
    while (!fit(1, sizes_[i], size) || !digits.is_among(with_first(sizes_[i], size))) ++i;
    const TreeSize first = sizes_[i];
    const FingerSet own = take_least_and(fingers, first.fingers - 1, digits, identity_);
    set.push_back({first, digits.take(trees_[first]), own});
    size = size - first;
  }
}

}  // namespace reeve::search
