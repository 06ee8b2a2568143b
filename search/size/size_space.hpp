// Which dimensions may be chosen, in what bounds, and which of them must stay equal: from what the
// user writes to the variables of one routing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"
#include "numerics/minimise.hpp"
#include "search/size/dimension.hpp"

namespace reeve::search {

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

// One or more dimensions that have one value.
struct SizeVariable {
  std::string name;  // "sheath_angle[1]", "tip_angle[1,2]"
  const char* unit = "";
  std::vector<std::size_t> dimensions;  // in the space
  Interval bounds;
  double nominal = 0;  // of several, the mean
};

struct SizeSpace {
  std::vector<PlacedDimension> dimensions;
  std::vector<SizeVariable> variables;
};

// A range that names dimensions rules over one that gives all of a quantity; what the routing does
// not have is passed over. Throws InputError if dimensions that are to be equal have no value in
// common.
SizeSpace size_space(const Network& network, const Hardware& hardware,
                     const std::vector<VariedRange>& ranges, const std::vector<SameGroup>& same);

// Throws InputError of a range or a group that none of the routings has, and of one that says again
// what another one says.
void require_ranges_to_match(const std::vector<Routing>& routings, const Hardware& hardware,
                             const std::vector<VariedRange>& ranges,
                             const std::vector<SameGroup>& same);

}  // namespace reeve::search
