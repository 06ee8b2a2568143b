#include "pages/exploration/phrases.hpp"

#include <fmt/format.h>

#include <cmath>

#include "pages/exploration/objective_title.hpp"

namespace reeve::pages {

std::string enumeration(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
}

std::string titles(const std::vector<Objective>& objectives) {
  std::vector<std::string> names;
  for (const Objective objective : objectives) names.push_back(objective_title(row(objective)));
  return enumeration(names);
}

std::string four_digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

}  // namespace reeve::pages
