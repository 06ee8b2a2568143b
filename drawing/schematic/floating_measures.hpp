// Lengths of a drawing with floating parts, in pixels, besides those of every schematic.
#pragma once

#include <string>

#include "core/network.hpp"
#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing::measures {

inline constexpr double tail_eye = 52;    // from the middle of a sheave to the eye of the tail
inline constexpr double beam_depth = 40;  // … to the beam that bears several sheaves
inline constexpr double eye_radius = 5;
inline constexpr double beam_half = 4;
inline constexpr double bar_half = 8;        // half the thickness of a bar
inline constexpr double turning_arrow = 20;  // radius of the arrow over a bar that turns
inline constexpr double name_height = 18;    // of Y1, W1
inline constexpr double motion_length = 20;  // of the arrow at a block
inline constexpr double anchor_depth = 24;   // from the top of a finger to the tendon tied there

inline constexpr double gap = 6;          // between a level and the channel below it
inline constexpr double lane_pitch = 15;  // of level stretches above each other
inline constexpr double lane_room = 12;   // above the topmost and below the lowest
inline constexpr double label_room = 4;   // above and below a label
inline constexpr double stub = label_height + 2 * label_room + 2;  // of a fixed end with a label
inline constexpr double short_stub = 12;                           // … without
inline constexpr double bend_room = bend;                          // beyond a lane, of a corner
inline constexpr double body_margin = 12;  // beside the outermost lines of a fitting
inline constexpr double name_left = 11;    // of a block's name, from its tail
inline constexpr double motion_width = 10;
inline constexpr double apart = 18;  // least distance of parallel lines

// Y1; of unequal arms also the ratio of their tensions: W1 2:1.
std::string block_title(const core::Block& block);
double name_width(const core::Block& block);

}  // namespace reeve::drawing::measures
