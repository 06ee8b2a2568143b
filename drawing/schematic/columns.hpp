// Horizontal places of fittings in levels.
//
// Parts at the same height keep their order and some distance: x_j ≥ x_i + d_ij for every two
// fittings i, j. Within that, level stretches and the width of the drawing cost as little as they
// can together: a linear programme, solved exactly. Small steps of lines are then straightened.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "drawing/schematic/levels.hpp"

namespace reeve::drawing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

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

// The middle of every fitting, the least x of all that is drawn being 0.
struct Columns {
  std::vector<double> middle;
  double right = 0;
  // Lengths of all level stretches and a quarter of the width, before small steps were
  // straightened.
  double cost = 0;
};

// Returns nothing if they cost `limit` or more, or if the ranks ask for more room between the
// strands of a finger than there is.
std::optional<Columns> columns(const Fittings& all, const Lanes& lanes, std::vector<Strip> strips,
                               double limit);

// The x of a port; of what hangs straight below another port, that one's.
double column(const Fittings& all, const Columns& columns, std::size_t port);

}  // namespace reeve::drawing
