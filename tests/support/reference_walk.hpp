// The word as the reference model reads it: tokens to segments and contacts.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace reeve::testing::reference {

enum class Place { strand, motor_side, hand };

struct Segment {
  std::string name;
  Place place;
  int finger;  // 0 if it is no strand
};

struct Tendon {
  std::vector<Segment> segments;
  std::vector<std::string> kinds;  // of contact k, between segments k and k + 1 (cyclically)
  std::set<int> fingers;
  bool loop = false;
};

// One for each walk. Throws std::invalid_argument on a token that it does not know.
std::vector<Tendon> read_tendons(const std::string& word);

}  // namespace reeve::testing::reference
