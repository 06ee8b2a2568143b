// All objectives side by side, as they stand without a script.
#pragma once

#include <vector>

#include "pages/exploration/exploration_pictures.hpp"

namespace reeve::pages {

// Lines of the best and of the known routings over these objectives, and in grey how many of all
// designs have a value.
ExplorationPicture parallel_picture(const std::vector<PageDesign>& designs,
                                    const std::vector<Objective>& shown);

}  // namespace reeve::pages
