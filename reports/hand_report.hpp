// Report of a routing in a hand, for people and programs.
#pragma once

#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/shown_hand.hpp"

namespace reeve::reports {

// Forces by finger and grasp; the fingers, and what they ask of the motor.
std::vector<Section> hand_sections(const ShownHand& hand);

// Adds "fingers", "grasps" and "motor" to the objectives of the hand.
void add_hand(Json& target, const ShownHand& hand);

}  // namespace reeve::reports
