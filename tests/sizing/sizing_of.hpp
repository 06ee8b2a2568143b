// Sizing one routing in a line, for tests of it.
#pragma once

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "sizing/size.hpp"

namespace reeve::testing {

inline SizingOptions sizing(const std::string& goal, const std::vector<std::string>& varied,
                            int fingers = 2) {
  SizingOptions options;
  options.grasps = single_grasps(fingers);
  options.goal = parse_goal(goal);
  for (const std::string& text : varied) options.varied.push_back(parse_varied(text));
  options.robust = false;
  options.threads = 1;
  return options;
}

inline SizingOptions aiming(const std::string& target, const std::vector<std::string>& varied,
                            int fingers = 2) {
  SizingOptions options = sizing("uniformity", varied, fingers);
  options.goal = parse_target(target, fingers);
  options.target_grasps = parse_grasps("none", fingers);
  return options;
}

inline SizedDesign sized(const std::string& word, const SizingOptions& options) {
  return size({parse_routing(word)}, options).designs.at(0);
}

inline std::vector<double> values_of(const SizedDesign& design) {
  std::vector<double> values;
  for (const SizedVariable& variable : design.variables) values.push_back(variable.value);
  return values;
}

}  // namespace reeve::testing
