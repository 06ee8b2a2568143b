// Tables of pages. Cells are text, which is escaped.
#pragma once

#include <string>
#include <vector>

namespace reeve {

struct HtmlTable {
  std::string id;
  std::string caption;
  // One that begins with '<' stands above a column that is aligned to the left.
  std::vector<std::string> headings;
  // The first cell of each is its heading.
  std::vector<std::vector<std::string>> rows;
  bool sortable = false;
};

// In a box that scrolls by itself where the window is narrow.
std::string html(const HtmlTable& table);

}  // namespace reeve
