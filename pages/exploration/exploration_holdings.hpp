// Selects the designs that the page of an exploration holds, and those that it has drawings of;
// notes on the others.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pages/exploration/exploration_designs.hpp"
#include "pages/exploration/exploration_details.hpp"
#include "pages/exploration/exploration_page.hpp"

namespace reeve::pages {

struct HeldDesigns {
  std::vector<PageDesign> designs;
  std::string packed;  // their columns
  std::size_t listed = 0;
};

// As many as fit.
HeldDesigns held_designs(const ExploreReport& report);

// Unless it was said how many, further ones are drawn in the first grasp, so that whatever is
// pointed at near the top has a drawing.
DetailedDesigns detailed_designs(const ExplorationView& view);

std::string held_text(const ExploreReport& report, std::size_t held);
std::string sample_text(std::ptrdiff_t others);
std::string details_text(const ExplorationView& view, const DesignDetails& details);

// {word: why it has no place in the list}: of known routings and of the trade-off.
Json standings_json(const ExploreReport& report);

}  // namespace reeve::pages
