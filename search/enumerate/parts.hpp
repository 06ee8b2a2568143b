// The parts that a designer allows.
#pragma once

#include <string>
#include <vector>

#include "core/routing.hpp"

namespace reeve::search {

// Each list is sorted and without repeats.
struct PartSet {
  std::vector<TipKind> tips;
  std::vector<TokenKind> joins;
  std::vector<TokenKind> ends;
  bool anchored = false;            // true if a tendon may be tied at a fingertip: 1x
  int blocks = 0;                   // greatest number of floating blocks and bars in a routing
  int motors = 1;                   // every routing of several motors uses all of them
  std::vector<TokenKind> beside{};  // joins that may stand beside an end or a tail: F-P-1x, Y1-P-Y2
  bool linked = false;              // true if two tails may be tied to each other: Y1-Y2
  bool series = false;              // true if a root may pass several blocks: F-Y1-Y2-M
  bool bars = false;     // true if rigid bars may stand in place of blocks: M-W1+1x-W1-2x
  bool beckets = false;  // true if a tendon may be tied to the block that it passes: Y1k-1-Y1-2x
  bool double_passes = false;  // true if a tendon may pass its block twice: 1x-Y1-2-Y1-3x
};

// Greatest number of floating blocks in generated routings.
inline constexpr int max_generated_blocks = 8;

PartSet paper_parts();  // tip tube; joins T, P; ends M, F
PartSet full_parts();   // + tip bearing, + join B
PartSet all_parts();    // + anchored tips, + one floating block

// Comma-separated names: tips "tube,bearing", joins "T,B,P", ends "M,F"; "" is the empty list.
// Throw InputError that names the option, the item and what was expected.
std::vector<TipKind> parse_tips(const std::string& text);
std::vector<TokenKind> parse_joins(const std::string& text, const std::string& option = "joins");
std::vector<TokenKind> parse_ends(const std::string& text);
// Some routing must be possible: a tip, and either an end or a join. And no more blocks and motors
// than can be, and no joins beside ends where blocks stand in series.
void validate(const PartSet& parts);

std::string tips_text(const PartSet& parts);
std::string joins_text(const PartSet& parts);
std::string beside_text(const PartSet& parts);
std::string ends_text(const PartSet& parts);

// Each kind on a carriage as often as there are carriages. Tendons made of what is left with 0
// are not actuated.
PartSet with_carriages(const PartSet& parts, int carriages);

}  // namespace reeve::search
