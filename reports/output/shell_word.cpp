#include "reports/output/shell_word.hpp"

#include <algorithm>
#include <string_view>

namespace reeve::reports {
namespace {

// True if no shell gives the character a meaning, wherever it stands in a word. '~' and '#' can
// have one.
bool is_plain(char c) {
  constexpr std::string_view marks = "_-+./,:@%=";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         marks.find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_word(const std::string& text) {
  // At its beginning '=' asks some shells for the path of a command.
  const bool plain = !text.empty() && text.front() != '=' && std::ranges::all_of(text, is_plain);
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

}  // namespace reeve::reports
