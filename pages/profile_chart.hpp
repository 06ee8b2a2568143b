// The goal against each dimension about the optimum, the others staying: a panel for each.
#pragma once

#include "pages/shell/page.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::pages {

// The report has details, with a profile at least.
Figure profile_figure(const SizingReport& report);

}  // namespace reeve::pages
