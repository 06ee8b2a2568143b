// Ranges of what is said of a hand.
#pragma once

#include <optional>

#include "core/error.hpp"
#include "core/hardware.hpp"

namespace reeve::core {

// The first of the joints, forces and motor that is out of its range or lacks what it needs.
std::optional<InputFault> hand_fault(const Hardware& hardware);

}  // namespace reeve::core
