#include "search/limits/tree_parts.hpp"

namespace reeve::search {
namespace {

TreeSize of_many(int many, TreeSize size) { return {many * size.fingers, many * size.blocks}; }

bool is_within(TreeSize size, TreeSize whole) {
  return size.fingers <= whole.fingers && size.blocks <= whole.blocks;
}

}  // namespace

TreeParts::TreeParts(const PartClasses& classes, const PartSet& parts, int fingers)
    : classes_(classes), parts_(parts), numbered_(classes) {
  nothing_ = numbered_.kinds({});
  empty_ = numbered_.kinds({PartClasses::none});
  for_each_size({fingers, parts.blocks}, [&](TreeSize size) {
    if (size.blocks > 0 && numbered_.size(tree(size)) > 0) sizes_.push_back(size);
  });
}

template <typename Make>
TreeParts::Sort TreeParts::known(Sizes& sizes, int first, int second, Make make) {
  const auto there = sizes.find({first, second});
  if (there != sizes.end()) return there->second;
  const Sort made = make();
  sizes[{first, second}] = made;
  return made;
}

TreeParts::Sort TreeParts::tips() {
  std::vector<PartClass> kinds;
  for (const TipKind tip : parts_.tips) kinds.push_back(classes_.of(finger(0, tip)));
  return numbered_.kinds(std::move(kinds));
}

TreeParts::Sort TreeParts::joins() {
  std::vector<PartClass> kinds;
  for (const TokenKind join : parts_.joins) kinds.push_back(classes_.of(plain(join)));
  return numbered_.kinds(std::move(kinds));
}

TreeParts::Sort TreeParts::ends() {
  std::vector<PartClass> kinds;
  for (const TokenKind end : parts_.ends) kinds.push_back(classes_.of(plain(end)));
  return numbered_.kinds(std::move(kinds));
}

TreeParts::Sort TreeParts::string(int m) {
  return known(strings_, m, 0, [&] {
    std::vector<Sort> beads{empty_};
    for (int i = 0; i < m; ++i) {
      if (i > 0) beads.push_back(joins());
      beads.push_back(tips());
    }
    return numbered_.all_of(beads);
  });
}

TreeParts::Sort TreeParts::to_end(int m) {
  return known(to_ends_, m, 0, [&] {
    std::vector<PartClass> last;
    if (parts_.anchored) last.push_back(classes_.of(anchored_tip(0)));
    for (const TipKind tip : parts_.tips) {
      for (const TokenKind end : parts_.ends) {
        last.push_back(classes_.plus(classes_.of(finger(0, tip)), classes_.of(plain(end))));
      }
    }
    std::vector<Sort> beads{string(m - 1)};
    if (m > 1) beads.push_back(joins());
    beads.push_back(numbered_.kinds(std::move(last)));
    return numbered_.all_of(beads);
  });
}

TreeParts::Sort TreeParts::middle(int m) {
  if (m == 0) return parts_.linked ? empty_ : nothing_;
  return m % 2 == 1 ? tips() : joins();
}

TreeParts::Sort TreeParts::mirrored_half(int m) {
  return known(mirrored_, m, 0, [&] {
    std::vector<Sort> beads{empty_};
    for (int bead = m - 2; bead >= 0; --bead) beads.push_back(bead % 2 == 0 ? tips() : joins());
    return numbered_.all_of(beads);
  });
}

TreeParts::Sort TreeParts::loop_through_pass(int m) {
  return numbered_.with(numbered_.both(middle(m), numbered_.multisets(mirrored_half(m), 2)),
                        classes_.of_loop());
}

// Unordered pairs of members: of one size, or the lesser size first.
template <typename Member>
void TreeParts::append_pairs(TreeSize size, Member member, std::vector<Sort>& pairs) {
  SizePair split{{}, size};
  do {
    const auto [first, second] = split;
    const bool is_lesser = first.fingers != second.fingers ? first.fingers < second.fingers
                                                           : first.blocks < second.blocks;
    if (first == second) {
      pairs.push_back(numbered_.multisets(member(first), 2));
    } else if (is_lesser) {
      pairs.push_back(numbered_.both(member(first), member(second)));
    }
  } while (next_pair(split));
}

TreeParts::Sort TreeParts::half(TreeSize size) {
  return known(halves_, size.fingers, size.blocks, [&] {
    if (size == TreeSize{}) return ends();
    if (size.blocks == 0) return to_end(size.fingers);
    return numbered_.one_after_the_other({branch(size), tailed_half(size)});
  });
}

TreeParts::Sort TreeParts::tailed_half(TreeSize size) {
  std::vector<Sort> sorts;
  for (int m = 1; m < size.fingers; ++m) {
    sorts.push_back(numbered_.both(string(m), branch(size - TreeSize{m, 0})));
  }
  return numbered_.one_after_the_other(sorts);
}

TreeParts::Sort TreeParts::branch(TreeSize size) {
  return known(branches_, size.fingers, size.blocks, [&] {
    if (size.fingers == 0 || size.blocks == 0) return nothing_;
    const auto once_passed = [&](auto of_one_side) {
      std::vector<Sort> sorts;
      if (size.blocks == 1) sorts.push_back(loop_through_pass(size.fingers));
      append_pairs(size - TreeSize{0, 1}, of_one_side, sorts);
      return numbered_.one_after_the_other(sorts);
    };
    const auto with_tail = [&](Sort sort, TokenKind kind) {
      return numbered_.with(sort, classes_.of(block(kind, 0)));
    };
    const Sort once = once_passed([&](TreeSize member) { return side(member); });
    const Sort pulleys =
        with_tail(numbered_.one_after_the_other({double_pass(size), once}), TokenKind::block_tail);
    if (!parts_.bars) return pulleys;
    const Sort arms = once_passed([&](TreeSize member) { return half(member); });
    return numbered_.one_after_the_other({pulleys, with_tail(arms, TokenKind::bar_pivot)});
  });
}

TreeParts::Sort TreeParts::side(TreeSize size) {
  if (!parts_.beckets || size.blocks > 0 || size.fingers == 0) return half(size);
  return known(sides_, size.fingers, size.blocks, [&] {
    return numbered_.one_after_the_other({half(size), string(size.fingers)});
  });
}

TreeParts::Sort TreeParts::double_pass(TreeSize of_branch) {
  std::vector<Sort> sorts;
  for (int m = 1; parts_.double_passes && m < of_branch.fingers; ++m) {
    sorts.push_back(
        about_string(m, of_branch - TreeSize{m, 1}, [&](TreeSize member) { return side(member); }));
  }
  return numbered_.one_after_the_other(sorts);
}

// Pairs of members about a string of m fingers.
template <typename Member>
TreeParts::Sort TreeParts::about_string(int m, TreeSize size, Member member) {
  if (numbered_.size(middle(m)) == 0) return nothing_;
  std::vector<Sort> pairs;
  append_pairs(
      size, [&](TreeSize one) { return numbered_.both(mirrored_half(m), member(one)); }, pairs);
  return numbered_.both(middle(m), numbered_.one_after_the_other(pairs));
}

TreeParts::Sort TreeParts::beads_before(int passes) {
  return passes > 0 ? numbered_.one_after_the_other({empty_, joins()}) : empty_;
}

TreeParts::Sort TreeParts::riser(TreeSize size) {
  if (size.fingers == 0) return nothing_;
  if (size.blocks == 0 || parts_.linked) return half(size);
  return known(risers_, size.fingers, size.blocks, [&] { return tailed_half(size); });
}

template <typename Others>
TreeParts::Sort TreeParts::beside_risers(TreeSize size, Others others) {
  std::vector<Sort> sorts;
  SizePair split{{}, size - TreeSize{0, 1}};
  do {
    const Sort first = riser(split.first);
    if (numbered_.size(first) == 0) continue;
    sorts.push_back(numbered_.both(first, others(split.second)));
  } while (next_pair(split));
  return numbered_.with(numbered_.one_after_the_other(sorts),
                        classes_.of(block(TokenKind::block_tail, 0)));
}

TreeParts::Sort TreeParts::arm(int passes, TreeSize size) {
  if (passes == 0) return half(size);
  if (size.blocks < passes) return nothing_;
  return known(arms_[passes], size.fingers, size.blocks, [&] {
    return beside_risers(size, [&](TreeSize rest) { return beaded(passes - 1, rest); });
  });
}

TreeParts::Sort TreeParts::beaded(int passes, TreeSize size) {
  return numbered_.both(beads_before(passes), arm(passes, size));
}

TreeParts::Sort TreeParts::in_series(int passes, TreeSize size) {
  const auto pairs_of = [&](auto member, TreeSize of) {
    std::vector<Sort> pairs;
    append_pairs(of, member, pairs);
    return numbered_.one_after_the_other(pairs);
  };
  if (passes % 2 == 0) {
    const auto member = [&](TreeSize of) { return arm(passes / 2, of); };
    return numbered_.both(beads_before(passes), pairs_of(member, size));
  }
  const auto member = [&](TreeSize of) { return beaded(passes / 2, of); };
  return beside_risers(size, [&](TreeSize rest) { return pairs_of(member, rest); });
}

TreeParts::Sort TreeParts::tree(TreeSize size) {
  return known(trees_, size.fingers, size.blocks, [&] {
    std::vector<Sort> sorts;
    if (may_hang_on_motor(parts_)) {
      sorts.push_back(numbered_.with(branch(size), classes_.of(motor_end())));
    }
    for (int m = 0; m < size.fingers; ++m) {
      const TreeSize below{size.fingers - m, size.blocks};
      if (m > 0) sorts.push_back(numbered_.both(to_end(m), branch(below)));
      sorts.push_back(about_string(m, below, [&](TreeSize member) { return branch(member); }));
    }
    for (int passes = 2; parts_.series && passes <= size.blocks; ++passes) {
      sorts.push_back(in_series(passes, size));
    }
    return numbered_.trees(numbered_.one_after_the_other(sorts));
  });
}

TreeParts::Sort TreeParts::sets(TreeSize size) { return sets_from(0, size); }

TreeParts::Sort TreeParts::sets_from(std::size_t first, TreeSize size) {
  if (size == TreeSize{}) return empty_;
  if (first == sizes_.size()) return nothing_;
  const auto key = std::pair(first, std::pair(size.fingers, size.blocks));
  const auto there = sets_.find(key);
  if (there != sets_.end()) return there->second;
  std::vector<Sort> by_many;
  for (int many = 0; is_within(of_many(many, sizes_[first]), size); ++many) {
    const Sort others = sets_from(first + 1, size - of_many(many, sizes_[first]));
    by_many.push_back(many == 0
                          ? others
                          : numbered_.both(numbered_.multisets(tree(sizes_[first]), many), others));
  }
  return sets_[key] = numbered_.one_after_the_other(by_many);
}

}  // namespace reeve::search
