// Checks if the hardware suffices for the results of a hand that are asked for.
#pragma once

#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"

namespace reeve::cli {

// If the hardware has a hand, fingers 1 … n must be known. Throws InputError.
void require_known_fingers(const Hardware& hardware, int fingers);

// `option` asks for these; some need a hand. Throws InputError.
void require_hand_for(const std::string& option, const std::vector<Objective>& objectives,
                      const Hardware& hardware);
void require_hand_for(const std::string& option, const Score& score, const Hardware& hardware);

}  // namespace reeve::cli
