// Which designs a plot over two objectives shows, and the edge of the front in it. The page's
// script does the same for whatever the reader chooses (assets/exploration_charts.js).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drawing/shapes.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

using TwoObjectives = std::array<Objective, 2>;

// As many cells as the picture is cut into for thinning.
struct SpotGrid {
  double columns = 90;
  double lines = 60;
};

struct DrawnDesign {
  std::size_t design = 0;
  std::size_t count = 1;  // designs that the mark stands for, itself included
};

// Of designs that lie in one cell of the picture only the first, in their order; those on the front
// that differ by more than a dot, and the known routings, always.
std::vector<DrawnDesign> thinned(const std::vector<PageDesign>& designs, const TwoObjectives& axes,
                                 const SpotGrid& grid = {});

// The edge of what the front attains in two objectives: through the spots that none beats in both,
// out to the worst of `shown`; each corner first across, then up or down. Empty without spots.
std::vector<Point> front_edge(const std::vector<Point>& front, const TwoObjectives& axes,
                              const std::vector<Point>& shown);

Point spot(const PageDesign& design, const TwoObjectives& axes);

}  // namespace reeve::pages
