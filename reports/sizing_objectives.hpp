// What dimensions that suit a goal make of everything else: the objectives before and after, and
// whether a given motor is enough for the hand as it is sized.
#pragma once

#include "reports/document/document.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::reports {

// Of the best design, at the nominal coefficients.
Section objective_section(const SizingReport& report);

}  // namespace reeve::reports
