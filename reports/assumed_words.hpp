// Names the assumptions of a result, for the first screen of terminal and page.
#pragma once

#include <string>
#include <vector>

#include "causes/model.hpp"

namespace reeve::reports {

// "Assumed, by default: tubes mu 0.18 over 180 deg, …; only capstan friction". Of a hardware of a
// file or of the catalogue this is named in place of the default.
std::string assumed_text(const Model& model);

// A sentence for each angle of so many turns that degrees may be meant.
std::vector<std::string> angle_notes(const Hardware& hardware);

}  // namespace reeve::reports
