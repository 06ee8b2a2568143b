// How much a goal depends on each variable about a point.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sizing_problem.hpp"

namespace reeve::sizing {

// A goal worse by this part of itself is lost; of a target, whose best is 0, shares that miss by so
// much more.
inline constexpr double tolerated_loss = 0.01;

// That part, in the unit of the loss.
double tolerated(const SizingProblem& problem, const Goal& goal, const SizingPoint& point);

// A goal that changes by no more has not changed: shares are of the order of 1 and carry the
// rounding of the tensions, objectives are rounded to 1e-10, and factors of a product are up to 10.
double goal_rounding(const Goal& goal);

// What the variable may be in any hardware.
Interval possible(const SizingProblem& problem, std::size_t variable);

// How far a variable is looked at beyond the point, less (−1) or more (1): to the width of its
// bounds beyond them, or as far as there is hardware.
double room_beyond(const SizingProblem& problem, const SizingPoint& point, std::size_t variable,
                   int sign);

struct Sensitivity {
  // Change of the goal per unit that the variable gets less, and more.
  double slope_less = 0;
  double slope_more = 0;
  // How far it may be off, alone, before the tolerated part is lost. Nothing if that is further
  // than the width of its bounds beyond them, or than there is hardware.
  std::optional<double> less;
  std::optional<double> more;
};

std::vector<Sensitivity> sensitivities(const SizingProblem& problem, const Goal& goal,
                                       const SizingPoint& point);

// A direction in which the goal hardly changes: going a tenth of the box there, either way, costs
// less than a tenth of what is tolerated.
struct FlatDirection {
  std::vector<double> moves;  // of each variable, in its unit
  double loss = 0;            // of the goal, at the worse end
};

// Among the variables that stand at no bound: the directions of least curvature. Each variable that
// does nothing is a direction by itself.
std::vector<FlatDirection> flat_directions(const SizingProblem& problem, const Goal& goal,
                                           const SizingPoint& point);

enum class AtBound : std::uint8_t { no, low, high };
AtBound at_bound(const Interval& bounds, double value);

// How the goal goes as one variable changes and the others stay.
struct GoalProfile {
  std::vector<double> values;  // of the variable, ascending; the point's own is among them
  std::vector<double> goals;   // where there are tensions
};

// One for each variable, evenly over its span. What has no tensions is left out.
std::vector<GoalProfile> goal_profiles(const SizingProblem& problem, const SizingPoint& point,
                                       const std::vector<Interval>& spans);

}  // namespace reeve::sizing
