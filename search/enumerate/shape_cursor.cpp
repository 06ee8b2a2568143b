#include "search/enumerate/shape_cursor.hpp"

#include <algorithm>

#include "core/canonical.hpp"

namespace reeve::search {

// Returns the tokens that may follow the walk so far, in canonical order. An open walk has an end,
// maybe with a join beside it, or an anchored tip. Then come fingers with a join between each two,
// and the other end likewise.
ShapeCursor::Choices ShapeCursor::choices(const PartSet& parts) const {
  Choices choices;
  const auto add_kinds = [&](const std::vector<TokenKind>& kinds) {
    for (const TokenKind kind : kinds) choices.push_back(plain(kind));
  };
  const auto add_tips = [&] {
    for (const TipKind tip : parts.tips) choices.push_back(finger(0, tip));
  };
  const Walk& walk = shape_.walk;
  const bool at_begin = walk.empty();
  const bool behind_finger = !at_begin && is_of_finger(walk.back().kind);
  const bool at_last = passed_ + 1 == fingers_;
  if (shape_.closed) {
    if (behind_finger) {
      add_kinds(parts.joins);
    } else {
      add_tips();
    }
  } else if (at_begin) {
    add_kinds(parts.ends);
    if (parts.anchored && !at_last) choices.push_back(anchored_tip(0));  // 1x-M is M-1x
  } else if (passed_ == fingers_) {
    add_kinds(parts.ends);
    if (behind_finger) add_kinds(parts.beside);
  } else if (behind_finger) {
    add_kinds(parts.joins);
  } else {
    if (parts.anchored && at_last) choices.push_back(anchored_tip(0));
    if (!at_last || !parts.ends.empty()) add_tips();
    if (is_end(walk.back().kind)) add_kinds(parts.beside);
  }
  return choices;
}

bool ShapeCursor::is_whole() const {
  const Walk& walk = shape_.walk;
  if (passed_ < fingers_) return false;
  if (shape_.closed) return !is_of_finger(walk.back().kind);
  return is_end(walk.back().kind);
}

void ShapeCursor::push(const Token& token) {
  shape_.walk.push_back(token);
  if (is_of_finger(token.kind)) ++passed_;
}

void ShapeCursor::pop() {
  if (is_of_finger(shape_.walk.back().kind)) --passed_;
  shape_.walk.pop_back();
}

void ShapeCursor::shorten(std::size_t tokens) {
  while (shape_.walk.size() > tokens) pop();
}

bool ShapeCursor::start_family(const PartSet& parts, bool closed) {
  const bool joined = closed || fingers_ > 1;
  if (joined && parts.joins.empty()) return false;
  if (!closed && parts.ends.empty() && !(parts.anchored && fingers_ > 1)) return false;
  shape_.closed = closed;
  shape_.walk.clear();
  passed_ = 0;
  complete(parts);
  return true;
}

void ShapeCursor::complete(const PartSet& parts) {
  do {
    push(choices(parts).front());
  } while (!is_whole());
}

bool ShapeCursor::next_walk(const PartSet& parts) {
  while (!shape_.walk.empty()) {
    const Token last = shape_.walk.back();
    pop();
    const Choices here = choices(parts);
    const auto next = std::find(here.begin(), here.end(), last) + 1;
    if (next == here.end()) continue;
    push(*next);
    if (!is_whole()) complete(parts);
    return true;
  }
  return !shape_.closed && start_family(parts, true);
}

bool ShapeCursor::settle(const PartSet& parts) {
  while (const std::size_t tokens = uncanonical_tokens(shape_)) {
    shorten(tokens);
    if (!next_walk(parts)) return false;
  }
  return true;
}

bool ShapeCursor::start(const PartSet& parts, int fingers) {
  fingers_ = fingers;
  index_ = 0;
  return (start_family(parts, false) || start_family(parts, true)) && settle(parts);
}

bool ShapeCursor::next(const PartSet& parts) { return next_beyond(parts, shape_.walk.size(), 1); }

bool ShapeCursor::next_beyond(const PartSet& parts, std::size_t tokens, std::uint64_t shapes) {
  shorten(tokens);
  index_ += shapes;
  return next_walk(parts) && settle(parts);
}

}  // namespace reeve::search
