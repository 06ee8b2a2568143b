// Dimensions (dimension.hpp) where they are: in a routing with a hardware, of which they are read
// and in which they are set.
#pragma once

#include <vector>

#include "core/hardware.hpp"
#include "core/network.hpp"
#include "sizing/dimension.hpp"

namespace reeve::sizing {

// A dimension where it is: in a routing with a hardware. A contact has the name that the hardware
// gives it, otherwise that in walk order.
struct PlacedDimension {
  SizedDimension dimension;
  double nominal = 0;
};

// All of a quantity that a routing has. Of sheath angles: those of fingers, then, as contacts,
// those of sheaths that lead to no finger. What the hardware sets for single contacts is theirs,
// and not the finger's. Fingers with joints have arms, and close by their excursions.
std::vector<PlacedDimension> dimensions_of(const Network& network, const Hardware& hardware,
                                           SizedQuantity quantity);

void set(Hardware& hardware, const SizedDimension& dimension, double value);

}  // namespace reeve::sizing
