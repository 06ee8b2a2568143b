// The labels of a panel's marks.
#pragma once

#include <vector>

#include "drawing/chart/chart_layout.hpp"

namespace reeve::drawing::chart {

// Of spots and rules that have one, as far as there is room; the panel lies where it will stay.
std::vector<LaidLabel> mark_labels(const LaidPanel& panel);

}  // namespace reeve::drawing::chart
