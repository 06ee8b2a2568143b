#include "pages/exploration/objective_title.hpp"

#include <algorithm>

namespace reeve::pages {

std::string objective_title(const ObjectiveRow& row) {
  std::string title = row.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::string objective_titles(const std::vector<Objective>& objectives) {
  std::string titles;
  for (const Objective objective : objectives) {
    titles += (titles.empty() ? "" : ", ") + objective_title(row(objective));
  }
  return titles;
}

}  // namespace reeve::pages
