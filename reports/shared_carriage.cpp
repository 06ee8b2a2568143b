#include "reports/shared_carriage.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <set>

#include "core/motor_sides.hpp"
#include "core/notation.hpp"

namespace reeve::reports {
namespace {

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
