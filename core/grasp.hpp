// Which fingers an object holds while the motor moves the others, and which way the carriage moves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// Fingers that are not held close (pull) or open again (release).
struct Grasp {
  std::uint64_t held = 0;  // bit f-1: finger f is held

  bool holds(int finger) const { return (held >> (finger - 1) & 1U) != 0; }
  friend bool operator==(const Grasp&, const Grasp&) = default;
};

enum class Direction : std::uint8_t {
  pull,     // the carriage draws the tendons in
  release,  // the fingers draw them out again
};

Grasp hold(const std::vector<int>& fingers);
std::vector<int> held_fingers(Grasp grasp);

// "none", "1", "1,3"
std::string to_text(Grasp grasp);
// The reverse; nothing of what is no such text, or names other fingers.
std::optional<Grasp> grasp_named(const std::string& text, int fingers);
// Throws InputError: the text, the offending item, and the fingers that there are.
Grasp parse_grasp(const std::string& text, int fingers);

struct WeightedGrasp {
  Grasp grasp;
  double weight = 1;
};
using GraspSet = std::vector<WeightedGrasp>;

// none held, and each one finger held
GraspSet single_grasps(int fingers);
// every set of held fingers but the one that leaves nothing to close
GraspSet all_grasps(int fingers);
// finger 1 held: the grasp of the paper's derivations
GraspSet paper_grasps();
// "single", "all", "paper", or held lists with weights such as "none:2/1/1,2:0.5"
GraspSet parse_grasps(const std::string& text, int fingers);
// Whether renaming fingers 1 … n leaves the set as it is.
bool treats_fingers_alike(const GraspSet& grasps, int fingers);
std::string to_text(const GraspSet& grasps);

}  // namespace reeve::core
