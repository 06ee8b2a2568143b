#include "core/word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace reeve::core {

std::string shown_text(std::string_view text) {
  std::size_t shown_bytes = std::min<std::size_t>(text.size(), 60);
  // Not in the middle of a UTF-8 sequence.
  while (shown_bytes < text.size() && (text[shown_bytes] & '\xC0') == '\x80') --shown_bytes;
  std::string shown;
  for (const char c : text.substr(0, shown_bytes)) {
    const bool plain = std::isprint(static_cast<unsigned char>(c)) != 0 || (c & '\x80') != 0;
    shown += plain ? c : '?';
  }
  return shown_bytes < text.size() ? shown + "…" : shown;
}

std::string quoted_text(std::string_view text) { return "'" + shown_text(text) + "'"; }

void Word::fail(InputFault fault) const {
  fault.where = fmt::format("routing {}", quoted_text(text));
  throw InputError(std::move(fault));
}

void Word::fail(const PlacedText& at, InputFault fault) const {
  fault.where = fmt::format("routing {}, column {}", quoted_text(text), at.column);
  throw InputError(std::move(fault));
}

}  // namespace reeve::core
