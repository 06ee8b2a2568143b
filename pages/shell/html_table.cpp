#include "pages/shell/html_table.hpp"

#include "pages/shell/template.hpp"

namespace reeve::pages {
namespace {

// Beyond this a cell's text goes into several lines.
constexpr std::size_t long_text = 40;

Json cell(const std::string& text, const TableColumn& column) {
  return {{"text", text},
          {"left", column.is_text},
          {"dispensable", column.dispensable > 0},
          {"long", text.size() > long_text}};
}

std::string heading(const TableColumn& column) {
  return column.unit.empty() ? column.heading : column.heading + ", " + column.unit;
}

}  // namespace

std::string html(const HtmlTable& table) {
  const std::vector<TableColumn>& columns = table.table.columns;
  Json headings = Json::array();
  for (const TableColumn& column : columns) headings.push_back(cell(heading(column), column));
  Json rows = Json::array();
  for (const TableRow& row : table.table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 1; i < row.cells.size(); ++i) {
      cells.push_back(cell(row.cells[i], columns[i]));
    }
    rows.push_back({{"heading", cell(row.cells.front(), columns.front())},
                    {"notable", row.tint == Tint::notable}});
    rows.back()["cells"] = cells;
  }
  Json values{{"id", table.id}, {"caption", table.caption}, {"sortable", table.sortable}};
  values["headings"] = headings;
  values["rows"] = rows;
  return render("table.mustache", values);
}

}  // namespace reeve::pages
