// Designs over one coefficient as figures: a line for each, in the band of what else is uncertain.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/page.hpp"
#include "studies/listed_design.hpp"

namespace reeve::pages {

// One for each ranked objective that friction moves, "sweep-uniformity-mean", …: of at most
// studies::most_swept lines, designs with the same curve on one of them.
std::vector<Figure> sweep_figures(const SweptDesigns& swept);

// A heading, who comes first where, and the figures.
std::string sweep_html(const SweptDesigns& swept, const std::vector<Figure>& figures);

}  // namespace reeve::pages
