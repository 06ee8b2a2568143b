// Sensitivity of a goal to each variable about a point.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sizing_problem.hpp"

namespace reeve::sizing {

// A goal is lost if it gets worse by this share of itself. A target, whose best value is 0, is lost
// if the shares miss by this much more.
inline constexpr double tolerated_loss = 0.01;

// Returns the tolerated loss, in the unit of the loss.
double tolerated(const SizingProblem& problem, const Goal& goal, const SizingPoint& point);

// A goal that changes by no more has not changed: shares are of the order of 1 and carry the
// rounding of the tensions, objectives are rounded to 1e-10, and factors of a product are up to 10.
double goal_rounding(const Goal& goal);

// Returns the loss after a move of the variables, each kept to what is possible in any hardware,
// since a rounding error is no way beyond that.
double loss_after(const SizingProblem& problem, SizingPoint point,
                  const std::vector<double>& moves);

// Returns the range of evaluation beyond the point, towards less (−1) or more (1). It ends one
// width of the bounds beyond them, or where no hardware is possible.
double room_beyond(const SizingProblem& problem, const SizingPoint& point, std::size_t variable,
                   int sign);

struct Sensitivity {
  // Change of the goal per unit that the variable gets less, and more.
  double slope_less = 0;
  double slope_more = 0;
  // Deviation of this variable alone that loses the tolerated part. Nothing if it lies beyond
  // room_beyond().
  std::optional<double> less;
  std::optional<double> more;
};

std::vector<Sensitivity> sensitivities(const SizingProblem& problem, const Goal& goal,
                                       const SizingPoint& point);

// A direction in which the goal hardly changes: going a tenth of the box there, either way, costs
// less than a tenth of what is tolerated.
struct FlatDirection {
  std::vector<double> moves;  // move of each variable, in its unit
  double loss = 0;            // loss of the goal at the worse end
};

// Among the variables that stand at no bound: the directions of least curvature. Each variable that
// does nothing is a direction by itself.
std::vector<FlatDirection> flat_directions(const SizingProblem& problem, const Goal& goal,
                                           const SizingPoint& point);

enum class AtBound : std::uint8_t { no, low, high };
AtBound at_bound(const Interval& bounds, double value);

// Goal along one variable; the others stay.
struct GoalProfile {
  std::vector<double> values;  // values of the variable, ascending; with the point's own
  std::vector<double> goals;   // parallel to values
};

// One for each variable, evenly over its span. What has no tensions is left out.
std::vector<GoalProfile> goal_profiles(const SizingProblem& problem, const SizingPoint& point,
                                       const std::vector<Interval>& spans);

}  // namespace reeve::sizing
