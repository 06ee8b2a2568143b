#include "reports/sheet/sheet_latex.hpp"

#include <algorithm>

namespace reeve::reports {
namespace {

std::string comment(const std::string& text) {
  std::string line = "% " + text;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

// A dash alone stands for what is not there.
std::string cell(const std::string& text) { return text == "-" ? "--" : latex_escaped(text); }

std::string row_text(const std::vector<std::string>& cells) {
  std::string line = "  ";
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : " & ") + cells[i];
  return line + " \\\\\n";
}

std::string tabular(const Table& table) {
  std::string alignment;
  std::vector<std::string> headings;
  for (const TableColumn& column : table.columns) {
    alignment += column.is_text ? 'l' : 'r';
    headings.push_back(
        latex_escaped(column.heading + (column.unit.empty() ? "" : " (" + column.unit + ")")));
  }
  std::string text = "\\begin{tabular}{" + alignment + "}\n  \\toprule\n" + row_text(headings);
  text += "  \\midrule\n";
  for (const TableRow& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::string& content : row.cells) cells.push_back(cell(content));
    text += row_text(cells);
  }
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

std::string latex_section(const Section& section) {
  std::string text = section.title.empty() ? "" : comment(section.title);
  if (section.table) text += tabular(*section.table);
  for (const SheetLine& line : section.lines) {
    text += line.caveat ? "\\noindent " + latex_escaped(line.text) + "\\par\n" : comment(line.text);
  }
  return text;
}

}  // namespace

std::string latex(const Sheet& sheet) {
  std::string text = "% Tables for \\input; they need \\usepackage{booktabs} in the preamble.\n";
  for (const Section& section : sheet.sections) text += "\n" + latex_section(section);
  return text;
}

}  // namespace reeve::reports
