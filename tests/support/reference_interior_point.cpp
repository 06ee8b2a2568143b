#include "tests/support/reference_interior_point.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>

namespace reeve::testing::reference {

namespace {

using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

class InteriorPoint {
 public:
  explicit InteriorPoint(const Problem& problem) : problem_(problem) {
    for (Index k = 0; k < problem.phi.size(); ++k)
      if (!tied(problem, k)) free_.push_back(k);
    const auto m = static_cast<Index>(free_.size());
    phi_.resize(m);
    for (Index j = 0; j < m; ++j) phi_(j) = problem.phi(contact(j));
    d_.setZero(m);
    upper_room_ = lower_room_ = phi_;
    upper_force_ = lower_force_ = phi_.cwiseInverse() * start;
  }

  Sides solve() {
    if (free_.empty()) return Sides(static_cast<std::size_t>(problem_.phi.size()), 0);
    for (int step = 0; step < 300 && gap() > goal * problem_.elastic.sum(); ++step) advance();
    return sides();
  }

 private:
  static constexpr Real eps = 1e-8L;
  static constexpr Real start = 1 / eps;
  static constexpr Real goal = 1e-26L;

  Index contact(Index j) const { return free_[static_cast<std::size_t>(j)]; }

  Real gap() const {
    return (upper_room_.dot(upper_force_) + lower_room_.dot(lower_force_)) /
           static_cast<Real>(2 * phi_.size());
  }

  // Share of sum L T in the segments up to each contact, and beyond it.
  void weigh(Vector& head, Vector& tail) const {
    const Index n = problem_.length.size();
    Vector y = Vector::Zero(n);
    Vector difference = Vector::Zero(problem_.phi.size());
    for (Index j = 0; j < phi_.size(); ++j) difference(contact(j)) = d_(j);
    for (Index i = 1; i < n; ++i) y(i) = y(i - 1) - difference(i - 1);
    Vector share = problem_.length.array() * (y.array() - y.maxCoeff()).exp();
    share /= share.sum();
    head.resize(phi_.size());
    tail.resize(phi_.size());
    for (Index j = 0; j < phi_.size(); ++j) {
      head(j) = share.head(contact(j) + 1).sum();
      tail(j) = share.tail(n - 1 - contact(j)).sum();
    }
  }

  Vector gradient(const Vector& head, const Vector& tail) const {
    const Real total = problem_.elastic.sum();
    const Index n = problem_.length.size();
    Vector g(phi_.size());
    for (Index j = 0; j < g.size(); ++j) {
      const Index k = contact(j);
      const Real flux = head(j) < tail(j)
                            ? total * head(j) - problem_.elastic.head(k + 1).sum()
                            : problem_.elastic.tail(n - 1 - k).sum() - total * tail(j);
      g(j) = flux + problem_.slip(k) / eps;
    }
    return g;
  }

  Matrix hessian(const Vector& head, const Vector& tail) const {
    const Real total = problem_.elastic.sum();
    Matrix h(phi_.size(), phi_.size());
    for (Index row = 0; row < h.rows(); ++row)
      for (Index column = 0; column <= row; ++column)
        h(row, column) = h(column, row) = total * head(column) * tail(row);
    return h;
  }

  void advance() {
    const Real target = 0.15L * gap();
    Vector head, tail;
    weigh(head, tail);
    Matrix h = hessian(head, tail);
    h.diagonal() +=
        upper_force_.cwiseQuotient(upper_room_) + lower_force_.cwiseQuotient(lower_room_);
    const Vector pull =
        -gradient(head, tail) - target * (upper_room_.cwiseInverse() - lower_room_.cwiseInverse());
    const Eigen::LLT<Matrix> factor(h);
    Vector step = factor.solve(pull);
    if (problem_.loop) {
      const Vector round = factor.solve(Vector::Ones(step.size()));
      step -= round * (step.sum() / round.sum());
    }
    move(step, target);
  }

  void move(const Vector& step, Real target) {
    const Vector upper =
        (target + upper_force_.array() * step.array()) / upper_room_.array() - upper_force_.array();
    const Vector lower =
        (target - lower_force_.array() * step.array()) / lower_room_.array() - lower_force_.array();
    const Real length = std::min({reach(upper_room_, -step), reach(lower_room_, step),
                                  reach(upper_force_, upper), reach(lower_force_, lower)});
    d_ += length * step;
    upper_room_ -= length * step;
    lower_room_ += length * step;
    upper_force_ += length * upper;
    lower_force_ += length * lower;
  }

  // The longest step, at most 1, that leaves a hundredth of each positive value.
  static Real reach(const Vector& value, const Vector& change) {
    Real length = 1;
    for (Index i = 0; i < value.size(); ++i)
      if (change(i) < 0) length = std::min(length, -0.99L * value(i) / change(i));
    return length;
  }

  Sides sides() const {
    Sides found(static_cast<std::size_t>(problem_.phi.size()), 0);
    const Real scale = problem_.elastic.sum();
    for (Index j = 0; j < phi_.size(); ++j) {
      const auto k = static_cast<std::size_t>(contact(j));
      if (upper_force_(j) / scale > upper_room_(j) / phi_(j)) found[k] = 1;
      if (lower_force_(j) / scale > lower_room_(j) / phi_(j)) found[k] = -1;
    }
    return found;
  }

  const Problem& problem_;
  std::vector<Index> free_;  // the contacts with friction
  Vector phi_, d_;
  Vector upper_room_, lower_room_;    // phi - d, phi + d
  Vector upper_force_, lower_force_;  // their multipliers
};

}  // namespace

Sides contacts_at_a_bound(const Problem& problem) { return InteriorPoint(problem).solve(); }

}  // namespace reeve::testing::reference
