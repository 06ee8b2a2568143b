#include "reports/jam_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "core/hand_pulls.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t named_jams = 4;

// Follows "their shares of its pull".
std::string assumption(const TendonParts& tendons) {
  const bool springs = std::ranges::any_of(
      tendons.own, [](const TendonHardware& own) { return own.stiffness_N_mm.has_value(); });
  const bool slack = std::ranges::any_of(
      tendons.own, [](const TendonHardware& own) { return own.slack_mm.has_value(); });
  if (springs) {
    return std::string(
               slack ? "follow from the springs and the slack given"
                     : "follow from the springs given, and assume no slack; a slack tendon carries "
                       "less") +
           "; jams and motor force leave out the stretch of springs";
  }
  if (slack) {
    return "follow from the slack given, and assume equal stiffness; a softer tendon carries less";
  }
  return "assume equal stiffness and no slack; a slack or softer tendon carries less";
}

// "M", "M and M3"
std::string motor_names(const std::vector<int>& carriages) {
  std::vector<std::string> names;
  for (const int carriage : carriages) names.push_back(motor_name(carriage));
  return enumerated(names);
}

std::string stall_words(const std::vector<int>& carriages) {
  return motor_names(carriages) + (carriages.size() == 1 ? " stalls" : " stall");
}

std::vector<int> carriages_of(const MotorGroup& group) {
  std::vector<int> carriages;
  for (std::size_t motor = 0; motor < max_carriages; ++motor) {
    if (group.has_motor(motor)) carriages.push_back(static_cast<int>(motor) + 1);
  }
  return carriages;
}

// " (M2 stalls)": a smallest jam is that of one tree, and so of one group. Of one group "".
std::string stalled_in(const Grasp& smallest, const MotorGroups& groups) {
  if (groups.count < 2) return "";
  for (const MotorGroup& group : groups) {
    if ((smallest.held & ~group.fingers) == 0) {
      return " (" + stall_words(carriages_of(group)) + ")";
    }
  }
  return "";
}

// Returns the grasp in which the motors of a group stall and the others go on.
Grasp stalled(const MotorGroup& group, int motors) {
  Grasp grasp{.held = group.fingers};
  grasp.carriages.given = static_cast<std::uint8_t>(motors);
  for (const int carriage : carriages_of(group)) {
    grasp.carriages.over_D[static_cast<std::size_t>(carriage) - 1] = 0;
  }
  return grasp;
}

// Carriages that travel alike stop with the first that is blocked.
std::string independence_words(const MotorGroups& groups) {
  if (groups.count < 2) return "";
  std::vector<int> all;
  for (const MotorGroup& group : groups) append(all, carriages_of(group));
  std::sort(all.begin(), all.end());
  const auto* const first =
      std::ranges::find_if(groups, [](const MotorGroup& group) { return group.has_motor(0); });
  return fmt::format(
      ". {} have nothing in common: if one of them stalls, these tables stop all carriages, but "
      "the others can go on, such as with held {}",
      all.size() == groups.count ? motor_names(all)
                                 : fmt::format("{} groups of motors", groups.count),
      to_text(stalled(*first, static_cast<int>(all.size()))));
}

}  // namespace

const char* const motors_together_note =
    "all motors count as one machine, also those that have nothing in common: their carriages "
    "travel as the grasps say, and one that is blocked stops all. Only motor forces are those of "
    "each group of motors";

std::string held_words(Grasp grasp) {
  const std::vector<int> fingers = held_fingers(grasp);
  if (fingers.empty()) return "no finger is held";
  if (fingers.size() == 1) return fmt::format("finger {} is held", fingers.front());
  return fmt::format("fingers {} and {} are {} held",
                     fmt::join(fingers.begin(), fingers.end() - 1, ", "), fingers.back(),
                     fingers.size() == 2 ? "both" : "all");
}

std::string jam_sentence(const std::vector<Grasp>& smallest, const ObjectiveValues& values,
                         const Network& network) {
  const int fingers = network.fingers;
  if (fingers == 0) return "It has no finger that an object could hold";
  const double jams = value(values, Objective::jams_all);
  if (!std::isfinite(jams)) return "It has too many fingers to try in which grasps it jams";
  if (smallest.empty()) return "It never jams unless all fingers are held";
  const MotorGroups groups = motor_groups(network);
  const bool has_motors = groups.count > 1 || (network.shared && carriage_count(network) > 1);
  const char* const travel = has_motors ? ", if all carriages travel alike" : "";
  if (smallest.front() == Grasp{}) {
    return std::string("It jams in every grasp") + (network.shared ? travel : "");
  }
  std::string text;
  // One more is no longer to name than to count.
  const std::size_t named =
      smallest.size() == named_jams + 1 ? smallest.size() : std::min(named_jams, smallest.size());
  for (std::size_t i = 0; i < named; ++i) {
    text += (i == 0 ? "" : ", or ") + held_words(smallest[i]) + stalled_in(smallest[i], groups);
  }
  if (smallest.size() > named) text += fmt::format(", or in {} more ways", smallest.size() - named);
  return fmt::format("It jams when {} ({:.0f} of {:.0f} grasps{})", text, jams,
                     std::ldexp(1.0, fingers) - 1, travel);
}

std::string stalled_motors(const Network& network, const TensionState& state) {
  if (motor_groups(network).count < 2) return "";
  std::vector<int> stalled;
  for (int carriage = 1; carriage <= carriage_count(network); ++carriage) {
    if (state.motor_tension[static_cast<std::size_t>(carriage) - 1] > 0) {
      stalled.push_back(carriage);
    }
  }
  return stall_words(stalled);
}

std::string jam_mark(const Network& network, const TensionState& state) {
  if (!state.jams) return "";
  if (state.opposed > 0) {
    return fmt::format(" (jams: tendons of finger {} oppose each other)", state.opposed);
  }
  const std::string stalled = stalled_motors(network, state);
  return " (" + (stalled.empty() ? "jams" : stalled) + ")";
}

std::string jams_field(const std::vector<Grasp>& smallest) {
  return joined(smallest, " ",
                [](const Grasp& grasp) { return grasp == Grasp{} ? "none" : held_field(grasp); });
}

Json grasps_json(const std::vector<Grasp>& grasps) {
  return list_json(grasps, [](Grasp grasp) { return Json(held_fingers(grasp)); });
}

int tree_count(const Network& network) {
  std::set<std::size_t> trees;
  for (const TendonSpan& tendon : network.tendons) trees.insert(tendon.tree);
  return static_cast<int>(trees.size());
}

std::string shared_carriage_text(const Network& network, const TendonParts& tendons) {
  const int trees = tree_count(network);
  if (trees < 2) return "";
  const bool tied = static_cast<std::size_t>(trees) < network.tendons.size();
  const int motors = carriage_count(network);
  if (motors > 1) {
    return fmt::format(
        "{} {} hang on {} carriages, which travel alike unless a grasp says "
        "otherwise (1@1,0.5): their shares of the pull {}{}",
        trees, tied ? "trees of tendons" : "tendons", motors, assumption(tendons),
        independence_words(motor_groups(network)));
  }
  return fmt::format("{} {} hang on one carriage: their shares of its pull {}", trees,
                     tied ? "trees of tendons" : "tendons", assumption(tendons));
}

std::vector<DocumentLine> shared_carriage_lines(const std::vector<ListedDesign>& shown,
                                                const TendonParts& tendons) {
  std::vector<std::string> ranks;
  bool several_motors = false;
  for (const ListedDesign& design : shown) {
    const Network network = expand(parse_routing(design.ranked.design.word));
    if (tree_count(network) < 2) continue;
    ranks.push_back(std::to_string(design.ranked.rank));
    several_motors |= carriage_count(network) > 1;
  }
  if (ranks.empty()) return {};
  const std::string whose = ranks.size() == 1 ? fmt::format("Rank {} has", ranks.front())
                            : ranks.size() == shown.size() ? "All of these have"
                                                           : "Ranks " + enumerated(ranks) + " have";
  return {
      {fmt::format("{} several tendons on {}: their shares of its pull {}", whose,
                   several_motors ? "one carriage, or on carriages that travel as the grasps say"
                                  : "one carriage",
                   assumption(tendons))}};
}

}  // namespace reeve::reports
