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
  bool anchored = false;  // a tendon may be tied at a fingertip: 1x
  int blocks = 0;         // at most so many floating blocks in a routing
};

// Of floating blocks in generated routings.
inline constexpr int max_generated_blocks = 8;

PartSet paper_parts();  // tip tube; joins T, P; ends M, F
PartSet full_parts();   // + tip bearing, + join B
PartSet all_parts();    // + anchored tips, + one floating block

// Comma-separated names: tips "tube,bearing", joins "T,B,P", ends "M,F"; "" is the empty list.
// Throw InputError that names the item and what was expected.
std::vector<TipKind> parse_tips(const std::string& text);
std::vector<TokenKind> parse_joins(const std::string& text);
std::vector<TokenKind> parse_ends(const std::string& text);
// Some routing must be possible: a tip, and either an end or a join. And no more blocks than can
// be.
void validate(const PartSet& parts);

std::string tips_text(const PartSet& parts);
std::string joins_text(const PartSet& parts);
std::string ends_text(const PartSet& parts);

// The parts that do not hang on the carriage: tendons made of them alone are not actuated.
PartSet passive_parts(const PartSet& parts);

}  // namespace reeve::search
