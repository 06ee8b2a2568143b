// Which dimensions may be chosen, in what bounds, and which of them must stay equal, as the user
// says it.
#pragma once

#include <string>
#include <vector>

#include "numerics/minimise.hpp"
#include "sizing/dimension.hpp"

namespace reeve::sizing {

struct VariedRange {
  DimensionName name;
  Interval bounds;
  std::string text;  // as it was given, for messages: "vary 'hand_mm=50..90'", "h.toml:3:1"
};

// "sheath_angle[1]=3..9". Throws InputError.
VariedRange parse_varied(const std::string& text);
// Of a name and bounds that stand apart; `text` as above.
VariedRange varied_range(const std::string& name, const Interval& bounds, const std::string& text);

// Dimensions that are to be equal, so that the fingers' parts are alike.
struct SameGroup {
  DimensionName name;
  std::string text;
};

// "tips", "sheaths,tips", "sheath_angle[2,3,4]": what each item names is equal. Throws InputError.
std::vector<SameGroup> parse_same(const std::string& text);

}  // namespace reeve::sizing
