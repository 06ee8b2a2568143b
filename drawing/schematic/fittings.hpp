// Fittings of a schematic and their ports, before anything has a place. Fittings are fingers,
// blocks and bars, joins at the hand, sheaths, and pulleys on the carriage. Segments of tendon end
// at ports.
//
// A port faces down or up: that is where its line leaves. Passes, arms and beckets of a block face
// one way and its tails the other; a block is drawn upright (its tails below) or inverted,
// whichever lets more lines run straight on (face).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/network.hpp"

namespace reeve::drawing {

inline constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

enum class FittingKind : std::uint8_t { finger, block, join, sheath, pulley, clamp, bend };

// A turn is one leg of what lies on a half circle: a pass of a block, a join, a pulley. A bend is
// where a line turns back that would otherwise have to run upward, a clamp holds one end of what is
// fixed at both.
enum class PortRole : std::uint8_t {
  strand,
  turn,
  arm,
  becket,
  tail,
  pivot,
  hand_side,
  motor_side,
  clamp,
  bend,
};

constexpr bool is_tail(PortRole role) { return role == PortRole::tail || role == PortRole::pivot; }

struct FittingPort {
  std::size_t fitting = 0;
  PortRole role = PortRole::strand;
  std::size_t twin = nowhere;  // the other leg of a turn
  double offset = 0;           // distance from the fitting's middle, rightward
};

struct Fitting {
  FittingKind kind = FittingKind::finger;
  std::size_t index = 0;  // a finger's, counted from 0; of the network's blocks or contacts
  bool inverted = false;  // blocks and joins
  std::size_t level = 0;  // 0: the fingers; then downward
  // Tails, and the others likewise, as they stand from left to right.
  std::vector<std::size_t> ports;
  // The port that a sheath lies straight below.
  std::size_t carrier = nowhere;
  // The finger's fitting, if this one lies between its two strands and joins them.
  std::size_t inside = nowhere;
};

// Holds the end of a segment that has no port.
enum class LooseEnd : std::uint8_t { fixed, tied };

struct SegmentEnds {
  std::array<std::size_t, 2> port{nowhere, nowhere};  // ports of its begin and its end
  std::size_t via = nowhere;                          // the port of its bend
  std::size_t tendon = 0;
  LooseEnd loose = LooseEnd::fixed;
};

struct Fittings {
  std::vector<Fitting> fittings;  // the fingers first
  std::vector<FittingPort> ports;
  std::vector<SegmentEnds> segments;              // parallel to the network's
  std::vector<std::array<std::size_t, 2>> turns;  // [contact]: its ports, in walk order
  std::vector<std::size_t> blocks;                // [block of the network]: its fitting
  std::size_t sheath_level = 1;

  bool faces_down(std::size_t port) const;
  const Fitting& of(std::size_t port) const { return fittings[ports[port].fitting]; }
};

// Blocks, bars or anchored tips.
bool has_floating_parts(const Network& network);
bool is_anchored(const Network& network, int finger);

Fittings fittings(const Network& network);

// Sets `inverted`, `level` and `carrier`, and adds the bends of lines that would run upward.
void face(Fittings& all);

// Gives the ports of a fitting their offsets, in their order.
void place_ports(const Network& network, std::size_t fitting, Fittings& all);

// Distances from the middle of a block to its first and its last tail.
struct Tails {
  double first = 0;
  double last = 0;
};
Tails tails_of(const Fittings& all, std::size_t fitting);

// Y1; of unequal arms also the ratio of their tensions: W1 2:1.
std::string block_title(const core::Block& block);
double name_width(const core::Block& block);

}  // namespace reeve::drawing
