// What planting asks of words and of the names of segments.
#pragma once

#include <set>
#include <string>

#include "tests/support/reference_walk.hpp"

namespace reeve::testing {

inline bool is_strand(const std::string& segment) { return segment[0] == 'T'; }

inline bool is_motor_side(const std::string& segment) { return segment.size() == 1; }

// 0 if it is none.
inline int finger_of_strand(const std::string& segment) {
  return is_strand(segment) ? (std::stoi(segment.substr(1)) + 1) / 2 : 0;
}

inline std::set<int> fingers_of(const std::string& word) {
  std::set<int> fingers;
  for (reference::Tendon& tendon : reference::read_tendons(word)) fingers.merge(tendon.fingers);
  return fingers;
}

inline bool has_bearing(const std::string& word) {
  return word.find_first_of("PBb") != std::string::npos;
}

}  // namespace reeve::testing
