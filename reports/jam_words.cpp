#include "reports/jam_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t named_jams = 4;

// Follows "their shares of its pull".
constexpr const char* assumption =
    "assume equal stiffness and no slack; a slack or softer tendon carries less";

std::string listed_ranks(const std::vector<std::size_t>& ranks) {
  std::string text = "Ranks ";
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    text += i == 0 ? "" : i + 1 == ranks.size() ? " and " : ", ";
    text += std::to_string(ranks[i]);
  }
  return text;
}

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

int tree_count(const Network& network) {
  std::set<std::size_t> trees;
  for (const TendonSpan& tendon : network.tendons) trees.insert(tendon.tree);
  return static_cast<int>(trees.size());
}

std::string shared_carriage_text(const Network& network) {
  const int trees = tree_count(network);
  if (trees < 2) return "";
  const bool tied = static_cast<std::size_t>(trees) < network.tendons.size();
  const int motors = carriage_count(network);
  if (motors > 1) {
    return fmt::format(
        "{} {} hang on {} carriages, which travel alike unless a grasp says "
        "otherwise (1@1,0.5): their shares of the pull {}",
        trees, tied ? "trees of tendons" : "tendons", motors, assumption);
  }
  return fmt::format("{} {} hang on one carriage: their shares of its pull {}", trees,
                     tied ? "trees of tendons" : "tendons", assumption);
}

std::vector<DocumentLine> shared_carriage_lines(const std::vector<ListedDesign>& shown) {
  std::vector<std::size_t> ranks;
  bool several_motors = false;
  for (const ListedDesign& design : shown) {
    const Network network = expand(parse_routing(design.ranked.design.word));
    if (tree_count(network) < 2) continue;
    ranks.push_back(design.ranked.rank);
    several_motors |= carriage_count(network) > 1;
  }
  if (ranks.empty()) return {};
  const std::string whose = ranks.size() == 1 ? fmt::format("Rank {} has", ranks.front())
                            : ranks.size() == shown.size() ? "All of these have"
                                                           : listed_ranks(ranks) + " have";
  return {
      {fmt::format("{} several tendons on {}: their shares of its pull {}", whose,
                   several_motors ? "one carriage, or on carriages that travel as the grasps say"
                                  : "one carriage",
                   assumption)}};
}

}  // namespace reeve::reports
