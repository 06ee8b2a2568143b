// Where from left to right the fittings of a drawing with floating parts stand.
//
// What passes the same height keeps its order and some distance: x_j ≥ x_i + d_ij for every two
// fittings i, j. Within that, each fitting goes where its lines run straight: to the median of the
// places that would let one of them do so.
#pragma once

#include <optional>
#include <vector>

#include "drawing/schematic/heights.hpp"

namespace reeve::drawing {

// The middle of every fitting, the least x of all that is drawn being 0; nothing if the ranks ask
// for more room between the strands of a finger than there is.
struct Columns {
  std::vector<double> middle;
  double right = 0;
};

std::optional<Columns> columns(const Network& network, const Fittings& all, const Lanes& lanes,
                               const FloatingHeights& heights, const Ranks& ranks);

// The x of a port; of what hangs straight below another port, that one's.
double column(const Fittings& all, const Columns& columns, std::size_t port);

}  // namespace reeve::drawing
