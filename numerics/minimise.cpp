#include "numerics/minimise.hpp"

#include <nlopt.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <stdexcept>

namespace reeve::numerics {
namespace {

// Shares of the box's sides.
constexpr double fine = 1e-9;
constexpr double first_step = 0.02;
constexpr double wide_step = 0.25;

using Function = std::function<double(const std::vector<double>&)>;

// The free variables of the box, scaled to 0 … 1.
class BoxProblem {
 public:
  BoxProblem(const Function& function, const std::vector<Interval>& box,
             const std::atomic<bool>* stop = nullptr)
      : function_(function),
        box_(box),
        stop_(stop),
        best_{{}, std::numeric_limits<double>::infinity()} {
    for (std::size_t i = 0; i < box.size(); ++i) {
      point_.push_back(box[i].low);
      if (box[i].high > box[i].low) free_.push_back(i);
    }
  }

  std::size_t dimensions() const { return free_.size(); }
  const Minimum& best() const { return best_; }

  double operator()(const std::vector<double>& scaled) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const Interval& interval = box_[free_[i]];
      point_[free_[i]] = interval.low + (interval.high - interval.low) * scaled[i];
    }
    const double value = function_(point_);
    if (value < best_.value) {
      best_ = {point_, value};
      best_scaled_ = scaled;
    }
    return value;
  }

  // The point of the box, in the scaled coordinates.
  std::vector<double> scaled(const std::vector<double>& point) const {
    std::vector<double> result;
    for (const std::size_t i : free_) {
      result.push_back(
          std::clamp((point[i] - box_[i].low) / (box_[i].high - box_[i].low), 0.0, 1.0));
    }
    return result;
  }

  void start_at(const std::vector<double>& scaled) { best_scaled_ = scaled; }

  void search(nlopt::algorithm algorithm, int evaluations, double tolerance, double step = 0) {
    nlopt::opt optimiser(algorithm, static_cast<unsigned>(dimensions()));
    optimiser.set_lower_bounds(0.0);
    optimiser.set_upper_bounds(1.0);
    optimiser.set_maxeval(evaluations);
    optimiser.set_xtol_abs(tolerance);
    if (step > 0) optimiser.set_initial_step(step);
    optimiser.set_min_objective(
        [](const std::vector<double>& x, std::vector<double>&, void* self) {
          return static_cast<BoxProblem*>(self)->guarded(x);
        },
        this);
    std::vector<double> start =
        best_scaled_.empty() ? std::vector<double>(dimensions(), 0.5) : best_scaled_;
    double value = 0;
    try {
      optimiser.optimize(start, value);
    } catch (const nlopt::roundoff_limited&) {
      // Rounding ends the search; the best point is kept.
    } catch (...) {
      if (failure_) std::rethrow_exception(failure_);
      if (!stopped()) throw;
    }
  }

 private:
  bool stopped() const { return stop_ != nullptr && stop_->load(); }

  // NLopt is C inside: what the function throws is carried past it.
  double guarded(const std::vector<double>& scaled) {
    if (stopped() && !best_.at.empty()) throw nlopt::forced_stop();
    try {
      return (*this)(scaled);
    } catch (...) {
      failure_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  const Function& function_;
  const std::vector<Interval>& box_;
  const std::atomic<bool>* stop_;
  std::vector<std::size_t> free_;
  std::vector<double> point_;
  std::vector<double> best_scaled_;
  Minimum best_;
  std::exception_ptr failure_;
};

const Minimum& found(const BoxProblem& problem) {
  if (problem.best().at.empty()) {
    throw std::domain_error("minimise: the function has no finite value in the box");
  }
  return problem.best();
}

Minimum from_start(BoxProblem& problem, const std::vector<double>& start,
                   nlopt::algorithm algorithm, int evaluations, double tolerance, double step) {
  if (problem.dimensions() == 0) {
    problem({});
  } else {
    const std::vector<double> scaled = problem.scaled(start);
    problem(scaled);
    problem.start_at(scaled);
    problem.search(algorithm, evaluations, tolerance, step);
  }
  return found(problem);
}

}  // namespace

Minimum minimise(const Function& function, const std::vector<Interval>& box, int evaluations,
                 const std::atomic<bool>* stop) {
  BoxProblem problem(function, box, stop);
  if (problem.dimensions() == 0) {
    problem({});
  } else {
    problem.search(nlopt::GN_DIRECT_L, evaluations, fine);
    problem.search(nlopt::LN_SBPLX, evaluations, fine);
  }
  return found(problem);
}

Minimum descend(const Function& function, const std::vector<Interval>& box,
                const std::vector<double>& start, int evaluations, double tolerance,
                const std::atomic<bool>* stop) {
  BoxProblem problem(function, box, stop);
  return from_start(problem, start, nlopt::LN_SBPLX, evaluations, tolerance, wide_step);
}

Minimum refine(const Function& function, const std::vector<Interval>& box,
               const std::vector<double>& start, int evaluations, double tolerance) {
  BoxProblem problem(function, box);
  return from_start(problem, start, nlopt::LN_BOBYQA, evaluations, tolerance, first_step);
}

}  // namespace reeve::numerics
