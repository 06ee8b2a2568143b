#include "search/enumerate/shape_cursor.hpp"

#include <algorithm>

#include "core/canonical.hpp"

namespace reeve::search {
namespace {

// The next token of the same sort that the parts allow; false, and the first one, behind the last.
bool next_token(const PartSet& parts, Token& token) {
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

bool ShapeCursor::start_walk(const PartSet& parts, bool closed) {
  shape_.closed = closed;
  shape_.walk.clear();
  if (closed ? parts.joins.empty() : parts.ends.empty()) return false;
  if (fingers_ > 1 && parts.joins.empty()) return false;
  if (!closed) shape_.walk.push_back(plain(parts.ends.front()));
  for (int f = 0; f < fingers_; ++f) {
    if (f > 0) shape_.walk.push_back(plain(parts.joins.front()));
    shape_.walk.push_back(finger(0, parts.tips.front()));
  }
  shape_.walk.push_back(plain(closed ? parts.joins.front() : parts.ends.front()));
  return true;
}

bool ShapeCursor::next_walk(const PartSet& parts) {
  for (std::size_t i = shape_.walk.size(); i-- > 0;) {
    if (next_token(parts, shape_.walk[i])) return true;
  }
  return false;
}

bool ShapeCursor::settle(const PartSet& parts) {
  while (!is_canonical(shape_)) {
    if (!next_walk(parts) && (shape_.closed || !start_walk(parts, true))) return false;
  }
  return true;
}

bool ShapeCursor::start(const PartSet& parts, int fingers) {
  fingers_ = fingers;
  index_ = 0;
  return (start_walk(parts, false) || start_walk(parts, true)) && settle(parts);
}

bool ShapeCursor::next(const PartSet& parts) {
  ++index_;
  if (!next_walk(parts) && (shape_.closed || !start_walk(parts, true))) return false;
  return settle(parts);
}

}  // namespace reeve::search
