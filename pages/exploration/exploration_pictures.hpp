// The plots of an exploration as they stand without a script: for readers without JavaScript, for
// print, and for figures/.
#pragma once

#include <string>
#include <vector>

#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/exploration/exploration_spots.hpp"
#include "pages/shell/page.hpp"

namespace reeve::pages {

// A plot, and what it shows in words.
struct ExplorationPicture {
  Figure figure;
  std::string alt;
};

// The designs over two objectives, over `ranking` of which the front is; `advised` are marked.
ExplorationPicture pareto_picture(const std::vector<PageDesign>& designs,
                                  const std::vector<Objective>& ranking,
                                  const std::vector<AdvisedDesign>& advised = {});

// Those that the ranking counts first; where it counts one, uniformity or efficiency joins it.
TwoObjectives first_axes(const std::vector<Objective>& ranking);

}  // namespace reeve::pages
