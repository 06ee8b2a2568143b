// Finds the segment at the hand for each motor-side segment: a sheath leads from one to the other.
// The letters run in walk order; the Exo-Glove II paper has a, b, c, d beside T1, T2, T3, T4
// whatever the walk. The segment at the hand does not depend on either.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/network.hpp"

namespace reeve::core {

struct MotorSide {
  std::size_t motor_side = 0;  // in Network::segments
  std::size_t hand = 0;        // segment that its sheath leads to: a strand, or another at the hand
};

// In walk order.
std::vector<MotorSide> motor_sides(const Network& network);

// The ends that a grasp can lock.
MotorEnds motor_ends(const Network& network);

// Number of motors, and M, M2, … of one.
int carriage_count(const Network& network);
std::string motor_name(int carriage);

// The motor-side segment whose sheath leads to that strand, if it has one.
std::optional<Segment> motor_side_at(const Network& network, const Segment& strand);

// True if a is beside T1, b beside T2 and so on, wherever a letter is beside a strand at all.
bool letters_match_strands(const Network& network);

}  // namespace reeve::core
