// Contacts that are not alike, drawn and solved by the reference model: nothing of the library has
// a part in it, its random numbers neither.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/support/reference_model.hpp"

namespace reeve::testing {

struct ContactDeviations {
  double relative = 0.04;  // of tubes and sheaths, over their exponents
  double bearing_relative = 0.1;
};

// Ranges of what all parts of a kind have in common; uniform and independent.
struct KindRanges {
  double least_mu = 0.05;  // of tubes and of sheaths
  double greatest_mu = 0.2;
  double bearing_mu_relative = 0.5;
  double sheath_angle_relative = 0.2;
};

// Means over the grasps, by draw.
struct ScatteredObjectives {
  std::vector<double> uniformity;  // least over greatest strand tension
  std::vector<double> efficiency;  // work on the fingers over that of the motor
};

// In each draw every contact has an exponent of its own, normal about that of its kind, which is
// drawn first if ranges are given. With one seed the kinds of a draw are the same for all routings,
// and so are the factors of contacts at the same place of two walks.
ScatteredObjectives scattered_objectives(const std::string& word,
                                         const std::vector<std::set<int>>& grasps,
                                         const ReferenceHardware& hardware,
                                         const ContactDeviations& deviations, std::size_t draws,
                                         std::uint64_t seed,
                                         const std::optional<KindRanges>& ranges = std::nullopt);

}  // namespace reeve::testing
