// Horizontal places of fittings in levels.
//
// Parts at the same height keep their order and some distance: x_j ≥ x_i + d_ij for every two
// fittings i, j. Within that, each fitting goes where its lines run straight: to the median of the
// places that would let one of them do so.
#pragma once

#include <optional>
#include <vector>

#include "drawing/schematic/levels.hpp"

namespace reeve::drawing {

// Keeps other parts away: an upright strip at a place of its fitting, over a range of heights.
struct Strip {
  std::size_t fitting = 0;  // the strip moves with its middle
  double rank = 0;
  double left = 0;  // from the fitting's middle, rightward
  double right = 0;
  double top = 0;
  double bottom = 0;
  std::size_t segment = nowhere;  // segment of a line's strip
  bool rises = false;             // true if the line goes upward from its stretch
};

std::vector<Strip> strips(const Network& network, const Fittings& all, const Lanes& lanes,
                          const Heights& heights, const Ranks& ranks);

// The fitting on whose column a port lies, and how far right of its middle.
struct ColumnOf {
  std::size_t fitting = 0;
  double offset = 0;
};
ColumnOf column_of(const Fittings& all, std::size_t port);

// The middle of every fitting, the least x of all that is drawn being 0; nothing if the ranks ask
// for more room between the strands of a finger than there is.
struct Columns {
  std::vector<double> middle;
  double right = 0;
};

std::optional<Columns> columns(const Network& network, const Fittings& all, const Lanes& lanes,
                               const Heights& heights, const Ranks& ranks);

// The x of a port; of what hangs straight below another port, that one's.
double column(const Fittings& all, const Columns& columns, std::size_t port);

}  // namespace reeve::drawing
