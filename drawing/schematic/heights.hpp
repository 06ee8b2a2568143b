// The heights of a drawing with floating parts: of its levels, channels, labels and lanes.
//
// A channel is, from the top: a band for the labels and fixed ends of what leaves the level above
// downward, the lanes, and a band for those of what leaves the level below upward.
#pragma once

#include <vector>

#include "drawing/schematic/lanes.hpp"

namespace reeve::drawing {

struct ChannelHeights {
  double top = 0;
  double lanes = 0;  // the topmost lane
  double below = 0;  // the top of the band below the lanes
  double bottom = 0;
};

struct FloatingHeights {
  std::vector<double> level;  // the middle of each; the fingers' lies where the palm begins
  std::vector<ChannelHeights> channel;
  double hand_bottom = 0;
  double carriage_top = 0;
  double tied = 0;
  double bottom = 0;  // of the carriage, or of the hand where there is none
};

// Where along a line that has no finger to run along its name stands: at this port.
std::size_t labelled_port(const Network& network, const Fittings& all, std::size_t segment);

FloatingHeights heights(const Network& network, const Fittings& all, const Lanes& lanes,
                        double palm);

// The height of a port: of the middle of its turn, its eye or its knot.
double height(const Fittings& all, const FloatingHeights& heights, std::size_t port);
double height(const FloatingHeights& heights, const Stretch& stretch);
// Where a loose end is held, beyond that port.
double loose_end(const Fittings& all, const FloatingHeights& heights, std::size_t port,
                 LooseEnd end);
// The top of a label at that port.
double label_top(const Fittings& all, const FloatingHeights& heights, std::size_t port);

}  // namespace reeve::drawing
