// A grasp: the fingers that an object holds while the motors move the others, and how the carriages
// move.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/routing.hpp"

namespace reeve::core {

// Travel of each motor's carriage over D, the common measure of travel. A carriage that travels
// less than 0 lets its tendons out while others pull. All carriages travel D unless it is given.
struct CarriageTravels {
  std::uint8_t given = 0;  // motors, or 0
  std::array<double, max_carriages> over_D{1, 1, 1, 1, 1, 1};

  friend bool operator==(const CarriageTravels&, const CarriageTravels&) = default;
};

// Fingers that are not held close (pull) or open again (release).
struct Grasp {
  std::uint64_t held = 0;  // bit f-1: finger f is held
  CarriageTravels carriages{};

  double travel(int carriage) const {
    return carriages.over_D[static_cast<std::size_t>(carriage) - 1];
  }
  bool holds(int finger) const { return (held >> (finger - 1) & 1U) != 0; }
  friend bool operator==(const Grasp&, const Grasp&) = default;
};

enum class Direction : std::uint8_t {
  pull,     // the carriage draws the tendons in
  release,  // the fingers draw them out again
};

Grasp hold(const std::vector<int>& fingers);
std::vector<int> held_fingers(const Grasp& grasp);
// Travels of the carriages over D if they are given; otherwise empty.
std::vector<double> carriage_travels(const Grasp& grasp);

// "none", "1", "1,3", or with travels of the carriages "1,3@1,-0.5"
std::string to_text(const Grasp& grasp);
// The reverse, without travels; nothing of what is no such text, or names other fingers.
std::optional<Grasp> grasp_named(const std::string& text, int fingers);
// Travels can be given if there are several motors. Throws InputError: the text, the offending
// item, and the fingers or motors that there are.
Grasp parse_grasp(const std::string& text, int fingers, int motors = 1);

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
// "single", "all", "paper", or grasps with weights such as "none:2/1/1,2:0.5" or "none@1,-1:2/1"
GraspSet parse_grasps(const std::string& text, int fingers, int motors = 1);
// True if renaming fingers 1 … n leaves the set as it is.
bool treats_fingers_alike(const GraspSet& grasps, int fingers);
std::string to_text(const GraspSet& grasps);

}  // namespace reeve::core
