// Whether an exploration was made under other settings than those that hold now.
#pragma once

#include <string>

#include "causes/model.hpp"
#include "core/grasp.hpp"

namespace reeve::reports {

// What differs, of hardware, model and grasps, by the summary.json of the exploration: "hardware,
// grasps"; "" if nothing does or if the text is no such file.
std::string differing_settings(const std::string& summary, const Model& model,
                               const GraspSet& grasps);

}  // namespace reeve::reports
