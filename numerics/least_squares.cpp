#include "numerics/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/matrices.hpp"

namespace reeve::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 50;
constexpr double difference_share = 1e-6;  // share of the width of the box
constexpr double settled = 1e-7;  // relative fall of the sum, and more than rounding brings
constexpr double settled_to_compare = 1e-4;
constexpr double nothing = 1e-20;  // share of the first sum: an exact fit
constexpr double least_damping = 1e-6;
constexpr double most_damping = 1e8;

class Descent {
 public:
  Descent(const Residuals& residuals, const std::vector<Interval>& box,
          const std::vector<double>& start, Precision precision)
      : residuals_(residuals),
        box_(box),
        corrects_(precision == Precision::to_compare),
        settled_(corrects_ ? settled_to_compare : settled),
        at_(start) {}

  LeastSquares run() {
    auto first = residuals_(at_);
    if (!first) return {{at_, std::numeric_limits<double>::infinity()}, false};
    here_ = std::move(*first);
    value_ = here_.squaredNorm();
    const double first_value = value_;
    bool converged = false;
    for (int step = 0; step < most_steps && !converged; ++step) {
      if (!is_corrected_ && !differentiate()) break;
      const double before = value_;
      if (!descend()) {
        if (std::exchange(is_corrected_, false)) continue;
        converged = is_flat();
        break;
      }
      is_corrected_ = corrects_;
      converged = before - value_ <= settled_ * before || value_ <= nothing * first_value;
    }
    return {{at_, value_}, converged};
  }

 private:
  double width(std::size_t i) const { return box_[i].high - box_[i].low; }

  bool differentiate() {
    jacobian_.resize(here_.size(), static_cast<Index>(at_.size()));
    for (std::size_t i = 0; i < at_.size(); ++i) {
      auto column = jacobian_.col(static_cast<Index>(i));
      const double step = difference_share * width(i) *
                          (at_[i] + difference_share * width(i) > box_[i].high ? -1 : 1);
      if (step == 0) {
        column.setZero();
        continue;
      }
      std::vector<double> beside = at_;
      beside[i] += step;
      const auto there = residuals_(beside);
      if (!there) return false;
      column = (*there - here_) / step;
    }
    gradient_ = jacobian_.transpose() * here_;
    return true;
  }

  // Corrects the Jacobian by what changed in the step to this point.
  void correct(const std::vector<double>& before, const VectorXd& residuals_before) {
    VectorXd moved(jacobian_.cols());
    VectorXd along(jacobian_.cols());
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const auto k = static_cast<Index>(i);
      moved[k] = at_[i] - before[i];
      along[k] = width(i) > 0 ? moved[k] / (width(i) * width(i)) : 0;
    }
    const double square = along.dot(moved);
    if (!(square > 0)) return;
    const VectorXd missed = here_ - residuals_before - jacobian_ * moved;
    jacobian_ += missed * (along / square).transpose();
    gradient_ = jacobian_.transpose() * here_;
  }

  // True if the variable is at a bound and the sum falls beyond it.
  bool is_held(std::size_t i) const {
    const double slope = gradient_[static_cast<Index>(i)];
    return (at_[i] <= box_[i].low && slope > 0) || (at_[i] >= box_[i].high && slope < 0);
  }

  // True if a full step could gain nothing.
  bool is_flat() const {
    double gain = 0;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const auto k = static_cast<Index>(i);
      const double square = jacobian_.col(k).squaredNorm();
      if (!is_held(i) && square > 0) gain += gradient_[k] * gradient_[k] / square;
    }
    return gain <= 100 * settled_ * value_;
  }

  std::vector<double> stepped() const {
    MatrixXd square = jacobian_.transpose() * jacobian_;
    VectorXd slope = gradient_;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const auto k = static_cast<Index>(i);
      if (is_held(i) || square(k, k) == 0) {
        square.row(k).setZero();
        square.col(k).setZero();
        square(k, k) = 1;
        slope[k] = 0;
      }
    }
    square.diagonal() *= 1 + damping_;
    const VectorXd step = solve_symmetric(square, -slope);
    std::vector<double> there = at_;
    for (std::size_t i = 0; i < there.size(); ++i) {
      const double moved = there[i] + step[static_cast<Index>(i)];
      there[i] = std::clamp(moved, box_[i].low, box_[i].high);
    }
    return there;
  }

  bool descend() {
    const double most = is_corrected_ ? 100 * damping_ : most_damping;
    for (; damping_ < most; damping_ *= 10) {
      const std::vector<double> there = stepped();
      auto residuals = residuals_(there);
      if (!residuals) continue;
      const double value = residuals->squaredNorm();
      if (!(value < value_)) continue;
      const std::vector<double> before = std::exchange(at_, there);
      const VectorXd residuals_before = std::exchange(here_, std::move(*residuals));
      value_ = value;
      if (corrects_) correct(before, residuals_before);
      damping_ = std::max(least_damping, damping_ / 10);
      return true;
    }
    return false;
  }

  const Residuals& residuals_;
  const std::vector<Interval>& box_;
  bool corrects_;
  double settled_;
  bool is_corrected_ = false;  // the Jacobian is not that of here
  std::vector<double> at_;
  VectorXd here_;
  MatrixXd jacobian_;
  VectorXd gradient_;
  double value_ = 0;
  double damping_ = 1e-3;
};

}  // namespace

LeastSquares least_squares(const Residuals& residuals, const std::vector<Interval>& box,
                           const std::vector<double>& start, Precision precision) {
  return Descent(residuals, box, start, precision).run();
}

}  // namespace reeve::numerics
