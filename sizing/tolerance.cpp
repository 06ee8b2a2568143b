#include "sizing/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "numerics/matrices.hpp"

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

using Eigen::Index;
constexpr int scan_steps = 40;
constexpr int halvings = 40;
constexpr double slope_step = 1e-4;      // share of the width of the bounds
constexpr double curvature_step = 0.05;  // likewise
constexpr double flat_move = 0.1;        // likewise
constexpr double flat_share = 0.1;       // share of the tolerated loss
constexpr double near_bound = 1e-6;      // share of the width of the bounds

double width(const Interval& bounds) {
  return std::max(bounds.high - bounds.low, 1e-6 * std::max(1.0, std::abs(bounds.high)));
}

// Returns the values that the variable may have in any hardware.
Interval possible(const SizingProblem& problem, std::size_t variable) {
  const SizeSpace& space = problem.space();
  const std::size_t first = space.variables[variable].dimensions.front();
  return row(space.dimensions[first].dimension.quantity).possible;
}

// Returns the distance to the first place where `lost` is true: scanned, then bisected.
std::optional<double> way_to(double reach, const std::function<bool(double)>& lost) {
  double inside = 0;
  for (int step = 1; step <= scan_steps; ++step) {
    double outside = reach * step / scan_steps;
    if (!lost(outside)) {
      inside = outside;
      continue;
    }
    for (int i = 0; i < halvings; ++i) {
      const double middle = (inside + outside) / 2;
      (lost(middle) ? outside : inside) = middle;
    }
    return inside;
  }
  return std::nullopt;
}

class Surroundings {
 public:
  Surroundings(const SizingProblem& problem, const Goal& goal, const SizingPoint& point)
      : problem_(problem),
        point_(point),
        loss_(problem.loss(point)),
        tolerated_(tolerated(problem, goal, point)),
        rounding_(goal.is_target() ? goal_rounding(goal) : 0) {}

  Sensitivity of(std::size_t variable) const {
    const Interval& bounds = problem_.space().variables[variable].bounds;
    Sensitivity result;
    result.slope_less = slope(variable, -slope_step * width(bounds));
    result.slope_more = slope(variable, slope_step * width(bounds));
    result.less = off(variable, -1);
    result.more = off(variable, 1);
    return result;
  }

 private:
  SizingPoint beside(std::size_t variable, double move) const {
    SizingPoint there = point_;
    there[variable] += move;
    return there;
  }

  double slope(std::size_t variable, double move) const {
    const Interval there = possible(problem_, variable);
    const double to = point_[variable] + move;
    if (to < there.low || to > there.high) return 0;
    const SizingPoint at = beside(variable, move);
    if (!problem_.is_hardware(at)) return 0;
    const double change = problem_.as_loss(problem_.loss(at) - loss_);
    return std::abs(change) <= rounding_ ? 0 : change / std::abs(move);
  }

  std::optional<double> off(std::size_t variable, int sign) const {
    const double beyond = room_beyond(problem_, point_, variable, sign);
    if (!(beyond > 0)) return std::nullopt;
    return way_to(beyond, [&](double way) {
      const SizingPoint at = beside(variable, sign * way);
      return problem_.is_hardware(at) && problem_.loss(at) > loss_ + tolerated_;
    });
  }

  const SizingProblem& problem_;
  const SizingPoint& point_;
  double loss_;
  double tolerated_;
  double rounding_;  // objectives are rounded already
};

// The loss about the point along some of the variables, in parts of their bounds.
class Plain {
 public:
  Plain(const SizingProblem& problem, const SizingPoint& point, std::vector<std::size_t> free)
      : problem_(problem), point_(point), free_(std::move(free)), here_(problem.loss(point)) {}

  Index size() const { return static_cast<Index>(free_.size()); }

  // Returns the loss of a move of this length, at the worse end.
  FlatDirection along(const Eigen::VectorXd& direction) const {
    return {moves(direction), std::max({loss(direction) - here_, loss(-direction) - here_, 0.0})};
  }

  // Converts to units of the variables.
  std::vector<double> moves(const Eigen::VectorXd& direction) const {
    std::vector<double> moves(point_.size(), 0);
    for (Index k = 0; k < size(); ++k) {
      const std::size_t i = free_[static_cast<std::size_t>(k)];
      moves[i] = direction[k] * width(problem_.box()[i]);
    }
    return moves;
  }

  double loss(const Eigen::VectorXd& direction) const {
    return loss_after(problem_, point_, moves(direction));
  }

  // Returns second differences of the loss, or of its square: a miss has an edge where it is 0.
  Eigen::MatrixXd curvature(bool squared) const {
    const auto loss = [&](const Eigen::VectorXd& direction) {
      const double there = this->loss(direction);
      return squared ? there * there : there;
    };
    const double here = squared ? here_ * here_ : here_;
    Eigen::MatrixXd result(size(), size());
    for (Index i = 0; i < size(); ++i) {
      for (Index k = 0; k <= i; ++k) {
        const Eigen::VectorXd a = curvature_step * Eigen::VectorXd::Unit(size(), i);
        const Eigen::VectorXd b = curvature_step * Eigen::VectorXd::Unit(size(), k);
        result(i, k) = i == k ? loss(a) + loss(-a) - 2 * here
                              : (loss(a + b) - loss(a - b) - loss(b - a) + loss(-a - b)) / 4;
        result(k, i) = result(i, k);
      }
    }
    return result;
  }

 private:
  const SizingProblem& problem_;
  const SizingPoint& point_;
  std::vector<std::size_t> free_;
  double here_ = 0;
};

std::vector<std::size_t> between_bounds(const SizingProblem& problem, const SizingPoint& point) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Interval& bounds = problem.box()[i];
    if (bounds.high > bounds.low && at_bound(bounds, point[i]) == AtBound::no) free.push_back(i);
  }
  return free;
}

// So that its greatest part is positive and one: of two ends the same one, whatever the signs of
// the eigenvectors.
Eigen::VectorXd in_one_way(const Eigen::VectorXd& direction) {
  Index greatest = 0;
  for (Index i = 1; i < direction.size(); ++i) {
    if (std::abs(direction[i]) > std::abs(direction[greatest]) + 1e-6) greatest = i;
  }
  Eigen::VectorXd result = direction / direction[greatest];
  for (double& part : result) {
    if (std::abs(part) < 1e-3) part = 0;
  }
  return result;
}

bool parallel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  constexpr double least_cosine = 0.9;
  return std::abs(a.dot(b)) > least_cosine * a.norm() * b.norm();
}

// Returns the directions that scale all of these variables of one quantity together. Where a goal
// is the worst of several fingers it has an edge, and the curvature does not tell that it stays the
// same along the edge.
std::vector<Eigen::VectorXd> scalings(const SizingProblem& problem, const SizingPoint& point,
                                      const std::vector<std::size_t>& variables) {
  const SizeSpace& space = problem.space();
  std::vector<Eigen::VectorXd> result;
  for (const QuantityRow& about : quantity_table()) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(static_cast<Index>(variables.size()));
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const std::size_t i = variables[k];
      const std::size_t first = space.variables[i].dimensions.front();
      if (space.dimensions[first].dimension.quantity != about.quantity) continue;
      direction[static_cast<Index>(k)] = point[i] / width(problem.box()[i]);
    }
    if ((direction.array() != 0).count() > 1) result.push_back(direction);
  }
  return result;
}

}  // namespace

std::vector<GoalProfile> goal_profiles(const SizingProblem& problem, const SizingPoint& point,
                                       const std::vector<Interval>& spans) {
  std::vector<GoalProfile> profiles;
  for (std::size_t i = 0; i < point.size(); ++i) {
    GoalProfile& profile = profiles.emplace_back();
    SizingPoint there = point;
    for (const double place : places(spans[i], point[i])) {
      there[i] = place;
      try {
        profile.goals.push_back(problem.told_goal(there));
        profile.values.push_back(place);
      } catch (const OutOfRange&) {
        continue;
      }
    }
  }
  return profiles;
}

double loss_after(const SizingProblem& problem, SizingPoint point,
                  const std::vector<double>& moves) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Interval limits = possible(problem, i);
    point[i] = std::clamp(point[i] + moves[i], limits.low, limits.high);
  }
  return problem.loss(point);
}

AtBound at_bound(const Interval& bounds, double value) {
  const double near = near_bound * (bounds.high - bounds.low);
  if (value <= bounds.low + near) return AtBound::low;
  return value >= bounds.high - near ? AtBound::high : AtBound::no;
}

double tolerated(const SizingProblem& problem, const Goal& goal, const SizingPoint& point) {
  return tolerated_loss * (goal.is_target() ? 1 : std::abs(problem.goal(point)));
}

double goal_rounding(const Goal& goal) { return goal.is_target() ? 1e-12 : 1e-9; }

double room_beyond(const SizingProblem& problem, const SizingPoint& point, std::size_t variable,
                   int sign) {
  const Interval& bounds = problem.space().variables[variable].bounds;
  const Interval there = possible(problem, variable);
  const double room = sign < 0
                          ? point[variable] - std::max(there.low, bounds.low - width(bounds))
                          : std::min(there.high, bounds.high + width(bounds)) - point[variable];
  return std::max(room, 0.0);
}

std::vector<Sensitivity> sensitivities(const SizingProblem& problem, const Goal& goal,
                                       const SizingPoint& point) {
  const Surroundings surroundings(problem, goal, point);
  std::vector<Sensitivity> result;
  for (std::size_t i = 0; i < point.size(); ++i) result.push_back(surroundings.of(i));
  return result;
}

std::vector<FlatDirection> flat_directions(const SizingProblem& problem, const Goal& goal,
                                           const SizingPoint& point) {
  const double most = flat_share * tolerated(problem, goal, point);
  std::vector<FlatDirection> flat;
  std::vector<std::size_t> others;
  for (const std::size_t i : between_bounds(problem, point)) {
    const FlatDirection alone =
        Plain(problem, point, {i}).along(flat_move * Eigen::VectorXd::Ones(1));
    if (alone.loss <= most) {
      flat.push_back(alone);
    } else {
      others.push_back(i);
    }
  }
  if (others.size() < 2) return flat;
  const Plain plain(problem, point, others);
  std::vector<Eigen::VectorXd> candidates = scalings(problem, point, others);
  const SymmetricAxes axes = symmetric_axes(plain.curvature(goal.is_target()));
  for (Index k = 0; k < plain.size(); ++k) candidates.push_back(axes.vectors.col(k));
  std::vector<Eigen::VectorXd> taken;
  for (const Eigen::VectorXd& candidate : candidates) {
    const auto is_again = [&](const Eigen::VectorXd& other) { return parallel(candidate, other); };
    if (std::ranges::any_of(taken, is_again)) continue;
    const FlatDirection here = plain.along(flat_move * in_one_way(candidate));
    if (here.loss > most) continue;
    flat.push_back(here);
    taken.push_back(candidate);
  }
  return flat;
}

}  // namespace reeve::sizing
