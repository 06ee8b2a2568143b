// Tension distributions as the Exo-Glove II supplement draws them (its Fig. 9): for each friction
// coefficient, or model, a row of panels, one for each routing; the model as a line with symbols,
// what is published as a dashed one, what was measured as bars.
#pragma once

#include <string>
#include <vector>

#include "pages/shell/page.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::pages {

// One for each grasp: the first is "figure-9", others say their grasp too.
std::vector<Figure> distribution_figures(const TensionDistributions& distributions);

// Notes below the distributions: sources of published values, the check's findings of faulty ones
// and their reasons, and the data left out. HTML.
std::string distribution_notes(const TensionDistributions& distributions);

}  // namespace reeve::pages
