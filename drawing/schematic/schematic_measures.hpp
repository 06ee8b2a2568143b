// Lengths of a schematic, in pixels.
//
// Five fingers are 5 · 58 + 4 · 46 and margins: at 300 px wide their text is still 8 px high.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::drawing::measures {

inline constexpr double margin = 16;
inline constexpr double least_width = 290;

inline constexpr double pitch = 58;        // distance of the two columns of a block; labels lie
                                           // between
inline constexpr double block_gap = 46;    // distance from the last column of a block to the next
                                           // block
inline constexpr double widened_gap = 74;  // gap if a turn lies between two lines
inline constexpr double flesh = 15;        // distance from a strand to the finger's outline

inline constexpr double tip_radius = pitch / 2;
inline constexpr double turn_radius = block_gap / 2;
inline constexpr double bend = 7;    // rounding of a corner that is no contact
inline constexpr double sleeve = 7;  // half the width of a tube or a sheath
inline constexpr double thickest = 7;

inline constexpr double sheath_length = 62;
inline constexpr double fixation_width = 24;
inline constexpr double fixation_depth = 12;
inline constexpr double knot_size = 11;
inline constexpr double object_size = 26;

inline constexpr double text_size = 16;  // names and tensions
inline constexpr double small_size = 13;
inline constexpr double line_height = 18;  // height of a line of text
inline constexpr double label_width = 47;
inline constexpr double label_height = 2 * line_height;
inline constexpr double label_step = label_height + 3;  // distance to the next label below
inline constexpr double label_gap = 7;                  // distance from a line to its label

// Blocks and bars.
inline constexpr double tail_eye = 52;    // distance from the middle of a sheave to the eye of the
                                          // tail
inline constexpr double beam_depth = 40;  // … to the beam that bears several sheaves
inline constexpr double eye_radius = 5;
inline constexpr double beam_half = 4;
inline constexpr double bar_half = 8;        // half the thickness of a bar
inline constexpr double turning_arrow = 20;  // radius of the arrow over a bar that turns
inline constexpr double name_height = 18;    // height of the names Y1, W1
inline constexpr double motion_length = 20;  // length of the arrow at a block
inline constexpr double anchor_depth = 24;   // distance from the top of a finger to the tendon tied
                                             // there

inline constexpr double lane_pitch = 15;  // distance of level stretches above each other
inline constexpr double name_left = 11;   // distance of a block's name from its tail
inline constexpr double motion_width = 10;

}  // namespace reeve::drawing::measures
