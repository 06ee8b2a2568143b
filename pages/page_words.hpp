// Names of objectives, grasps and routings on a page.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "reports/document/document.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

// "uniformity mean"
std::string objective_title(const ObjectiveRow& row);
// "uniformity mean, efficiency mean"
std::string objective_titles(const std::vector<Objective>& objectives);

// The texts of lines as sentences, with a full stop each.
std::vector<std::string> sentences_of(const std::vector<DocumentLine>& lines);

// "0.9958"; "-" of what there is none of, as in the terminal.
std::string four_digits(double value);

// "uniformity mean and sheaths"
std::string titles(const std::vector<Objective>& objectives);

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
