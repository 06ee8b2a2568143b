#include "readings/words.hpp"

#include <fmt/format.h>

#include <cctype>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::readings {

NameWords words_of(std::string_view name) {
  NameWords result;
  name = trimmed(name);
  if (name.ends_with(']') || name.ends_with(')')) {
    const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
    if (open != std::string_view::npos) {
      result.bracketed = trimmed(name.substr(open + 1, name.size() - open - 2));
      name = name.substr(0, open);
    }
  }
  bool in_word = false;
  for (const char c : lower(name)) {
    const bool parts = c == ' ' || c == '_' || c == '-' || c == '.' || c == '\t';
    if (!parts && !in_word) result.words.emplace_back();
    if (!parts) result.words.back() += c;
    in_word = !parts;
  }
  return result;
}

std::string joined(const NameWords& name, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += name.words[i];
  return text;
}

std::string_view without_brackets(std::string_view text) {
  text = trimmed(text);
  const bool bracketed = (text.starts_with('[') && text.ends_with(']')) ||
                         (text.starts_with('(') && text.ends_with(')'));
  return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

void require_short_name(std::string_view name) {
  if (name.size() <= longest_name) return;
  throw InputError({.expected = fmt::format("a name of at most {} bytes, and it has {}",
                                            longest_name, name.size())});
}

}  // namespace reeve::readings
