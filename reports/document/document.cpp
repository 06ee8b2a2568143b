#include "reports/document/document.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/text.hpp"

namespace reeve::reports {

TableColumn text_column(const std::string& heading) { return {heading, "", true}; }

TableColumn number_column(const std::string& heading, const std::string& unit,
                          unsigned dispensable) {
  return {heading, unit, false, dispensable};
}

std::string heading_text(const TableColumn& column) {
  return column.unit.empty() ? column.heading : column.heading + " (" + column.unit + ")";
}

std::string shown_unit(const std::string& unit) {
  const std::size_t slash = std::min(unit.find('/'), unit.size());
  const bool is_ratio = slash < unit.size() && unit.substr(0, slash) == unit.substr(slash + 1);
  return is_ratio || unit == "%" ? "" : unit;
}

void Table::add(std::vector<std::string> cells, Tint tint) {
  rows.push_back({std::move(cells), tint});
}

Table columns_at(const Table& table, const std::vector<std::size_t>& places) {
  Table result;
  for (const std::size_t i : places) result.columns.push_back(table.columns[i]);
  for (const TableRow& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::size_t i : places) cells.push_back(row.cells[i]);
    result.add(std::move(cells), row.tint);
  }
  return result;
}

void Document::add(Section section) {
  if (section.table || !section.lines.empty()) sections.push_back(std::move(section));
}

void Document::add_all(std::vector<Section> more) {
  for (Section& section : more) add(std::move(section));
}

std::string enumerated(const std::vector<std::string>& items, const char* before_last,
                       std::size_t most) {
  const std::size_t shown = std::min(most, items.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    text += (i == 0 ? "" : i + 1 == items.size() ? before_last : ", ") + items[i];
  }
  return shown == items.size() ? text : text + fmt::format(" and {} more", items.size() - shown);
}

void add_lines(std::vector<DocumentLine>& lines, const std::string& text) {
  std::istringstream in(text);
  in.exceptions(std::ios::badbit);  // no memory is no end of the text
  for (std::string line; std::getline(in, line);) lines.push_back({line});
}

std::string percent(double share) {
  return std::isfinite(share) ? fixed(100 * share, 1) + " %" : "-";
}

std::string share_text(double share) {
  std::string text = percent(share);
  if (share > 0 && text == percent(0)) return "under 0.1 %";
  if (share < 1 && text == percent(1)) return "over 99.9 %";
  return text;
}

}  // namespace reeve::reports
