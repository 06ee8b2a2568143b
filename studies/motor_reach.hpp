// What a motor of a given force and stroke does with a hand.
//
//   share of the wanted   least F_f / F_w,f over fingers f and grasps, F_f the fingertip force at
//   the
//                         motor's force: so much of all wanted forces can be had at once. 0 if a
//                         finger that is not held cannot even close against its springs
//   closure               share of its range that the finger closes that closes least, the carriage
//                         going no further than the motor's stroke
#pragma once

#include <optional>
#include <vector>

#include "core/hand_closing.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"

namespace reeve::studies {

struct ForceReach {
  double motor_N = 0;
  // Of the wanted forces; infinite if no finger wants any.
  double share = 0;
  // The finger that has least of it, of several the one that asks for most motor force; 0: none
  // wants any.
  int weakest = 0;
  Grasp grasp{};  // and the grasp in which it has
  double asks_motor_N = 0;
  std::size_t joint = 0;  // its joint that gives first then, from 0
  double force_N = 0;     // what it presses with
};

struct StrokeReach {
  double stroke_mm = 0;  // what is used of it
  double closure = 0;
  std::vector<int> last;       // the fingers that close least
  std::vector<double> closed;  // share of each finger's range
};

// Adds a grasp: the pulls of the fingers per newton of motor tension, at their numbers.
void add_grasp(const Hand& hand, int fingers, Grasp grasp, const FingerArray& pulls,
               ForceReach& reach);

// The mechanics without the effects of a model, as for the whole stroke.
StrokeReach stroke_reach(const Hand& hand, const Network& network, const Mechanics& mechanics,
                         double limit_mm);

}  // namespace reeve::studies
