// Why a grasp has no tensions.
#pragma once

#include <cstdint>

#include "numerics/floors.hpp"

namespace reeve::core {

enum class TensionFault : std::uint8_t {
  none,
  no_motor,                // a tendon or a tree of tendons hangs on no motor (require_actuated)
  blocks_free,             // blocks can move against each other
  finger_opens,            // the motion asks a finger to open
  ends_unlike_at_seizure,  // ends at motors do not all travel D, beside a seized contact
  beside_second_tendon,    // seized contacts or slack, and a finger that trees share
  uneven_sharing,          // closings of a tree that shares fingers are not all in one ratio
  slack_remains,           // no tendon is taut after the whole travel
  nothing_pulls,           // every end at a motor stands still
  motor_is_pulled,         // ends that move against the others pull it harder than these
  out_of_double,           // friction is so strong that no double holds the tensions
};

// "a finger would have to open", behind "cannot be computed: ".
const char* words_of(TensionFault fault);

}  // namespace reeve::core
