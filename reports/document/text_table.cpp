#include "reports/document/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/document/table_fit.hpp"
#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

Ink ink_of(Tint tint) {
  switch (tint) {
    case Tint::none:
      return Ink::plain;
    case Tint::good:
      return Ink::good;
    case Tint::notable:
      return Ink::notable;
    case Tint::bad:
      return Ink::bad;
  }
  return Ink::plain;
}

// One row of a table, in as many lines as its cells need.
std::string row_text(const Table& table, const TableRow& row,
                     const std::vector<std::size_t>& widths, Ink ink, const TextStyle& look) {
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
    text += inked(line, ink, look) + '\n';
  }
  return text;
}

std::string part_text(const Table& table, const std::vector<std::size_t>& widths,
                      const TextStyle& look) {
  TableRow headings;
  for (const TableColumn& column : table.columns) headings.cells.push_back(text_heading(column));
  std::string text = row_text(table, headings, widths, Ink::strong, look);
  for (const TableRow& row : table.rows) {
    text += row_text(table, row, widths, ink_of(row.tint), look);
  }
  return text;
}

}  // namespace

std::string inked(const std::string& line, Ink ink, const TextStyle& look) {
  if (!look.colour || ink == Ink::plain || line.empty()) return line;
  const char* code = ink == Ink::strong ? "1"
                     : ink == Ink::good ? "32"
                     : ink == Ink::bad  ? "31"
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

}  // namespace reeve::reports
