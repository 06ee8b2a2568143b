#include "pages/page_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace reeve::pages {

std::string objective_title(const ObjectiveRow& row) {
  std::string title = row.name;
  std::ranges::replace(title, '_', ' ');
  return title;
}

std::string objective_titles(const std::vector<Objective>& objectives) {
  return joined(objectives, ", ",
                [](Objective objective) { return objective_title(row(objective)); });
}

std::string titles(const std::vector<Objective>& objectives) {
  std::vector<std::string> names;
  for (const Objective objective : objectives) names.push_back(objective_title(row(objective)));
  return enumerated(names);
}

std::vector<std::string> sentences_of(const std::vector<DocumentLine>& lines) {
  std::vector<std::string> sentences;
  for (const DocumentLine& line : lines) sentences.push_back(line.text + ".");
  return sentences;
}

std::string four_digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string grasp_words(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  const std::vector<double> travels = carriage_travels(grasp);
  std::string ends = locked_words(grasp);
  if (!travels.empty()) ends += fmt::format(", carriages travel {}", fmt::join(travels, ", "));
  if (held.empty()) return "no finger held" + ends;
  return fmt::format("finger{} {} held{}", held.size() > 1 ? "s" : "", fmt::join(held, ", "), ends);
}

std::string grasp_id(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  std::string id = held.empty() ? "held-none" : fmt::format("held-{}", fmt::join(held, "-"));
  for (const std::string& end : locked_ends(grasp)) id += "-" + end;
  for (const double travel : carriage_travels(grasp)) id += fmt::format("_{}", travel);
  return id;
}

std::vector<std::string> labels(const std::vector<NamedRouting>& routings) {
  std::map<std::string, int> uses;
  for (const NamedRouting& routing : routings) ++uses[routing.name];
  std::vector<std::string> result;
  for (const auto& [name, word] : routings) {
    if (name.empty()) {
      result.push_back(word);
    } else {
      result.push_back(uses[name] > 1 ? fmt::format("{}: {}", name, word) : name);
    }
  }
  return result;
}

}  // namespace reeve::pages
