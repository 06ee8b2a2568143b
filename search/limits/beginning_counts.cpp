#include "search/limits/beginning_counts.hpp"

#include "core/walk_image.hpp"

namespace reeve::search {
namespace {

ClassCounts counts_of(const PartClasses& classes, const std::vector<Token>& kinds) {
  ClassCounts counts = no_counts(classes);
  for (const Token& kind : kinds) ++counts[classes.of(kind)];
  return counts;
}

}  // namespace

BeginningCounts::BeginningCounts(const PartClasses& classes, const PartSet& parts, int fingers)
    : classes_(classes) {
  for (const TokenKind kind : parts.ends) ends_.push_back(plain(kind));
  for (const TipKind tip : parts.tips) tips_.push_back(finger(0, tip));
  for (const TokenKind kind : parts.joins) joins_.push_back(plain(kind));
  const ClassCounts tips = counts_of(classes, tips_);
  const ClassCounts joins = counts_of(classes, joins_);
  ClassCounts nothing = no_counts(classes);
  nothing[PartClasses::none] = 1;
  from_tip_.push_back(nothing);
  from_join_.push_back(nothing);
  for (int many = 1; many <= 2 * fingers; ++many) {
    const ClassCounts behind_tip = from_join_.back();
    from_join_.push_back(product(classes, joins, from_tip_.back()));
    from_tip_.push_back(product(classes, tips, behind_tip));
  }
}

const std::vector<Token>& BeginningCounts::kinds_at(std::size_t from_end) const {
  if (from_end == 0) return ends_;
  return from_end % 2 == 1 ? tips_ : joins_;
}

bool BeginningCounts::middle_is_canonical(const Walk& walk, std::size_t tokens) const {
  for (std::size_t front = walk.size() - tokens, back = tokens - 1; front < back; ++front, --back) {
    const auto order = core::compare_shapes(walk[front], walk[back]);
    if (order != 0) return order < 0;
  }
  return true;
}

const ClassCounts& BeginningCounts::count(const Walk& walk, std::size_t tokens) {
  counts_ = no_counts(classes_);
  PartClass alike = PartClasses::none;
  for (std::size_t i = 0; i < tokens; ++i) alike = classes_.plus(alike, classes_.of(walk[i]));
  const std::size_t others = walk.size() - tokens;
  for (std::size_t i = 0; i < others; ++i) {
    const ClassCounts& behind = (i % 2 == 0 ? from_tip_ : from_join_)[others - i - 1];
    for (const Token& kind : kinds_at(i)) {
      if (core::compare_shapes(kind, walk[i]) <= 0) continue;
      add(counts_, shifted(classes_, behind, classes_.plus(alike, classes_.of(kind))));
    }
    alike = classes_.plus(alike, classes_.of(walk[i]));
  }
  if (middle_is_canonical(walk, tokens)) ++counts_[alike];
  counts_ = of_trees(classes_, counts_);
  return counts_;
}

}  // namespace reeve::search
