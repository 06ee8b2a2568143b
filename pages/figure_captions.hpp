// A sentence for each figure that can stand below it in a paper: what it shows, of which parts, and
// that it was computed.
#pragma once

#include <string>

#include "causes/model.hpp"
#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {

// "friction coefficients of 0.18 (tubes), …": the coefficients behind a figure.
std::string coefficients_text(const Model& model);

std::string schematic_caption(const ShownRouting& report, const ShownGrasp& shown);

// What the page says of a chart, then the coefficients.
FigureFile captioned(const Figure& figure, const Model& model);

}  // namespace reeve::pages
