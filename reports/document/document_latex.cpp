#include "reports/document/document_latex.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>

#include "core/error.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/document/text_width.hpp"

namespace reeve::reports {
namespace {

constexpr double column_gap_pt = 6;   // twice \tabcolsep
constexpr double least_text_pt = 34;  // a text is not wrapped into less
constexpr double spare_pt = 0.5;      // rounding allowance of a column of wrapped text

// Digits behind the decimal mark; nothing of what is no plain number.
std::optional<std::size_t> decimals(const std::string& cell) {
  const std::size_t begin = cell.find_first_of("+-") == 0 ? 1 : 0;
  const std::size_t mark = std::min(cell.find('.'), cell.size());
  const auto are_digits = [&](std::size_t from, std::size_t to) {
    return from < to && std::all_of(cell.begin() + static_cast<std::ptrdiff_t>(from),
                                    cell.begin() + static_cast<std::ptrdiff_t>(to), [](char c) {
                                      return std::isdigit(static_cast<unsigned char>(c)) != 0;
                                    });
  };
  if (!are_digits(begin, mark)) return std::nullopt;
  if (mark == cell.size()) return 0;
  if (!are_digits(mark + 1, cell.size())) return std::nullopt;
  return cell.size() - mark - 1;
}

std::string digits_that_lack(std::size_t has, std::size_t most) {
  if (has == most) return "";
  return (has == 0 ? "." : "") + std::string(most - has, '0');
}

// In as many lines as it takes; a word alone may be wider.
std::vector<std::string> heading_lines(const std::string& heading, double width) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(heading)) {
    const bool joins = !lines.empty() && latex_width_pt(lines.back() + " " + word) <= width;
    if (joins) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

// Between these LaTeX may break a text: behind blanks, '-' and '+'.
double widest_piece(const std::string& text) {
  double widest = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != ' ' && text[at] != '-' && text[at] != '+' && at + 1 < text.size()) continue;
    widest = std::max(widest, latex_width_pt(text.substr(begin, at + 1 - begin)));
    begin = at + 1;
  }
  return widest;
}

struct LatexColumn {
  TableColumn about;
  std::vector<std::string> cells;  // as LaTeX reads them
  double natural = 0;              // without the heading, pt
  double least = 0;                // likewise, what is wrapped wrapped
  double heading = 0;              // the widest word of the heading
  bool wrapped = false;
  double width = 0;  // width of the cells in a wrapped column

  double total() const { return std::max(wrapped ? width : natural, heading); }
};

// A dash alone stands for what is not there.
std::string latex_cell(const std::string& text) { return text == "-" ? "--" : latex_escaped(text); }

LatexColumn number_cells(const TableColumn& about, const std::vector<std::string>& cells) {
  LatexColumn column{about, {}};
  std::size_t most = 0;
  for (const std::string& cell : cells) most = std::max(most, decimals(cell).value_or(0));
  for (const std::string& cell : cells) {
    const auto has = decimals(cell);
    const std::string lacking = has ? digits_that_lack(*has, most) : "";
    column.natural = std::max(column.natural, latex_width_pt(cell + lacking));
    column.cells.push_back(latex_cell(cell) +
                           (lacking.empty() ? "" : "\\phantom{" + lacking + "}"));
  }
  column.least = column.natural;
  return column;
}

LatexColumn text_cells(const TableColumn& about, const std::vector<std::string>& cells) {
  LatexColumn column{about, {}};
  for (const std::string& cell : cells) {
    column.natural = std::max(column.natural, latex_width_pt(cell));
    column.least = std::max(column.least, widest_piece(cell));
    column.cells.push_back(latex_cell(cell));
  }
  column.least = std::min(column.natural, std::max(column.least + spare_pt, least_text_pt));
  return column;
}

std::vector<LatexColumn> latex_columns(const Table& table) {
  std::vector<LatexColumn> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::vector<std::string> cells;
    for (const TableRow& row : table.rows) cells.push_back(row.cells[i]);
    const TableColumn& about = table.columns[i];
    columns.push_back(about.is_text ? text_cells(about, cells) : number_cells(about, cells));
    for (const std::string& word : words_of(heading_text(about))) {
      columns.back().heading = std::max(columns.back().heading, latex_width_pt(word));
    }
  }
  return columns;
}

using Width = std::function<double(const LatexColumn&)>;

double total_width(const std::vector<LatexColumn>& columns, const Width& width) {
  double total = column_gap_pt * static_cast<double>(columns.size() - 1);
  for (const LatexColumn& column : columns) total += width(column);
  return total;
}

double least_total(const LatexColumn& column) { return std::max(column.least, column.heading); }

bool can_fit(const std::vector<LatexColumn>& columns, double width_pt) {
  return total_width(columns, least_total) <= width_pt;
}

// The widest text first, down to the next; all of them to the least if need be.
void wrap_texts(std::vector<LatexColumn>& columns, double width_pt) {
  constexpr double step_pt = 1;
  const Width as_it_is = [](const LatexColumn& column) { return column.total(); };
  while (total_width(columns, as_it_is) > width_pt) {
    LatexColumn* widest = nullptr;
    for (LatexColumn& column : columns) {
      if (!column.about.is_text || column.total() <= least_total(column)) continue;
      if (widest == nullptr || column.total() > widest->total()) widest = &column;
    }
    if (widest == nullptr) break;
    widest->width = std::max(widest->least, widest->total() - step_pt);
    widest->wrapped = true;
  }
}

std::string row_text(const std::vector<std::string>& cells, bool wrapped) {
  std::string line = "  ";
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : " & ") + cells[i];
  // In a column that is ragged \\ would end a line of its text.
  return line + (wrapped ? " \\tabularnewline\n" : " \\\\\n");
}

std::string headings_text(const std::vector<LatexColumn>& columns, double width_pt, bool wrapped) {
  std::vector<std::vector<std::string>> headings;
  std::size_t height = 1;
  for (const LatexColumn& column : columns) {
    const std::string heading = heading_text(column.about);
    headings.push_back(width_pt > 0 ? heading_lines(heading, column.total())
                                    : std::vector<std::string>{heading});
    height = std::max(height, headings.back().size());
  }
  std::string text;
  for (std::size_t k = 0; k < height; ++k) {
    std::vector<std::string> cells;
    for (const auto& heading : headings) {
      const std::size_t above = height - heading.size();
      cells.push_back(k < above ? "" : latex_escaped(heading[k - above]));
    }
    text += row_text(cells, wrapped);
  }
  return text;
}

std::string wrapped_cell(const std::string& cell) {
  std::string text = "\\raggedright ";
  for (const char c : cell) text += c == '+' ? "+\\allowbreak{}" : std::string(1, c);
  return text;
}

std::string alignment(const std::vector<LatexColumn>& columns, double width_pt) {
  std::string text;
  for (const LatexColumn& column : columns) {
    text += column.wrapped         ? fmt::format("p{{{:.1f}pt}}", column.width)
            : column.about.is_text ? "l"
                                   : "r";
  }
  return width_pt > 0 ? "@{}" + text + "@{}" : text;
}

std::string tabular(std::vector<LatexColumn> columns, double width_pt) {
  if (width_pt > 0) wrap_texts(columns, width_pt);
  const bool wrapped = std::ranges::any_of(columns, &LatexColumn::wrapped);
  std::string text = "\\begin{tabular}{" + alignment(columns, width_pt) + "}\n  \\toprule\n" +
                     headings_text(columns, width_pt, wrapped) + "  \\midrule\n";
  for (std::size_t r = 0; r < columns.front().cells.size(); ++r) {
    std::vector<std::string> cells;
    for (const LatexColumn& column : columns) {
      cells.push_back(column.wrapped ? wrapped_cell(column.cells[r]) : column.cells[r]);
    }
    text += row_text(cells, wrapped);
  }
  text += "  \\bottomrule\n\\end{tabular}";
  if (width_pt == 0) return text + "\n";
  return "{\\footnotesize\\setlength{\\tabcolsep}{3pt}%\n" + text + "}\n";
}

[[noreturn]] void fail_to_fit(const std::vector<LatexColumn>& columns, double width_pt) {
  std::vector<LatexColumn> fit;
  std::vector<std::string> names;
  for (const LatexColumn& column : columns) {
    fit.push_back(column);
    if (!can_fit(fit, width_pt)) break;
    names.push_back(key(column.about));
  }
  throw InputError(
      {.what = "--text-width",
       .value = fmt::format("{:.4g} mm", width_pt / pt_in_mm),
       .expected = fmt::format(
           "{:.0f} mm or more for the --columns that were chosen, or fewer of them: {} fit",
           total_width(columns, least_total) / pt_in_mm + 0.5,
           names.empty() ? "not even the first" : fmt::format("{}", fmt::join(names, ",")))});
}

// Returns the dispensable column to leave out next.
std::vector<LatexColumn>::iterator least_wanted(std::vector<LatexColumn>& columns) {
  return std::ranges::max_element(
      columns, {}, [](const LatexColumn& column) { return column.about.dispensable; });
}

std::vector<std::vector<LatexColumn>> parts_of(const std::vector<LatexColumn>& columns,
                                               double width_pt) {
  std::vector<std::vector<LatexColumn>> parts{{columns.front()}};
  for (std::size_t i = 1; i < columns.size(); ++i) {
    parts.back().push_back(columns[i]);
    if (parts.back().size() == 2 || can_fit(parts.back(), width_pt)) continue;
    parts.back().pop_back();
    parts.push_back({columns.front(), columns[i]});
  }
  return parts;
}

std::string fitted(const std::vector<LatexColumn>& columns, double width_pt) {
  std::vector<LatexColumn> kept = columns;
  std::vector<std::string> left_out;
  while (!can_fit(kept, width_pt)) {
    const auto next = least_wanted(kept);
    if (next->about.dispensable == 0) break;
    left_out.push_back(next->about.heading);
    kept.erase(next);
  }
  if (!can_fit(kept, width_pt)) {
    std::string text;
    for (const auto& part : parts_of(columns, width_pt)) {
      text += (text.empty() ? "" : "\n") + tabular(part, width_pt);
    }
    return text;
  }
  if (left_out.empty()) return tabular(kept, width_pt);
  return fmt::format("% Left out for want of room: {}\n", fmt::join(left_out, ", ")) +
         tabular(kept, width_pt);
}

// Below this the table stands out, or, if its columns were chosen, goes on in a further tabular.
double least_width_pt(const Table& table) {
  const std::vector<LatexColumn> columns = latex_columns(table);
  if (table.chosen) return total_width(columns, least_total);
  double widest = least_total(columns.front());
  for (std::size_t i = 1; i < columns.size(); ++i) {
    widest = std::max(widest, total_width({columns.front(), columns[i]}, least_total));
  }
  std::vector<LatexColumn> kept = columns;
  std::erase_if(kept, [](const LatexColumn& column) { return column.about.dispensable > 0; });
  return kept.empty() ? widest : std::min(widest, total_width(kept, least_total));
}

std::string latex(const Table& table, double width_pt) {
  const std::vector<LatexColumn> columns = latex_columns(table);
  if (width_pt == 0 || can_fit(columns, width_pt)) return tabular(columns, width_pt);
  return fitted(columns, width_pt);
}

// Checks a table whose columns were chosen. Throws InputError that says how much they take, and
// which of them fit.
void require_chosen_fit(const Table& table, double width_pt) {
  const std::vector<LatexColumn> columns = latex_columns(table);
  if (!can_fit(columns, width_pt)) fail_to_fit(columns, width_pt);
}

std::string comment(const std::string& text) {
  std::string line = "% " + text;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string latex_section(const Section& section, double width_pt) {
  std::string text = section.title.empty() ? "" : comment(section.title);
  if (section.table) text += latex(*section.table, width_pt);
  for (const DocumentLine& line : section.lines) {
    text += line.caveat ? "\\noindent " + latex_escaped(line.text) + "\\par\n" : comment(line.text);
  }
  return text;
}

}  // namespace

std::string latex(const Document& document, double width_pt) {
  std::string text = "% Tables for \\input; they need \\usepackage{booktabs} in the preamble.\n";
  for (const Section& section : document.sections) text += "\n" + latex_section(section, width_pt);
  return text;
}

double least_width_pt(const Document& document) {
  double widest = 0;
  for (const Section& section : document.sections) {
    if (section.table) widest = std::max(widest, least_width_pt(*section.table));
  }
  return widest;
}

void require_fits(const Document& document, double width_pt) {
  for (const Section& section : document.sections) {
    if (section.table && section.table->chosen) require_chosen_fit(*section.table, width_pt);
  }
  const double takes_pt = least_width_pt(document);
  if (takes_pt <= width_pt) return;
  throw InputError(
      {.what = "--text-width",
       .value = fmt::format("{:.4g} mm", width_pt / pt_in_mm),
       .expected = fmt::format("{:.0f} mm or more, which the tables take, or --columns",
                               std::ceil(takes_pt / pt_in_mm))});
}

}  // namespace reeve::reports
