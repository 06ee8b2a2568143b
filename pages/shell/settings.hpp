// Settings that a result depends on, in a page: the hardware, the effects of a model, the grasps,
// and the command that gives the page again.
#pragma once

#include <string>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "pages/shell/html_table.hpp"

namespace reeve::pages {

// Coefficients by kind of contact, then whatever differs at a finger or a contact, then lengths.
HtmlTable hardware_table(const Hardware& hardware);

// "finger 1: joints with arms 11, 8 mm, …"; "" without joints.
std::string hand_text(const Hardware& hardware);

HtmlTable grasp_table(const GraspSet& grasps);

// A section with heading. `more`: HTML between the tables and the command.
std::string settings_html(const Model& model, std::uint64_t unconverged, const GraspSet& grasps,
                          const std::string& command, const std::string& more = "");

}  // namespace reeve::pages
