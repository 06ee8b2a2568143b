#include "pages/html_table.hpp"

#include "pages/template.hpp"

namespace reeve {
namespace {

bool is_left(const std::string& heading) { return heading.starts_with('<'); }

// Beyond this a cell's text goes into several lines.
constexpr std::size_t long_text = 40;

Json cell(const std::string& text, bool left) {
  return {{"text", text}, {"left", left}, {"long", text.size() > long_text}};
}

}  // namespace

std::string html(const HtmlTable& table) {
  Json headings = Json::array();
  for (const std::string& heading : table.headings) {
    headings.push_back(cell(is_left(heading) ? heading.substr(1) : heading, is_left(heading)));
  }
  Json rows = Json::array();
  for (const std::vector<std::string>& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 1; i < row.size(); ++i) {
      cells.push_back(cell(row[i], is_left(table.headings[i])));
    }
    rows.push_back({{"heading", cell(row.front(), is_left(table.headings.front()))}});
    rows.back()["cells"] = cells;
  }
  Json values{{"id", table.id}, {"caption", table.caption}, {"sortable", table.sortable}};
  values["headings"] = headings;
  values["rows"] = rows;
  return render("table.mustache", values);
}

}  // namespace reeve
