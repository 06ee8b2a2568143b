// What is drawn of two fingers, as the tests of draws and of places ask for it.
#pragma once

#include <cstddef>

#include "search/uncertainty/uncertainty.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {

inline UncertaintyOptions options_for(std::size_t draws) {
  UncertaintyOptions options;
  options.grasps = single_grasps(2);
  options.order = {Objective::uniformity_mean, Objective::efficiency_mean};
  options.draws = draws;
  options.threads = 1;
  return options;
}

// Returns options in which contacts are alike: what a kind has in common varies alone.
inline UncertaintyOptions options_of_like_contacts(std::size_t draws) {
  UncertaintyOptions options = options_for(draws);
  options.nominal.hardware.scatter = {0, 0};
  return options;
}

}  // namespace reeve::testing
