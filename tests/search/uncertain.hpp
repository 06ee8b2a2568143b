// What is drawn of two fingers, as the tests of draws and of places ask for it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::testing {

inline std::vector<Routing> parsed(const std::vector<std::string>& words) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(parse_routing(word));
  return routings;
}

inline UncertaintyOptions options_for(std::size_t draws) {
  UncertaintyOptions options;
  options.grasps = single_grasps(2);
  options.order = {Objective::uniformity_mean, Objective::efficiency_mean};
  options.draws = draws;
  options.threads = 1;
  return options;
}

}  // namespace reeve::testing
