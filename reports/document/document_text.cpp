#include <algorithm>

#include "reports/document/text_table.hpp"
#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

// Wraps a line. Indented text, or an entry of a list, continues below its own beginning.
std::string line_text(const std::string& line, Tint tint, const TextStyle& look) {
  if (look.width == 0) return inked(line, tint, look) + '\n';
  std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  if (line.compare(indent, 2, "- ") == 0) indent += 2;
  if (2 * indent > look.width) indent = 0;
  std::string text;
  for (const std::string& piece : wrap_words(line.substr(indent), look.width - indent)) {
    const std::string start = text.empty() ? line.substr(0, indent) : std::string(indent, ' ');
    text += inked(start + piece, tint, look) + '\n';
  }
  return text;
}

// Titles are broken where they are written so, unless the window breaks them elsewhere.
std::string title_text(std::string title, const TextStyle& look) {
  if (look.width > 0) std::ranges::replace(title, '\n', ' ');
  std::vector<DocumentLine> lines;
  add_lines(lines, title);
  std::string text;
  for (const DocumentLine& line : lines) text += line_text(line.text, Tint::strong, look);
  return text;
}

std::string section_text(const Section& section, const TextStyle& look) {
  std::string result = title_text(section.title, look);
  if (section.table) result += text(*section.table, look);
  for (const DocumentLine& line : section.lines) {
    result += line_text(line.text, line.caveat ? Tint::notable : Tint::none, look);
  }
  return result;
}

}  // namespace

std::string text(const Document& document, const TextStyle& look) {
  std::string text;
  for (const Section& section : document.sections) {
    text += (text.empty() ? "" : "\n") + section_text(section, look);
  }
  return text;
}

}  // namespace reeve::reports
