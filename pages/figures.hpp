// Figures as files: their names, such as TR6-held-1.svg, which say what they show when they lie in
// somebody else's folder; and a sentence for each that can stand below it in a paper: what it
// shows, of which parts, and that it was computed.
#pragma once

#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "pages/page_words.hpp"
#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {

// The first part of the names of each routing's files: its label, in which whatever is no letter,
// digit or '-' of ASCII has become '_', so that every file system takes it. No two are alike, also
// where case does not count, and none is that of a chart of the page ("tensions").
std::vector<std::string> file_stems(const std::vector<NamedRouting>& routings);

// "TR6-held-1"
std::string schematic_name(const std::string& stem, Grasp grasp);

// "friction coefficients of 0.18 (tubes), …": the coefficients behind a figure.
std::string coefficients_text(const Model& model);

std::string schematic_caption(const SolvedRouting& report, const ShownGrasp& shown);

// Returns the figure with the page's words on the chart, then the coefficients.
FigureFile captioned(const Figure& figure, const Model& model);

}  // namespace reeve::pages
