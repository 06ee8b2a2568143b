#include "sizing/size.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/error.hpp"
#include "numerics/least_squares.hpp"
#include "numerics/parallel.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::sizing {
namespace {

constexpr double coarse = 1e-4;   // tolerance of a search from one of several starts, as a share of
                                  // the box
constexpr double all_but = 1e-3;  // distance from a bound, as a share of the box
constexpr double no_loss = 1e-9;  // as a share of the goal
constexpr double hardly_a_loss = 1e-7;  // likewise

// Result of one search.
struct Find {
  Minimum best;
  std::optional<Minimum> nearest;  // best for a target, at the nominal coefficients
};

class SizingSearch {
 public:
  SizingSearch(const SizingProblem& problem, const SizingOptions& options,
               const std::atomic<bool>* stop)
      : problem_(problem), options_(options), stop_(stop) {}

  bool stopped() const { return stop_ != nullptr && stop_->load(); }

  // Search 0 covers the whole box; each other search has one start.
  Find run(int number) const {
    const SizingPoint start = number == 0 ? problem_.nearest_to_nominal() : start_of(number);
    const Minimum here{start, problem_.loss(start)};
    if (stopped() || start.empty()) return {here, std::nullopt};
    Find find{
        least(here, number == 0 ? minimise(loss(), problem_.box(), options_.evaluations, stop_)
                                : descent(start, coarse)),
        std::nullopt};
    if (options_.goal.is_target()) find.nearest = nearest(start);
    return find;
  }

  Minimum finished(Minimum best) const {
    if (stopped() || best.at.empty()) return best;
    best = least(best, descent(best.at, 1e-9));
    if (!stopped()) {
      best = least(best, refine(loss(), problem_.box(), best.at, options_.evaluations));
    }
    return tidied(best);
  }

  Minimum with_loss(const SizingPoint& point) const { return {point, problem_.loss(point)}; }

  static Minimum least(const Minimum& a, const Minimum& b) { return b.value < a.value ? b : a; }

 private:
  std::function<double(const SizingPoint&)> loss() const {
    return [this](const SizingPoint& point) { return problem_.loss(point); };
  }

  Minimum descent(const SizingPoint& start, double tolerance) const {
    return descend(loss(), problem_.box(), start, options_.evaluations, tolerance, stop_);
  }

  // The first start is the hardware as it is.
  SizingPoint start_of(int number) const {
    SizingPoint start = problem_.nearest_to_nominal();
    for (std::size_t i = 0; number > 1 && i < start.size(); ++i) {
      const Interval& bounds = problem_.box()[i];
      const auto stream = streams::sizing_starts + static_cast<std::uint32_t>(i);
      start[i] =
          bounds.low + (bounds.high - bounds.low) *
                           uniform(options_.seed, stream, static_cast<std::uint64_t>(number));
    }
    return start;
  }

  Minimum nearest(const SizingPoint& start) const {
    const Residuals residuals = [this](const SizingPoint& point) -> std::optional<Eigen::VectorXd> {
      try {
        return problem_.evaluator().misses(problem_.model(point));
      } catch (const OutOfRange&) {
        return std::nullopt;
      }
    };
    const SizingPoint at = least_squares(residuals, problem_.box(), start).minimum.at;
    return {at, problem_.nominal_loss(at)};
  }

  // The goal is no worse for it, but by rounding: what only that would gain stays as it is.
  Minimum tidied(Minimum best) const {
    for (std::size_t i = 0; i < best.at.size(); ++i) {
      const Interval& bounds = problem_.box()[i];
      const double near = all_but * (bounds.high - bounds.low);
      const double most = best.value + hardly_a_loss * std::abs(best.value);
      if (best.at[i] - bounds.low < near) best = put(best, i, bounds.low, most);
      if (bounds.high - best.at[i] < near) best = put(best, i, bounds.high, most);
    }
    const SizingPoint nominal = problem_.nearest_to_nominal();
    const double most =
        best.value + std::max(no_loss * std::abs(best.value), goal_rounding(options_.goal));
    Minimum untouched = with_loss(nominal);
    if (untouched.value <= most) return untouched;
    for (std::size_t i = 0; i < best.at.size(); ++i) best = put(best, i, nominal[i], most);
    for (const FlatDirection& flat : flat_directions(problem_, options_.goal, best.at)) {
      best = back_along(flat, best, most);
    }
    return best;
  }

  // Moves along the direction to the point nearest to the nominal dimensions, in units of the box's
  // sides.
  Minimum back_along(const FlatDirection& flat, const Minimum& best, double most) const {
    const SizingPoint nominal = problem_.nearest_to_nominal();
    double way = 0;
    double squares = 0;
    for (std::size_t i = 0; i < best.at.size(); ++i) {
      if (flat.moves[i] == 0) continue;
      const double width = problem_.box()[i].high - problem_.box()[i].low;
      way += (nominal[i] - best.at[i]) * flat.moves[i] / (width * width);
      squares += flat.moves[i] * flat.moves[i] / (width * width);
    }
    SizingPoint there = best.at;
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Interval& bounds = problem_.box()[i];
      there[i] = std::clamp(there[i] + way / squares * flat.moves[i], bounds.low, bounds.high);
    }
    const Minimum back = with_loss(there);
    return back.value <= most ? back : best;
  }

  Minimum put(const Minimum& best, std::size_t variable, double value, double most) const {
    SizingPoint there = best.at;
    there[variable] = value;
    const Minimum put = with_loss(there);
    return put.value <= most ? put : best;
  }

  const SizingProblem& problem_;
  const SizingOptions& options_;
  const std::atomic<bool>* stop_;
};

SizedGoal sized_goal(const SizingProblem& problem, const Model& model, const SizingOptions& options,
                     double goal, double nominal) {
  SizedGoal result{goal, nominal, {}, {}, {}, 0};
  DesignEvaluator evaluator(model, options.grasps, options.score);
  result.values = evaluator.evaluate(problem.routing());
  result.unconverged = evaluator.unconverged();
  result.shares = problem.evaluator().shares(model);
  UncertaintyOptions drawn{model, options.ranges, options.grasps, {}};
  drawn.draws = told_draws(options);
  drawn.seed = options.seed;
  drawn.threads = 1;
  result.motor = motor_force(problem.routing(), drawn);
  return result;
}

SizedGoal goal_before(const SizingProblem& problem, const SizingOptions& options) {
  return sized_goal(problem, problem.model(), options, problem.told_goal(), problem.nominal_goal());
}

SizedGoal goal_after(const SizingProblem& problem, const SizingOptions& options,
                     const SizingPoint& point) {
  return sized_goal(problem, problem.model(point), options, problem.told_goal(point),
                    problem.nominal_goal(point));
}

Minimum best_of(const std::vector<Find>& finds) {
  Minimum best = finds.front().best;
  for (const Find& find : finds) best = SizingSearch::least(best, find.best);
  return best;
}

std::optional<Minimum> nearest_of(const std::vector<Find>& finds) {
  std::optional<Minimum> nearest;
  for (const Find& find : finds) {
    if (find.nearest)
      nearest = nearest ? SizingSearch::least(*nearest, *find.nearest) : *find.nearest;
  }
  return nearest;
}

void finish(const SizingProblem& problem, const SizingOptions& options, const SizingSearch& search,
            const std::vector<Find>& finds, SizedDesign& design) {
  Minimum best = best_of(finds);
  if (const auto nearest = nearest_of(finds)) {
    design.least_miss = nearest->value;
    design.nearest_shares = problem.evaluator().shares(problem.model(nearest->at));
    best = SizingSearch::least(best, search.with_loss(nearest->at));
  }
  best = search.finished(best);
  design.after = goal_after(problem, options, best.at);
  if (design.least_miss && design.after.nominal < *design.least_miss) {
    design.least_miss = design.after.nominal;
    design.nearest_shares = design.after.shares;
  }
  design.hardware = problem.model(best.at).hardware;
  // If no motor force suffices, sensitivities are undefined.
  const bool is_enough = !search.stopped() && std::isfinite(design.after.goal);
  const auto sensitivity = is_enough ? sensitivities(problem, options.goal, best.at)
                                     : std::vector<Sensitivity>(best.at.size());
  for (std::size_t i = 0; i < best.at.size(); ++i) {
    const SizeVariable& variable = problem.space().variables[i];
    design.variables.push_back(
        {variable, best.at[i], at_bound(variable.bounds, best.at[i]), sensitivity[i]});
  }
  if (!is_enough) return;
  design.flat = flat_directions(problem, options.goal, best.at);
  if (best.at.empty()) return;
  design.together = joint_tolerance(problem, options.goal, best.at, sensitivity, options.seed);
}

// Counts steps of all threads.
class Teller {
 public:
  Teller(const Supervision& supervision, std::size_t total)
      : supervision_(supervision), total_(total) {}

  void step() {
    if (!supervision_.report) return;
    const std::lock_guard lock(guard_);
    supervision_.report({++done_, total_});
  }

 private:
  const Supervision& supervision_;
  std::mutex guard_;
  std::uint64_t done_ = 0;
  std::uint64_t total_;
};

}  // namespace

bool is_met(const SizedDesign& design) {
  return !design.least_miss || *design.least_miss <= met_miss;
}

SizingResult size(const std::vector<Routing>& routings, const SizingOptions& options,
                  const Supervision& supervision) {
  std::vector<SizingProblem> problems;
  SizingResult result;
  for (const Routing& routing : routings) {
    problems.emplace_back(routing, options);
    SizedDesign& design = result.designs.emplace_back();
    design.routing = routing;
    design.before = goal_before(problems.back(), options);
  }
  const auto searches = static_cast<std::size_t>(options.starts) + 1;
  std::vector<std::vector<Find>> finds(routings.size(), std::vector<Find>(searches));
  Teller teller(supervision, routings.size() * (searches + 1));
  Workers workers(options.threads);
  workers.for_each_block(routings.size() * searches, 1, [&](const IndexBlock& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const SizingSearch search(problems[i / searches], options, supervision.stop);
      finds[i / searches][i % searches] = search.run(static_cast<int>(i % searches));
      teller.step();
    }
  });
  workers.for_each_block(routings.size(), 1, [&](const IndexBlock& block) {
    for (std::size_t r = block.begin; r < block.end; ++r) {
      const SizingSearch search(problems[r], options, supervision.stop);
      finish(problems[r], options, search, finds[r], result.designs[r]);
      teller.step();
    }
  });
  for (const SizedDesign& design : result.designs) {
    result.unconverged += design.before.unconverged + design.after.unconverged;
  }
  result.partial = supervision.stop != nullptr && supervision.stop->load();
  return result;
}

}  // namespace reeve::sizing
