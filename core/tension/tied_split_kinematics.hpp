// Computes the closing of fingers and the travel of blocks if contacts are seized and blocks tie
// tendons together, as split_kinematics.hpp says.
#pragma once

#include "core/tension/split_kinematics.hpp"

namespace reeve::core {

SplitClosing tied_split_closing(const Network& network, const Mechanics& mechanics, Grasp grasp);

}  // namespace reeve::core
