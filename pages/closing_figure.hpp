// Figures of fingers that close: joint angles over excursion, and the postures as a strip.
#pragma once

#include <vector>

#include "pages/shell/page.hpp"
#include "studies/shown_hand.hpp"

namespace reeve::pages {

// A figure of angles and one of postures for each kind of finger. `number` counts the kinds from 1.
std::vector<Figure> closing_figures(const ShownClosing& closing, std::size_t number);

}  // namespace reeve::pages
