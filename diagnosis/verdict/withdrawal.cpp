#include "diagnosis/verdict/withdrawal.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/fit.hpp"
#include "numerics/chi_squared.hpp"
#include "numerics/matrices.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double of_data_sets = 0.95;

// In log-likelihood: what parameters that are needed for nothing lose at most in 95 of 100 data
// sets.
double chance_loss(std::size_t parameters) {
  return chi_squared_quantile(of_data_sets, static_cast<double>(parameters)) / 2;
}

// Of the later model's forecasts d of the held-out runs, less the earlier one's, what the training
// runs leave open: δ ~ N(0, V), by which they may be off by J δ.
class LeftOpen {
 public:
  LeftOpen(const Problem& training, const Problem& unseen, const Model& model)
      : there_(jacobian(unseen, model)) {
    const Eigen::MatrixXd here = jacobian(training, model);
    open_ = inverse_of_symmetric(here.transpose() * here);
  }

  // Of d · J δ.
  double variance_along(const Eigen::VectorXd& difference) const {
    if (there_.cols() == 0) return 0;
    const Eigen::VectorXd along = there_.transpose() * difference;
    return std::max(0.0, along.dot(open_ * along));
  }

  // |d|² is no more than |J δ|² by chance, by the first two moments of a sum of weighed squares
  // (F. E. Satterthwaite, Biometrics Bulletin 2, 1946): the models are the same to these runs.
  bool explains(const Eigen::VectorXd& difference) const {
    const Eigen::MatrixXd spread = open_ * (there_.transpose() * there_);
    const double mean = spread.trace();
    if (!(mean > 0)) return difference.isZero(0);
    const double weight = (spread * spread).trace() / mean;
    return difference.squaredNorm() <= weight * chi_squared_quantile(of_data_sets, mean / weight);
  }

 private:
  static Eigen::MatrixXd jacobian(const Problem& problem, const Model& model) {
    return sensitivities(problem, model, forecast(*problem.dataset, model));
  }

  Eigen::MatrixXd there_;  // J, of the held-out runs
  Eigen::MatrixXd open_;   // V
};

// What the lower end of a gain's interval is above in 95 of 100 data sets if the later model is
// right up to what its fit leaves open: the gain is then normal about half |d|², with a variance of
// |d|² and of that of d · J δ.
double least_if_right(double expected_gain, double open_variance) {
  constexpr double end = 1.960;      // of the interval
  constexpr double of_most = 1.645;  // data sets
  const double own = 2 * expected_gain;
  return expected_gain - end * std::sqrt(own) - of_most * std::sqrt(own + open_variance);
}

// Also where mountings are taken to differ by so much that no run tells anything by likelihood.
bool surely_loses(const HeldOut& gain) {
  constexpr double twice = -1;
  return gain.high < twice && gain.log_likelihood_gain < 0;
}

bool names_a_coefficient(const Explanation& explanation) {
  return std::any_of(explanation.calibrations.begin(), explanation.calibrations.end(),
                     [](const Calibration& calibration) { return calibration.differs; });
}

Model without_last(const Explanation& explanation) {
  const Effect& last = explanation.accepted.back().effect;
  return fit(explanation.problem, without(explanation.model, place(explanation.model, last))).model;
}

// With the hardware's own, in place of those that are said to differ.
Model without_differences(const Explanation& explanation) {
  Model model = explanation.model;
  for (const Calibration& calibration : explanation.calibrations) {
    if (calibration.differs) model = without(model, place(model, calibration.effect));
  }
  return fit(explanation.problem, model).model;
}

class Withdrawing {
 public:
  Withdrawing(Explanation& explanation, const Dataset& held_out, const Model& nominal,
              std::uint64_t seed, Workers& workers)
      : explanation_(explanation),
        held_out_(held_out),
        nominal_(nominal),
        seed_(seed),
        workers_(workers) {}

  Withdrawal run() {
    while (!explanation_.accepted.empty() && names_may_lose()) {
      result_.names.push_back(effect_name(explanation_.accepted.back().effect));
      take_back_last(explanation_, workers_);
    }
    if (names_a_coefficient(explanation_) && may_lose_to(nominal_)) {
      take_back_differences();
      forecast_by(nominal_);
    }
    // Beside causes that are left it stays fitted, as any that is not said to differ.
    if (names_a_coefficient(explanation_) && may_lose_to(without_differences(explanation_))) {
      take_back_differences();
    }
    return std::move(result_);
  }

 private:
  // What the others gain may hide that the last of several loses.
  bool names_may_lose() {
    if (may_lose_to(explanation_.base) || may_lose_to(nominal_)) return true;
    return explanation_.accepted.size() > 1 && may_lose_to(without_last(explanation_));
  }

  bool may_lose_to(const Model& before) {
    const Model& after = explanation_.model;
    const Problem unseen = problem(held_out_, explanation_.scatter, after, workers_);
    const Eigen::VectorXd apart =
        difference(unseen, forecast(held_out_, before), forecast(held_out_, after));
    const HeldOut gain = held_out_gain(unseen, before, after, seed_);
    if (surely_loses(gain)) {
      result_.held_out = gain;
      return true;
    }
    const LeftOpen open(explanation_.problem, unseen, after);
    if (open.explains(apart)) return false;
    const std::size_t more = parameter_count(after) - parameter_count(before);
    const double chance_low =
        std::min(-chance_loss(std::max<std::size_t>(more, 1)),
                 least_if_right(gain.expected_gain, open.variance_along(apart)));
    if (gain.gain_low >= chance_low) return false;
    result_.held_out = gain;
    return true;
  }

  void take_back_differences() {
    for (Calibration& calibration : explanation_.calibrations) {
      if (calibration.differs) result_.names.push_back(effect_name(calibration.effect));
      calibration.differs = false;
    }
  }

  void forecast_by(const Model& model) {
    explanation_.model = model;
    explanation_.problem =
        problem(*explanation_.problem.dataset, explanation_.scatter, model, workers_);
  }

  Explanation& explanation_;
  const Dataset& held_out_;
  const Model& nominal_;
  std::uint64_t seed_;
  Workers& workers_;
  Withdrawal result_;
};

}  // namespace

Withdrawal withdraw_what_may_lose(Explanation& explanation, const Dataset& held_out,
                                  const Model& nominal, std::uint64_t seed, Workers& workers) {
  if (held_out.cells.empty()) return {};
  return Withdrawing(explanation, held_out, nominal, seed, workers).run();
}

}  // namespace reeve::diagnosis
