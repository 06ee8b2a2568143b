#include "cli/flags/ranking_flags.hpp"

#include <algorithm>

#include "cli/inputs.hpp"
#include "core/error.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"

namespace reeve::cli {
namespace {

// Returns what `of` says of every routing, or `otherwise` where routings differ in it.
template <typename Of, typename Value>
Value common(const std::vector<Routing>& routings, Of of, const Value& otherwise) {
  const Value first = of(routings.front());
  const bool is_common =
      std::ranges::all_of(routings, [&](const Routing& routing) { return of(routing) == first; });
  return is_common ? first : otherwise;
}

}  // namespace

GraspSet grasps_of(const std::string& text, const std::vector<Routing>& routings) {
  const auto carriages_of = [](const Routing& routing) { return carriage_count(routing); };
  const auto ends_of = [](const Routing& routing) { return motor_ends(expand(routing)); };
  return parse_grasps(text, finger_count(routings.front()), common(routings, carriages_of, 1),
                      common(routings, ends_of, MotorEnds{}));
}

void RankingFlags::add_to(CLI::App& command) {
  grasps.add(command, "--grasps",
             "Grasps: single (none, and each finger held), all, paper, or a list such as "
             "none:2/1/1,2:0.5");
  objectives.add(command, "--objectives",
                 "Objectives of the Pareto front, with commas; docs/model.md lists them");
  score.add(
      command, "--score",
      "Order by a weighted mean of objectives, such as uniformity=2,jams=1; authors: the five "
      "indicators");
  CLI::Option* drawn =
      command.add_flag("--uncertainty", uncertainty,
                       "Draw the friction coefficients from their ranges; give objectives and "
                       "places as distributions");
  add_with_default(command, "--draws", draws, "Number of draws for --uncertainty")
      ->needs(drawn)
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
  add_with_default(command, "--seed", seed, "Seed of the draws")->needs(drawn)->check(is_seed);
  add_threads(command, threads);
}

Score RankingFlags::read_score() const {
  return for_name("--", [&] { return parse_score(score.text); });
}

Order RankingFlags::read_order() const {
  const bool by_score = score.is_given();
  if (by_score && !objectives.is_given()) return {{Objective::score}, true};
  return {for_name("--", [&] { return parse_objectives(objectives.text); }), by_score};
}

GraspSet RankingFlags::read_grasps(int fingers, int motors) const {
  return for_name("--", [&] { return parse_grasps(grasps.text, fingers, motors); });
}

GraspSet RankingFlags::read_grasps(const std::vector<Routing>& routings) const {
  return for_name("--", [&] { return grasps_of(grasps.text, routings); });
}

}  // namespace reeve::cli
