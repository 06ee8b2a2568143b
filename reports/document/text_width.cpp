#include "reports/document/text_width.hpp"

#include <algorithm>

namespace reeve::reports {
namespace {

bool continues_a_code_point(char c) { return (c & '\xC0') == '\x80'; }

// Bytes of the first `width` code points.
std::size_t bytes_of(const std::string& text, std::size_t width) {
  std::size_t at = 0;
  for (std::size_t points = 0; at < text.size(); ++at) {
    if (!continues_a_code_point(text[at]) && points++ == width) break;
  }
  return at;
}

// Returns the position at which a word that is too long for a line breaks.
std::size_t break_of(const std::string& word, std::size_t width) {
  const std::size_t most = bytes_of(word, width);
  const std::size_t joint = word.substr(0, most).find_last_of("-+_");
  return joint == std::string::npos || joint == 0 ? most : joint + 1;
}

class WrappedLines {
 public:
  explicit WrappedLines(std::size_t width) : width_(width) {}

  void add(std::string word) {
    const std::size_t used = text_width(lines_.back());
    if (used > 0 && used + 1 + text_width(word) <= width_) {
      lines_.back() += ' ' + word;
      return;
    }
    if (used > 0) lines_.emplace_back();
    while (text_width(word) > width_) {
      const std::size_t at = break_of(word, width_);
      lines_.back() = word.substr(0, at);
      lines_.emplace_back();
      word.erase(0, at);
    }
    lines_.back() = word;
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::size_t width_;
  std::vector<std::string> lines_{""};
};

}  // namespace

std::size_t text_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return !continues_a_code_point(c); }));
}

std::string padded(const std::string& text, std::size_t width, bool is_text) {
  const std::size_t used = text_width(text);
  const std::string padding(width > used ? width - used : 0, ' ');
  return is_text ? text + padding : padding + text;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

std::vector<std::string> wrap_words(const std::string& text, std::size_t width) {
  if (width == 0 || text_width(text) <= width) return {text};
  WrappedLines lines(width);
  for (const std::string& word : words_of(text)) lines.add(word);
  return lines.take();
}

}  // namespace reeve::reports
