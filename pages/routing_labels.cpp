#include "pages/routing_labels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace reeve::pages {

std::string grasp_words(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  if (held.empty()) return "no finger held";
  return fmt::format("finger{} {} held", held.size() > 1 ? "s" : "", fmt::join(held, ", "));
}

std::string grasp_id(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  return held.empty() ? "held-none" : fmt::format("held-{}", fmt::join(held, "-"));
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
