// The level stretches of the lines between the levels of fittings, and which of them lie on one
// lane.
//
// Between a level and the next lies a channel. A line that runs straight on from a port to a lower
// one has one stretch there, a line between two ports that face alike bends over above or below
// both. Stretches that lie over each other get lanes of their own, in an order in which few lines
// cross; so no line lies on another, and all cross at right angles.
#pragma once

#include <cstddef>
#include <vector>

#include "drawing/schematic/fittings.hpp"

namespace reeve::drawing {

// From left to right every port has a rank: ports of lesser rank stand left of it wherever both
// pass the same height.
using Ranks = std::vector<double>;

struct Stretch {
  std::size_t segment = 0;
  std::size_t channel = 0;  // below the level of this number
  std::size_t lane = 0;     // 0: the topmost
  std::array<std::size_t, 2> port{};
  std::array<bool, 2> rises{};  // whether the line goes on upward at that port
};

struct Lanes {
  std::vector<Stretch> stretches;
  std::vector<std::size_t> of_channel;  // how many lanes each has
};

Lanes lanes(const Fittings& all, const Ranks& ranks);

}  // namespace reeve::drawing
