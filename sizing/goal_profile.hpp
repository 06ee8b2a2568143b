// How the goal goes as one variable changes and the others stay.
#pragma once

#include <vector>

#include "sizing/sizing_problem.hpp"

namespace reeve::sizing {

struct GoalProfile {
  std::vector<double> values;  // of the variable, ascending; the point's own is among them
  std::vector<double> goals;   // where there are tensions
};

// One for each variable, evenly over its span. What has no tensions is left out.
std::vector<GoalProfile> goal_profiles(const SizingProblem& problem,
                                       const SizingProblem::Point& point,
                                       const std::vector<Interval>& spans);

}  // namespace reeve::sizing
