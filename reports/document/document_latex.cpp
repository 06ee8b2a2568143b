#include "reports/document/document_latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "reports/document/latex_table.hpp"
#include "reports/document/latex_width.hpp"

namespace reeve::reports {
namespace {

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
