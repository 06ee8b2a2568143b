#include "search/enumerate/tree_grammar.hpp"

#include <utility>

namespace reeve::search {
namespace {

using Kinds = std::vector<Grammar::Kind>;

Kinds tip_kinds(const PartSet& parts) {
  Kinds kinds;
  for (const TipKind tip : parts.tips) kinds.push_back({finger(0, tip)});
  return kinds;
}

Kinds plain_kinds(const std::vector<TokenKind>& of) {
  Kinds kinds;
  for (const TokenKind kind : of) kinds.push_back({plain(kind)});
  return kinds;
}

Kinds nothing_or(Kinds kinds) {
  kinds.insert(kinds.begin(), Grammar::Kind{});
  return kinds;
}

Kinds join_kinds(const PartSet& parts) { return plain_kinds(parts.joins); }

// A bead is nothing, or a join.
Kinds bead_kinds(const PartSet& parts) { return nothing_or(join_kinds(parts)); }

Kinds beside_kinds(const PartSet& parts) { return nothing_or(plain_kinds(parts.beside)); }

// Kinds of what may stand between two tails.
Kinds kinds_between_tails(const PartSet& parts) {
  const Kinds joins = plain_kinds(parts.beside);
  return parts.linked ? nothing_or(joins) : joins;
}

Kinds end_kinds(const PartSet& parts) {
  Kinds kinds;
  for (const Grammar::Kind& beside : beside_kinds(parts)) {
    for (const TokenKind end : parts.ends) {
      kinds.push_back(beside);
      kinds.back().push_back(plain(end));
    }
  }
  return kinds;
}

// The last finger of a string, with its end or as one.
Kinds last_finger_kinds(const PartSet& parts) {
  Kinds kinds;
  if (parts.anchored) kinds.push_back({anchored_tip(0)});
  for (const Grammar::Kind& beside : beside_kinds(parts)) {
    for (const TipKind tip : parts.tips) {
      for (const TokenKind end : parts.ends) {
        Grammar::Kind& kind = kinds.emplace_back(Grammar::Kind{finger(0, tip)});
        kind.insert(kind.end(), beside.begin(), beside.end());
        kind.push_back(plain(end));
      }
    }
  }
  return kinds;
}

// A tail hangs on the motor by M, or by an end and a join beside it of which one is on a carriage:
// F-Y1 and F-T-Y1 would be a pulley that is fixed.
Kinds hanging_kinds(const PartSet& parts) {
  Kinds kinds;
  for (const TokenKind end : parts.ends) {
    if (end == TokenKind::motor_end) kinds.push_back({plain(end)});
  }
  for (const TokenKind end : parts.ends) {
    for (const TokenKind beside : parts.beside) {
      if (!is_on_carriage(end) && !is_on_carriage(beside)) continue;
      kinds.push_back({plain(beside), plain(end)});
    }
  }
  return kinds;
}

}  // namespace

TreeGrammar::TreeGrammar(PartPowers powers, int fingers, FingerIdentity identity)
    : powers_(std::move(powers)),
      largest_{fingers, powers_.front().blocks},
      grammar_(identity, powers_.size()),
      nothing_(grammar_.choice({})),
      empty_(grammar_.kinds(Kinds(1))),
      tips_(kinds(tip_kinds)),
      joins_(kinds(join_kinds)),
      ends_(kinds(end_kinds)),
      last_fingers_(kinds(last_finger_kinds)),
      beside_(grammar_.part(Grammar::Form::beside_tail, kinds(beside_kinds))),
      between_tails_(kinds(kinds_between_tails)),
      beads_(kinds(bead_kinds)),
      hanging_(kinds(hanging_kinds)),
      pass_(grammar_.kinds(Kinds{{block(TokenKind::block_pass, 0)}})),
      arms_(grammar_.kinds(Kinds{{bar(0)}})),
      becket_(grammar_.kinds(Kinds{{block(TokenKind::becket, 0)}})) {}

template <typename KindsOf>
TreeGrammar::Sort TreeGrammar::kinds(KindsOf kinds_of) {
  std::vector<std::uint64_t> sizes;
  for (const PartSet& parts : powers_) sizes.push_back(kinds_of(parts).size());
  return grammar_.kinds(kinds_of(powers_.front()), sizes);
}

template <typename Make>
TreeGrammar::Sort TreeGrammar::known(Name name, int number, TreeSize size, Make make) {
  const auto key = std::tuple(name, number, size);
  const auto there = known_.find(key);
  if (there != known_.end()) return there->second;
  const Sort made = make();
  known_[key] = made;
  return made;
}

std::vector<TreeGrammar::Sort> TreeGrammar::beads(int m) const {
  std::vector<Sort> beads;
  for (int i = 0; i < m; ++i) {
    if (i > 0) beads.push_back(joins_);
    beads.push_back(tips_);
  }
  return beads;
}

TreeGrammar::Sort TreeGrammar::string(int m) {
  return known(Name::string, m, {}, [&] { return grammar_.row(beads(m)); });
}

TreeGrammar::Sort TreeGrammar::to_end(int m) {
  return known(Name::to_end, m, {}, [&] {
    std::vector<Sort> beads = this->beads(m);
    beads.back() = last_fingers_;
    return grammar_.row(beads);
  });
}

TreeGrammar::Sort TreeGrammar::middle(int m) {
  if (!are_identical()) return string(m);
  return m % 2 == 1 ? tips_ : joins_;
}

// Returns one half, from the bead beside the middle on.
TreeGrammar::Sort TreeGrammar::mirrored_half(int m) {
  if (!are_identical() || m == 1) return empty_;
  return known(Name::mirrored, m, {}, [&] {
    std::vector<Sort> half;
    for (int bead = m - 2; bead >= 0; --bead) half.push_back(bead % 2 == 0 ? tips_ : joins_);
    return grammar_.row(half);
  });
}

TreeGrammar::Sort TreeGrammar::loop(Sort through, int m) {
  const Sort around = are_identical()
                          ? grammar_.both(middle(m), grammar_.multiset(mirrored_half(m), 2))
                          : grammar_.ring(beads(m));
  return grammar_.part(Grammar::Form::loop, grammar_.both(through, around));
}

// Unordered pairs: with identical fingers the lesser size first, with distinct ones that which has
// the least finger.
template <typename Member>
TreeGrammar::Sort TreeGrammar::pairs(TreeSize size, Member member) {
  std::vector<Sort> pairs;
  const auto add = [&](auto two, TreeSize first, TreeSize second) {
    const Sort left = member(first);
    const Sort right = member(second);
    if (grammar_.size(left) > 0 && grammar_.size(right) > 0) pairs.push_back(two(left, right));
  };
  for_each_size(size, [&](TreeSize first) {
    const TreeSize second = size - first;
    if (!are_identical()) {
      if (first.fingers == 0) return;
      add([&](Sort a, Sort b) { return grammar_.labelled(a, b); }, first, second);
    } else if (first == second) {
      pairs.push_back(grammar_.multiset(member(first), 2));
    } else if (first < second) {
      add([&](Sort a, Sort b) { return grammar_.sides(a, b); }, first, second);
    }
  });
  return grammar_.choice(pairs);
}

TreeGrammar::Sort TreeGrammar::tail(TreeSize size) {
  return known(Name::tail, 0, size,
               [&] { return grammar_.part(Grammar::Form::tail, branch(size)); });
}

TreeGrammar::Sort TreeGrammar::tailed(TreeSize size) { return grammar_.both(beside_, tail(size)); }

std::vector<TreeGrammar::Sort> TreeGrammar::strings_to_tail(TreeSize size) {
  std::vector<Sort> sorts;
  for (int m = 1; m < size.fingers; ++m) {
    sorts.push_back(grammar_.both(string(m), tail(size - TreeSize{m, 0})));
  }
  return sorts;
}

TreeGrammar::Sort TreeGrammar::half(TreeSize size) {
  if (size == TreeSize{}) return ends_;
  if (size.blocks == 0) return to_end(size.fingers);
  return known(Name::half, 0, size, [&] {
    std::vector<Sort> sorts = strings_to_tail(size);
    sorts.insert(sorts.begin(), tail(size));
    return grammar_.both(beside_, grammar_.choice(sorts));
  });
}

TreeGrammar::Sort TreeGrammar::side(TreeSize size) {
  if (!parts().beckets || size.blocks > 0 || size.fingers == 0) return half(size);
  return known(Name::side, 0, size, [&] {
    return grammar_.choice({half(size), grammar_.both(string(size.fingers), becket_)});
  });
}

template <typename Member>
TreeGrammar::Sort TreeGrammar::once_passed(Sort through, TreeSize size, Member member) {
  std::vector<Sort> sorts;
  if (size.blocks == 1) sorts.push_back(loop(through, size.fingers));
  sorts.push_back(grammar_.both(through, pairs(size - TreeSize{0, 1}, member)));
  return grammar_.choice(sorts);
}

TreeGrammar::Sort TreeGrammar::double_pass(int m, TreeSize of_sides) {
  return grammar_.both(middle(m), pairs(of_sides, [&](TreeSize one) {
                         return known(Name::passed_again, m, one, [&] {
                           return grammar_.both(mirrored_half(m), grammar_.both(pass_, side(one)));
                         });
                       }));
}

TreeGrammar::Sort TreeGrammar::pulley(TreeSize size) {
  std::vector<Sort> sorts;
  for (int m = 1; parts().double_passes && m < size.fingers; ++m) {
    sorts.push_back(double_pass(m, size - TreeSize{m, 1}));
  }
  sorts.push_back(once_passed(pass_, size, [&](TreeSize one) { return side(one); }));
  return grammar_.part(Grammar::Form::hung, grammar_.choice(sorts),
                       block(TokenKind::block_tail, 0));
}

TreeGrammar::Sort TreeGrammar::branch(TreeSize size) {
  if (size.fingers == 0 || size.blocks == 0) return nothing_;
  return known(Name::branch, 0, size, [&] {
    if (!parts().bars) return pulley(size);
    const Sort bars = once_passed(arms_, size, [&](TreeSize one) { return half(one); });
    return grammar_.choice(
        {pulley(size), grammar_.part(Grammar::Form::hung, bars, block(TokenKind::bar_pivot, 0))});
  });
}

TreeGrammar::Sort TreeGrammar::riser(TreeSize size) {
  if (size.fingers == 0) return nothing_;
  return known(Name::riser, 0, size, [&] {
    const bool is_half = size.blocks == 0 || parts().linked;
    return grammar_.part(Grammar::Form::riser,
                         is_half ? half(size) : grammar_.choice(strings_to_tail(size)),
                         block(TokenKind::block_tail, 0));
  });
}

// A pass with its riser, and the others.
template <typename Others>
TreeGrammar::Sort TreeGrammar::beside_risers(TreeSize size, Others others) {
  const TreeSize whole = size - TreeSize{0, 1};
  std::vector<Sort> sorts;
  for_each_size(whole, [&](TreeSize first) {
    const Sort passed = riser(first);
    if (grammar_.size(passed) == 0) return;
    sorts.push_back(grammar_.both(passed, others(whole - first)));
  });
  return grammar_.choice(sorts);
}

TreeGrammar::Sort TreeGrammar::arm(int passes, TreeSize size) {
  if (passes == 0) return half(size);
  if (size.blocks < passes || size.fingers == 0) return nothing_;
  return known(Name::arm, passes, size, [&] {
    return beside_risers(size, [&](TreeSize rest) { return beaded_arm(passes - 1, rest); });
  });
}

TreeGrammar::Sort TreeGrammar::beaded_arm(int passes, TreeSize size) {
  return passes == 0 ? half(size) : grammar_.both(beads_, arm(passes, size));
}

TreeGrammar::Sort TreeGrammar::in_series(int passes, TreeSize size) {
  if (passes % 2 == 0) {
    return grammar_.both(beads_, pairs(size, [&](TreeSize one) { return arm(passes / 2, one); }));
  }
  return beside_risers(size, [&](TreeSize rest) {
    return pairs(rest, [&](TreeSize one) { return beaded_arm(passes / 2, one); });
  });
}

TreeGrammar::Sort TreeGrammar::two_tailed(int m, TreeSize below) {
  if (m == 0) {
    return grammar_.both(between_tails_, pairs(below, [&](TreeSize one) { return tail(one); }));
  }
  return grammar_.both(middle(m), pairs(below, [&](TreeSize one) {
                         return known(Name::mirrored_tail, m, one, [&] {
                           return grammar_.both(beside_,
                                                grammar_.both(mirrored_half(m), tail(one)));
                         });
                       }));
}

TreeGrammar::Sort TreeGrammar::tree(TreeSize size) {
  return known(Name::tree, 0, size, [&] {
    std::vector<Sort> sorts{grammar_.sides(tail(size), hanging_)};
    for (int m = 0; m < size.fingers; ++m) {
      const TreeSize below{size.fingers - m, size.blocks};
      if (m > 0) sorts.push_back(grammar_.sides(to_end(m), tailed(below)));
      sorts.push_back(two_tailed(m, below));
    }
    for (int passes = 2; parts().series && passes <= size.blocks; ++passes) {
      sorts.push_back(in_series(passes, size));
    }
    return grammar_.part(Grammar::Form::tree, grammar_.choice(sorts));
  });
}

TreeGrammar::Sort TreeGrammar::sets(TreeSize size) {
  if (sizes_.empty()) {
    for_each_size(largest_, [&](TreeSize each) {
      if (each.blocks > 0 && grammar_.size(tree(each)) > 0) sizes_.push_back(each);
    });
  }
  return are_identical() ? multisets_from(0, size) : labelled_sets(size);
}

TreeGrammar::Sort TreeGrammar::multisets_from(std::size_t first, TreeSize size) {
  if (size == TreeSize{}) return empty_;
  if (first == sizes_.size()) return nothing_;
  return known(Name::sets, static_cast<int>(first), size, [&] {
    std::vector<Sort> by_many{multisets_from(first + 1, size)};
    for (int many = 1; is_within(many * sizes_[first], size); ++many) {
      by_many.push_back(grammar_.both(grammar_.multiset(tree(sizes_[first]), many),
                                      multisets_from(first + 1, size - many * sizes_[first])));
    }
    return grammar_.choice(by_many);
  });
}

TreeGrammar::Sort TreeGrammar::labelled_sets(TreeSize size) {
  if (size == TreeSize{}) return empty_;
  return known(Name::sets, 0, size, [&] {
    std::vector<Sort> by_first;
    for (const TreeSize& first : sizes_) {
      if (!is_within(first, size)) continue;
      by_first.push_back(grammar_.labelled(tree(first), labelled_sets(size - first)));
    }
    return grammar_.choice(by_first);
  });
}

}  // namespace reeve::search
