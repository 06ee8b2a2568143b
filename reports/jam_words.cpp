#include "reports/jam_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t named_jams = 4;

}  // namespace

std::string held_words(Grasp grasp) {
  const std::vector<int> fingers = held_fingers(grasp);
  if (fingers.empty()) return "no finger is held";
  if (fingers.size() == 1) return fmt::format("finger {} is held", fingers.front());
  return fmt::format("fingers {} and {} are {} held",
                     fmt::join(fingers.begin(), fingers.end() - 1, ", "), fingers.back(),
                     fingers.size() == 2 ? "both" : "all");
}

std::string jam_sentence(const std::vector<Grasp>& smallest, const ObjectiveValues& values,
                         int fingers) {
  if (fingers == 0) return "It has no finger that an object could hold";
  const double jams = value(values, Objective::jams_all);
  if (!std::isfinite(jams)) return "It has too many fingers to try in which grasps it jams";
  if (smallest.empty()) return "It never jams unless all fingers are held";
  if (smallest.front() == Grasp{}) return "It jams in every grasp";
  std::string text;
  const std::size_t named = std::min(named_jams, smallest.size());
  for (std::size_t i = 0; i < named; ++i) {
    text += (i == 0 ? "" : ", or ") + held_words(smallest[i]);
  }
  if (smallest.size() > named) text += fmt::format(", or in {} more ways", smallest.size() - named);
  return fmt::format("It jams when {} ({:.0f} of {:.0f} grasps)", text, jams,
                     std::ldexp(1.0, fingers) - 1);
}

std::string jams_field(const std::vector<Grasp>& smallest) {
  std::string field;
  for (const Grasp& grasp : smallest) {
    field += fmt::format("{}{}", field.empty() ? "" : " ",
                         grasp == Grasp{} ? "none" : held_field(grasp));
  }
  return field;
}

Json grasps_json(const std::vector<Grasp>& grasps) {
  return list_json(grasps, [](Grasp grasp) { return Json(held_fingers(grasp)); });
}

}  // namespace reeve::reports
