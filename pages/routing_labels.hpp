// What routings and grasps are called on a page.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"

namespace reeve::pages {

// "no finger held", "finger 1 held", "fingers 1, 3 held"
std::string grasp_words(Grasp grasp);
// "held-none", "held-1", "held-1-3": part of the id of an element or a figure
std::string grasp_id(Grasp grasp);

struct NamedRouting {
  std::string name;  // "" if it has none
  std::string word;
};

// The name, or the word where there is none, or both where another of that name is among them: no
// two are alike, as long as no two words are.
std::vector<std::string> labels(const std::vector<NamedRouting>& routings);

}  // namespace reeve::pages
