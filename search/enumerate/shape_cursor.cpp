#include "search/enumerate/shape_cursor.hpp"

#include <algorithm>

#include "core/canonical.hpp"

namespace reeve::search {
namespace {

// The next token of the same sort that the parts allow; false, and the first one, behind the last.
bool next_token(const PartSet& parts, Token& token) {
  if (token.kind == TokenKind::anchored_tip) return false;
  if (token.kind == TokenKind::finger) {
    auto tip = std::find(parts.tips.begin(), parts.tips.end(), token.tip) + 1;
    const bool more = tip != parts.tips.end();
    token.tip = more ? *tip : parts.tips.front();
    return more;
  }
  const std::vector<TokenKind>& kinds = is_end(token.kind) ? parts.ends : parts.joins;
  auto kind = std::find(kinds.begin(), kinds.end(), token.kind) + 1;
  const bool more = kind != kinds.end();
  token.kind = more ? *kind : kinds.front();
  return more;
}

}  // namespace

bool ShapeCursor::start_open(const PartSet& parts, const Token& first) {
  const bool from_tip = first.kind == TokenKind::anchored_tip;
  if (from_tip && fingers_ == 1) return false;  // 1x-M is M-1x
  if (parts.ends.empty() && !parts.anchored) return false;
  if (fingers_ > 1 && parts.joins.empty()) return false;
  shape_.closed = false;
  shape_.walk.assign(1, first);
  for (int f = from_tip ? 1 : 0; f < fingers_; ++f) {
    if (f > 0) shape_.walk.push_back(plain(parts.joins.front()));
    shape_.walk.push_back(finger(0, parts.tips.front()));
  }
  if (parts.anchored) {
    shape_.walk.back() = anchored_tip(0);
  } else {
    shape_.walk.push_back(plain(parts.ends.front()));
  }
  return true;
}

bool ShapeCursor::start_closed(const PartSet& parts) {
  if (parts.joins.empty()) return false;
  shape_.closed = true;
  shape_.walk.clear();
  for (int f = 0; f < fingers_; ++f) {
    shape_.walk.push_back(finger(0, parts.tips.front()));
    shape_.walk.push_back(plain(parts.joins.front()));
  }
  return true;
}

bool ShapeCursor::start_walk(const PartSet& parts) {
  if (!parts.ends.empty() && start_open(parts, plain(parts.ends.front()))) return true;
  if (parts.anchored && start_open(parts, anchored_tip(0))) return true;
  return start_closed(parts);
}

// Ends, then anchored tips, then loops: each with walks of another length.
bool ShapeCursor::next_family(const PartSet& parts) {
  if (shape_.closed) return false;
  const bool from_end = shape_.walk.front().kind != TokenKind::anchored_tip;
  if (from_end && parts.anchored && start_open(parts, anchored_tip(0))) return true;
  return start_closed(parts);
}

bool ShapeCursor::next_walk(const PartSet& parts) {
  std::size_t i = shape_.walk.size();
  const bool may_anchor = parts.anchored && !shape_.closed;
  if (may_anchor && shape_.walk.back().kind == TokenKind::anchored_tip) {
    --i;
    if (!parts.ends.empty()) {
      shape_.walk.back() = finger(0, parts.tips.front());
      shape_.walk.push_back(plain(parts.ends.front()));
      return true;
    }
  }
  while (i-- > 0) {
    if (next_token(parts, shape_.walk[i])) return true;
    if (may_anchor && i + 2 == shape_.walk.size() && !is_of_finger(shape_.walk.back().kind)) {
      shape_.walk.pop_back();
      shape_.walk.back() = anchored_tip(0);
    }
  }
  return next_family(parts);
}

bool ShapeCursor::settle(const PartSet& parts) {
  while (!is_canonical(shape_)) {
    if (!next_walk(parts)) return false;
  }
  return true;
}

bool ShapeCursor::start(const PartSet& parts, int fingers) {
  fingers_ = fingers;
  index_ = 0;
  return start_walk(parts) && settle(parts);
}

bool ShapeCursor::next(const PartSet& parts) {
  ++index_;
  return next_walk(parts) && settle(parts);
}

}  // namespace reeve::search
