// Report of a routing in a hand, and of the closing of its fingers, for people and programs.
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

// A table of joint angles over excursion for each kind of finger, and the order of the stops.
std::vector<Section> closing_sections(const std::vector<ShownClosing>& closings);

Json closings_json(const std::vector<ShownClosing>& closings);

// "finger 1", "fingers 1, 2"
std::string fingers_text(const ShownClosing& closing);

}  // namespace reeve::reports
