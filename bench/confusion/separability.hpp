// Separability: tells if the readings of planted data distinguish the hidden cause from every other
// one, and from none, at all.
//
//   margin    = ln L(hidden cause) - max over other causes of ln L(that cause in its place)
//   over_none = ln L(hidden cause) - ln L(no cause in its place)
//
// L: how likely all readings are, those that a diagnosis holds out among them, under the noise and
// the scatter of mountings as they were planted, normal or Student's t. Neither is estimated, and
// no rule of the diagnosis enters: what is common with it is how causes change forecasts, and that
// friction coefficients are free beside each cause, and without any: a drag of bearings that passes
// for another friction of theirs is small over none, however far it is from the hardware's. With
// two hidden causes the other one stays, and the lesser figure counts.
#pragma once

#include <optional>
#include <string>

#include "readings/measured_data.hpp"
#include "tests/support/planting.hpp"

namespace reeve::bench {

struct Separability {
  double margin = 0;
  std::string nearest;  // nearest of the other causes
  double over_none = 0;
};

// Nothing without a hidden cause of the library.
std::optional<Separability> separability(const testing::Planted& planted,
                                         const diagnosis::MeasuredData& data);

}  // namespace reeve::bench
