// A grasp: the fingers that an object holds while the motors move the others, how the carriages
// move, and which ends at motors are locked.
//
// A locked end stands still while its carriage moves on: its travel is 0. Its segment still carries
// tension, which its lock takes, and no motor.
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

// Only the first motor-side segments can be locked, one for each bit of Grasp::locked.
inline constexpr int most_lockable = 64;

// Fingers that are not held close (pull) or open again (release).
struct Grasp {
  std::uint64_t held = 0;  // bit f-1: finger f is held
  CarriageTravels carriages{};
  std::uint64_t locked = 0;  // bit k-1: the end of the k-th motor-side segment is locked

  bool locks(int motor_side) const {
    return motor_side <= most_lockable && (locked >> (motor_side - 1) & 1U) != 0;
  }
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

// Names of the locked ends: b, c.
std::vector<std::string> locked_ends(const Grasp& grasp);
// "", or ", ends b, c locked".
std::string locked_words(const Grasp& grasp);

// Ends at motors that can be locked: for each motor-side segment, the bits of those that move as
// one with it: both sides of a pulley.
using MotorEnds = std::vector<std::uint64_t>;

// "none", "1", "1,3", with a locked end "1,b", or with travels of the carriages "1,3@1,-0.5"
std::string to_text(const Grasp& grasp);
// The reverse of fingers alone; nothing of what is no such text, or names other fingers.
std::optional<Grasp> grasp_named(const std::string& text, int fingers);
// Travels can be given if there are several motors. Throws InputError: the text, the offending
// item, and the fingers, ends or motors that there are.
Grasp parse_grasp(const std::string& text, int fingers, int motors = 1, const MotorEnds& ends = {});

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
GraspSet parse_grasps(const std::string& text, int fingers, int motors = 1,
                      const MotorEnds& ends = {});
// True if renaming fingers 1 … n leaves the set as it is. Locked ends are of certain fingers.
bool treats_fingers_alike(const GraspSet& grasps, int fingers);
bool treats_motors_alike(const GraspSet& grasps);
// The grasp with no finger held.
Grasp opened(const Grasp& grasp);
// The grasps with no finger held, each once: how carriages travel and which ends are locked.
std::vector<Grasp> opened(const GraspSet& grasps);
std::string to_text(const GraspSet& grasps);

}  // namespace reeve::core
