// Contacts that are not alike, drawn and solved by the reference model: nothing of the library has
// a part in it, its random numbers neither.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/support/reference_model.hpp"

namespace reeve::testing {

struct ContactDeviations {
  double relative = 0.04;  // of tubes and sheaths, over their exponents
  double bearing_relative = 0.1;
};

// Returns for each draw the mean over the grasps of the least over the greatest strand tension. In
// each draw every contact has an exponent of its own, normal about that of its kind.
std::vector<double> scattered_uniformities(const std::string& word,
                                           const std::vector<std::set<int>>& grasps,
                                           const ReferenceHardware& hardware,
                                           const ContactDeviations& deviations, std::size_t draws,
                                           std::uint64_t seed);

}  // namespace reeve::testing
