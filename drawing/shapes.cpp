#include "drawing/shapes.hpp"

#include <algorithm>

namespace reeve::drawing {

namespace measures {

double text_width(const std::string& text, double size, bool bold) {
  static const std::string narrow = " .,:;'()-|fijlrt";
  static const std::string wide = "MWmw@%";
  double width = 0;
  for (const char c : text) {
    if ((c & '\xC0') == '\x80') continue;  // the rest of a code point
    const bool is_narrow = narrow.find(c) != std::string::npos;
    const bool is_wide = wide.find(c) != std::string::npos;
    width += is_narrow ? 0.42 : is_wide ? 1 : 0.66;
  }
  return width * size * (bold ? 1.12 : 1);
}

}  // namespace measures

std::vector<std::string> wrap(const std::string& text, double size, bool bold, double width) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find_first_of(" -+", at), text.size() - 1) + 1;
    const std::string piece = text.substr(at, end - at);
    if (!line.empty() && measures::text_width(line + piece, size, bold) > width) {
      lines.push_back(std::move(line));
      line.clear();
    }
    line += piece;
    at = end;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace reeve::drawing
