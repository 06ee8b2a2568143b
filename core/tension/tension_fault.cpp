#include "core/tension/tension_fault.hpp"

namespace reeve::core {

const char* words_of(TensionFault fault) {
  switch (fault) {
    case TensionFault::none:
    case TensionFault::out_of_double:
      break;
    case TensionFault::no_motor:
      return "a tendon hangs on no motor";
    case TensionFault::blocks_free:
      return "blocks are free to move against each other";
    case TensionFault::finger_opens:
      return "a finger would have to open";
    case TensionFault::ends_unlike_at_seizure:
      return "beside a seized contact every end at a motor has to travel alike, without slack";
    case TensionFault::beside_second_tendon:
      return "beside a second tendon on a finger, seized contacts and slack are not computed";
    case TensionFault::uneven_sharing:
      return "a block ties several tendons unevenly to a finger that has a second tendon";
    case TensionFault::slack_remains:
      return "every tendon is still slack after the whole carriage travel";
    case TensionFault::nothing_pulls:
      return "no end at a motor moves";
    case TensionFault::motor_is_pulled:
      return "the ends that move against the others pull the motor harder than these";
  }
  return "friction is so strong that tensions fall out of range";
}

}  // namespace reeve::core
