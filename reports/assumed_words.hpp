// Names the assumptions of a result, for the first screen of terminal and page.
#pragma once

#include <string>
#include <vector>

#include "causes/model.hpp"

namespace reeve::reports {

// "Assumed: tubes mu 0.18 over 180 deg, …; only capstan friction"
std::string assumed_text(const Model& model);

// A sentence for each angle of so many turns that degrees may be meant.
std::vector<std::string> angle_notes(const Hardware& hardware);

}  // namespace reeve::reports
