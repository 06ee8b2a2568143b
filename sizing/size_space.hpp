// The variables of one routing: its dimensions that may be chosen, those as one that stay equal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"
#include "numerics/minimise.hpp"
#include "sizing/dimension.hpp"
#include "sizing/placed_dimension.hpp"

namespace reeve::sizing {

// One or more dimensions that have one value.
struct SizeVariable {
  std::string name;  // "sheath_angle[1]", "tip_angle[1,2]"
  const char* unit = "";
  std::vector<std::size_t> dimensions;  // indices into the space
  Interval bounds;
  double nominal = 0;  // mean of several dimensions
};

struct SizeSpace {
  std::vector<PlacedDimension> dimensions;
  std::vector<SizeVariable> variables;
};

// A range that names dimensions rules over one that gives all of a quantity; what the routing does
// not have is passed over. Throws InputError if dimensions that are to be equal have no value in
// common.
SizeSpace size_space(const Network& network, const Hardware& hardware,
                     const std::vector<VariedRange>& ranges, const std::vector<EqualGroup>& equal);

// Throws InputError if no routing has a range or a group, or if one repeats another.
void require_ranges_to_match(const std::vector<Routing>& routings, const Hardware& hardware,
                             const std::vector<VariedRange>& ranges,
                             const std::vector<EqualGroup>& equal);

}  // namespace reeve::sizing
