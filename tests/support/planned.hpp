// Plans of experiments for tests.
#pragma once

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "diagnosis/plan/experiment.hpp"

namespace reeve::testing {

inline PlannedRouting planned_routing(const std::string& word) {
  const Routing parsed = parse_routing(word);
  PlannedRouting routing{word, word, parsed, expand(parsed), {}};
  for (const WeightedGrasp& grasp : single_grasps(routing.network.fingers)) {
    routing.grasps.push_back(grasp.grasp);
  }
  return routing;
}

// All strands of two fingers.
inline ExperimentPlan plan_of(const std::vector<std::string>& words) {
  ExperimentPlan plan;
  for (const std::string& word : words) plan.routings.push_back(planned_routing(word));
  for (const char* strand : {"T1", "T2", "T3", "T4"}) {
    plan.channels.push_back(parse_segment(strand));
  }
  return plan;
}

inline const std::vector<std::string> three_routings{"M-1-T-2-F", "M-1-P-2-M", "1-P-2-P-1"};

}  // namespace reeve::testing
