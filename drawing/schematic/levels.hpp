// The levels in which fittings lie below each other, the channels between them, and the lanes in
// these along which lines run: their heights.
//
// A channel is, from the top: a band for the labels and fixed ends of what leaves the level above
// downward, the lanes, and a band for those of what leaves the level below upward. A line that runs
// straight on from a port to a lower one has one stretch there, a line between two ports that face
// alike bends over above or below both. Stretches that lie over each other get lanes of their own,
// in an order in which few lines cross; so no line lies on another, and all cross at right angles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "drawing/schematic/fittings.hpp"

namespace reeve::drawing {

// [port]: rank from left to right. A port of lesser rank stands left of another wherever both pass
// the same height.
using Ranks = std::vector<double>;

struct LaneStretch {
  std::size_t segment = 0;
  std::size_t channel = 0;  // below the level of this number
  std::size_t lane = 0;     // 0: the topmost
  std::array<std::size_t, 2> port{};
  std::array<bool, 2> rises{};  // true if the line goes on upward at that port
};

struct Lanes {
  std::vector<LaneStretch> stretches;
  std::vector<std::size_t> of_channel;  // [channel]: number of lanes
};

Lanes lanes(const Fittings& all, const Ranks& ranks);

struct ChannelHeights {
  double top = 0;
  double lanes = 0;  // the topmost lane
  double below = 0;  // the top of the band below the lanes
  double bottom = 0;
};

// Heights, measured from where the palm begins.
struct Heights {
  std::vector<double> level;  // the middle of each; the fingers' is 0
  std::vector<ChannelHeights> channel;
  double hand_bottom = 0;
  double carriage_top = 0;
  double tied = 0;
  double bottom = 0;  // bottom of the carriage, or of the hand without one
};

// Returns the port at which the name of a line without a finger stands.
std::size_t labelled_port(const Network& network, const Fittings& all, std::size_t segment);

Heights heights(const Network& network, const Fittings& all, const Lanes& lanes);

// The height of a port: of the middle of its turn, its eye or its knot.
double height(const Fittings& all, const Heights& heights, std::size_t port);
double height(const Heights& heights, const LaneStretch& stretch);
// Height at which a loose end is held, beyond that port.
double loose_end(const Fittings& all, const Heights& heights, std::size_t port, LooseEnd end);
// The top of a label at that port.
double label_top(const Fittings& all, const Heights& heights, std::size_t port);

}  // namespace reeve::drawing
