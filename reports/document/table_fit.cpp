#include "reports/document/table_fit.hpp"

#include <algorithm>
#include <numeric>

#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

// A text is not made narrower than this to save a column from the next part.
constexpr std::size_t readable = 16;

std::size_t total(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), std::size_t{0}) +
         column_gap * (widths.size() - 1);
}

Table with_columns(const Table& table, const std::vector<std::size_t>& chosen) {
  Table result;
  for (const std::size_t i : chosen) result.columns.push_back(table.columns[i]);
  for (const TableRow& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::size_t i : chosen) cells.push_back(row.cells[i]);
    result.add(std::move(cells), row.tint);
  }
  return result;
}

// The column to leave out next, or the number of columns if none may be.
std::size_t most_dispensable(const Table& table) {
  const auto most = std::max_element(
      table.columns.begin(), table.columns.end(),
      [](const TableColumn& a, const TableColumn& b) { return a.dispensable < b.dispensable; });
  return most->dispensable == 0 ? table.columns.size()
                                : static_cast<std::size_t>(most - table.columns.begin());
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
      parts.push_back(with_columns(table, chosen));
      chosen = {0};
      used = widths[0];
    }
    chosen.push_back(i);
    used += column_gap + widths[i];
  }
  parts.push_back(with_columns(table, chosen));
  return parts;
}

}  // namespace

std::string text_heading(const TableColumn& column) {
  TableColumn shown = column;
  shown.unit = shown_unit(column.unit);
  return heading_text(shown);
}

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
    kept = with_columns(kept, chosen);
  }
  const bool side_by_side = total(least_widths(kept)) <= width;
  if (!side_by_side) fitted.left_out.clear();
  fitted.parts = folded(side_by_side ? kept : table, width);
  return fitted;
}

}  // namespace reeve::reports
