// The word as the reference model reads it: tokens to segments and contacts.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reeve::testing::reference {

enum class Place { strand, motor_side, hand };

struct Segment {
  std::string name;
  Place place;
  int finger;        // 0 if it is no strand
  int carriage = 0;  // of motor sides
  bool extensor = false;
};

// A tendon round a sheave of a block, or over the arms of a bar.
struct BlockPass {
  std::string block;
  std::size_t contact;
  bool bar;
  double left, right;  // a bar's tension ratio as written
};

// A tendon tied to a block: to its tail, or to its becket.
struct BlockEnd {
  std::string block;
  std::size_t segment;
  bool becket;
};

struct Tendon {
  std::vector<std::string> tokens;
  std::vector<Segment> segments;
  std::vector<std::string> kinds;   // of contact k, between segments k and k + 1 (cyclically)
  std::vector<std::size_t> places;  // of contact k: the token that it belongs to
  std::set<int> fingers;
  std::vector<BlockPass> passes;
  std::vector<BlockEnd> ends;
  bool loop = false;

  // The names of the segments on either side of contact k.
  std::pair<std::string, std::string> sides(std::size_t k) const {
    return {segments[k].name, segments[(k + 1) % segments.size()].name};
  }
};

// One for each walk. Throws std::invalid_argument on a token that it does not know, and on one that
// stands where it cannot: 1x inside a walk, Y1k but at an end.
std::vector<Tendon> read_tendons(const std::string& word);

}  // namespace reeve::testing::reference
