#include <algorithm>
#include <cctype>

#include "reports/document/document.hpp"
#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Inside a word, as in uniformity_mean, an underscore is no mark.
bool is_mark(const std::string& text, std::size_t at) {
  if (text[at] != '_') return std::string("\\|`*<[]~").find(text[at]) != std::string::npos;
  return at == 0 || at + 1 == text.size() || !is_word(text[at - 1]) || !is_word(text[at + 1]);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_mark(text, i)) result += '\\';
    result += static_cast<unsigned char>(text[i]) < ' ' ? ' ' : text[i];
  }
  return result;
}

std::string row_text(const std::vector<TableColumn>& columns, const std::vector<std::string>& cells,
                     const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += ' ' + padded(cells[i], widths[i], columns[i].is_text) + " |";
  }
  return line + '\n';
}

std::string table_text(const Table& table) {
  std::vector<std::vector<std::string>> rows(1);
  for (const TableColumn& column : table.columns) {
    rows[0].push_back(escaped(heading_text(column)));
  }
  for (const TableRow& row : table.rows) {
    rows.emplace_back();
    for (const std::string& cell : row.cells) rows.back().push_back(escaped(cell));
  }
  std::vector<std::size_t> widths(table.columns.size(), 3);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], text_width(row[i]));
    }
  }
  std::vector<std::string> rule;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    rule.push_back(std::string(widths[i] - 1, '-') + (table.columns[i].is_text ? '-' : ':'));
  }
  std::string text = row_text(table.columns, rows[0], widths);
  text += row_text(table.columns, rule, widths);
  for (std::size_t i = 1; i < rows.size(); ++i) text += row_text(table.columns, rows[i], widths);
  return text;
}

// Lines under a title are a list; others are paragraphs.
std::string line_text(const DocumentLine& line, bool in_list) {
  const std::size_t begin = std::min(line.text.find_first_not_of(' '), line.text.size());
  const bool entry = line.text.compare(begin, 2, "- ") == 0;
  const std::string text = escaped(line.text.substr(begin + (entry ? 2 : 0)));
  return (in_list || entry ? "- " : "") + (line.caveat ? "**" + text + "**" : text) + '\n';
}

std::string markdown_section(const Section& section) {
  std::string text;
  const auto begin_block = [&] { text += text.empty() ? "" : "\n"; };
  if (!section.title.empty()) text += "**" + escaped(section.title) + "**\n";
  if (section.table) {
    begin_block();
    text += table_text(*section.table);
  }
  const bool in_list = !section.title.empty() && !section.table;
  for (std::size_t i = 0; i < section.lines.size(); ++i) {
    if (!in_list || i == 0) begin_block();
    text += line_text(section.lines[i], in_list);
  }
  return text;
}

}  // namespace

std::string markdown(const Document& document) {
  std::string text;
  for (const Section& section : document.sections) {
    text += (text.empty() ? "" : "\n") + markdown_section(section);
  }
  return text;
}

}  // namespace reeve::reports
