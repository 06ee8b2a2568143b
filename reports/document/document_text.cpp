#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

// How a table that is wider than a window is made to fit.
inline constexpr std::size_t column_gap = 2;

struct FittedTable {
  std::vector<Table> parts;           // one below the other
  std::vector<std::string> left_out;  // headings
};

// A text is not made narrower than this to save a column from the next part.
constexpr std::size_t readable = 16;

std::size_t total(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), std::size_t{0}) +
         column_gap * (widths.size() - 1);
}

// The column to leave out next, or the number of columns if none may be.
std::size_t most_dispensable(const Table& table) {
  const auto most = std::ranges::max_element(table.columns, {}, &TableColumn::dispensable);
  return most->dispensable == 0 ? table.columns.size()
                                : static_cast<std::size_t>(most - table.columns.begin());
}

// Returns a column's heading in text, in which shares and ratios have no unit.
std::string text_heading(const TableColumn& column) {
  TableColumn shown = column;
  shown.unit = shown_unit(column.unit);
  return heading_text(shown);
}

// Returns the greatest width of each column's heading and cells.
std::vector<std::size_t> natural_widths(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    widths.push_back(text_width(text_heading(table.columns[i])));
    for (const TableRow& row : table.rows) {
      widths[i] = std::max(widths[i], text_width(row.cells[i]));
    }
  }
  return widths;
}

std::vector<std::size_t> least_widths(const Table& table) {
  std::vector<std::size_t> widths = natural_widths(table);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (table.columns[i].is_text) widths[i] = std::min(widths[i], readable);
  }
  return widths;
}

std::vector<Table> folded(const Table& table, std::size_t width) {
  const std::vector<std::size_t> widths = least_widths(table);
  std::vector<Table> parts;
  std::vector<std::size_t> chosen{0};
  std::size_t used = widths[0];
  for (std::size_t i = 1; i < widths.size(); ++i) {
    if (chosen.size() > 1 && used + column_gap + widths[i] > width) {
      parts.push_back(columns_at(table, chosen));
      chosen = {0};
      used = widths[0];
    }
    chosen.push_back(i);
    used += column_gap + widths[i];
  }
  parts.push_back(columns_at(table, chosen));
  return parts;
}

// The widths of a table's columns such that it is no wider than that: texts shrink first.
std::vector<std::size_t> shrunk_widths(const Table& table, std::size_t width) {
  std::vector<std::size_t> widths = natural_widths(table);
  while (total(widths) > width) {
    std::size_t widest = widths.size();
    for (const bool text_only : {true, false}) {
      for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] < 2 || (text_only && !table.columns[i].is_text)) continue;
        if (widest == widths.size() || widths[i] > widths[widest]) widest = i;
      }
      if (widest < widths.size()) break;
    }
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

// Leaves columns out only if the others then stand side by side.
FittedTable fit(const Table& table, std::size_t width) {
  FittedTable fitted;
  Table kept = table;
  while (total(natural_widths(kept)) > width) {
    const std::size_t dropped = most_dispensable(kept);
    if (dropped == kept.columns.size()) break;
    fitted.left_out.insert(fitted.left_out.begin(), kept.columns[dropped].heading);
    std::vector<std::size_t> chosen(kept.columns.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(dropped));
    kept = columns_at(kept, chosen);
  }
  const bool side_by_side = total(least_widths(kept)) <= width;
  if (!side_by_side) fitted.left_out.clear();
  fitted.parts = folded(side_by_side ? kept : table, width);
  return fitted;
}

// One row of a table, in as many lines as its cells need.
std::string row_text(const Table& table, const TableRow& row,
                     const std::vector<std::size_t>& widths, Tint tint, const TextStyle& look) {
  std::vector<std::vector<std::string>> cells;
  std::size_t height = 1;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    cells.push_back(wrap_words(row.cells[i], widths[i]));
    height = std::max(height, cells[i].size());
  }
  std::string text;
  for (std::size_t k = 0; k < height; ++k) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += i == 0 ? "" : std::string(column_gap, ' ');
      line += padded(k < cells[i].size() ? cells[i][k] : "", widths[i], table.columns[i].is_text);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += inked(line, tint, look) + '\n';
  }
  return text;
}

std::string part_text(const Table& table, const std::vector<std::size_t>& widths,
                      const TextStyle& look) {
  TableRow headings;
  for (const TableColumn& column : table.columns) headings.cells.push_back(text_heading(column));
  std::string text = row_text(table, headings, widths, Tint::strong, look);
  for (const TableRow& row : table.rows) {
    text += row_text(table, row, widths, row.tint, look);
  }
  return text;
}

}  // namespace

std::string inked(const std::string& line, Tint tint, const TextStyle& look) {
  if (!look.colour || tint == Tint::none || line.empty()) return line;
  const char* code = tint == Tint::strong ? "1"
                     : tint == Tint::good ? "32"
                     : tint == Tint::bad  ? "31"
                                          : "33";
  return fmt::format("\x1b[{}m{}\x1b[0m", code, line);
}

std::string text(const Table& table, const TextStyle& look) {
  if (look.width == 0) return part_text(table, natural_widths(table), look);
  const FittedTable fitted = fit(table, look.width);
  std::string text;
  for (const Table& part : fitted.parts) {
    text += (text.empty() ? "" : "\n") + part_text(part, shrunk_widths(part, look.width), look);
  }
  if (fitted.left_out.empty()) return text;
  const std::string left_out =
      fmt::format("Left out for want of room: {}. A wider window and --format json have all.",
                  fmt::join(fitted.left_out, ", "));
  for (const std::string& line : wrap_words(left_out, look.width)) text += line + '\n';
  return text;
}

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
