// Numbers of tendon shapes that begin with the same walk, in each class of parts.
//
// An open walk of N tokens is canonical if it does not come after its reverse. Let a beginning have
// q >= N/2 tokens. Of the N − q others, read from the end of the walk, the first that differs from
// the token at its place from the front decides. If none differs, the tokens between decide, which
// belong to the beginning.
#pragma once

#include <cstddef>
#include <vector>

#include "core/routing.hpp"
#include "search/enumerate/parts.hpp"
#include "search/limits/class_counts.hpp"

namespace reeve::search {

class BeginningCounts {
 public:
  // Keeps the classes, which have to outlive it. No tip is anchored, no join beside an end.
  BeginningCounts(const PartClasses& classes, const PartSet& parts, int fingers);

  // Counts the shapes that begin with the first `tokens` of an open canonical walk: its end, and
  // half of its fingers or more, each with the join behind it.
  const ClassCounts& count(const Walk& walk, std::size_t tokens);

 private:
  const std::vector<Token>& kinds_at(std::size_t from_end) const;
  bool middle_is_canonical(const Walk& walk, std::size_t tokens) const;

  const PartClasses& classes_;
  std::vector<Token> ends_;
  std::vector<Token> tips_;
  std::vector<Token> joins_;
  // Numbers of ways for so many tokens, the first of them a tip or a join.
  std::vector<ClassCounts> from_tip_;
  std::vector<ClassCounts> from_join_;
  ClassCounts counts_;
};

}  // namespace reeve::search
