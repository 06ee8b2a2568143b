// A table of a result (reports/document/document.hpp) in a page. Cells are text, which is escaped.
#pragma once

#include <string>

#include "reports/document/document.hpp"

namespace reeve::pages {

struct HtmlTable {
  std::string id;
  std::string caption;
  Table table;  // the first cell of each row is its heading
  bool sortable = false;
};

// In a box that scrolls by itself where the window is narrow.
std::string html(const HtmlTable& table);

}  // namespace reeve::pages
