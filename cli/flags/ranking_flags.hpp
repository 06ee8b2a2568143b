// Options that say in which grasps designs are evaluated, and how they are ranked.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "search/evaluate/score.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::cli {

// Reads grasps for all of these routings. Carriages that travel unlike each other, and ends that
// are locked, can be told only where the routings have the same.
GraspSet grasps_of(const std::string& text, const std::vector<Routing>& routings);

struct RankingFlags {
  TextOption grasps{"single"};
  TextOption objectives{"uniformity,efficiency"};
  TextOption score{"authors"};
  bool uncertainty = false;
  std::size_t draws = 1000;
  std::uint64_t seed = 1;
  int threads = 0;

  void add_to(CLI::App& command);
  GraspSet read_grasps(int fingers, int motors) const;
  GraspSet read_grasps(const std::vector<Routing>& routings) const;
  Score read_score() const;
  // The order is by the score alone if it is given and the objectives are not.
  Order read_order() const;
};

}  // namespace reeve::cli
