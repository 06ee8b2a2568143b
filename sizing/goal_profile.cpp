#include "sizing/goal_profile.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace reeve::sizing {
namespace {

constexpr int profile_steps = 32;

std::vector<double> places(const Interval& span, double own) {
  std::vector<double> places{own};
  for (int step = 0; step <= profile_steps; ++step) {
    places.push_back(span.low + (span.high - span.low) * step / profile_steps);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

std::vector<GoalProfile> goal_profiles(const SizingProblem& problem,
                                       const SizingProblem::Point& point,
                                       const std::vector<Interval>& spans) {
  std::vector<GoalProfile> profiles;
  for (std::size_t i = 0; i < point.size(); ++i) {
    GoalProfile& profile = profiles.emplace_back();
    SizingProblem::Point there = point;
    for (const double place : places(spans[i], point[i])) {
      there[i] = place;
      try {
        profile.goals.push_back(problem.goal(there));
        profile.values.push_back(place);
      } catch (const OutOfRange&) {
        continue;
      }
    }
  }
  return profiles;
}

}  // namespace reeve::sizing
