#include "tests/support/reference_loading.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "tests/support/reference_tree.hpp"

namespace reeve::testing {

namespace reference {
namespace {

// Unknowns of a step: the slip of each contact, then the z of each block.
class Loading {
 public:
  Loading(const Tree& tree, Real take_up)
      : tree_(tree), take_up_(take_up), moves_(tree.length.size(), unknowns()) {
    moves_.setZero();
    for (std::size_t k = 0; k < tree.contacts.size(); ++k) {
      const auto column = static_cast<Index>(k);
      moves_(tree.contacts[k].left, column) += 1 / tree.c(tree.contacts[k].left);
      moves_(tree.contacts[k].right, column) -= 1 / tree.c(tree.contacts[k].right);
    }
    moves_.rightCols(tree.hangs.cols()) = tree.hangs;
    ease_ = tree.length.cwiseInverse().asDiagonal() * moves_;
  }

  Vector pull(int steps) {
    const Vector closed = (1 - take_up_) * tree_.give;
    const Vector step = (tree_.motor - closed) / static_cast<Real>(steps);
    const Real start = tree_.elastic.sum() * take_up_ / static_cast<Real>(steps);
    Vector elongation = tree_.length * (start / tree_.length.sum());
    Vector moved = Vector::Zero(unknowns());
    for (int n = 0; n < steps; ++n) {
      elongation += step;
      moved = settle(elongation, moved);
      elongation += moves_ * moved;
    }
    if (!(elongation.minCoeff() > 0))
      throw std::logic_error("reference loading: a tendon goes slack");
    return elongation.cwiseQuotient(tree_.length);
  }

 private:
  Index contacts() const { return static_cast<Index>(tree_.contacts.size()); }
  Index unknowns() const { return contacts() + tree_.hangs.cols(); }

  // Rows of the forces that vanish at each contact as it is: a known ratio, or the edge of the cone
  // where it slips; 0 where it sticks.
  Matrix edges(const std::vector<int>& slips) const {
    Matrix rows = Matrix::Zero(contacts(), tree_.length.size());
    for (Index k = 0; k < contacts(); ++k) {
      const TreeContact& contact = tree_.contacts[static_cast<std::size_t>(k)];
      const int slip = slips[static_cast<std::size_t>(k)];
      const bool known = contact.bar || tied(contact.phi);
      if (!known && slip == 0) continue;
      const Real lean = contact.bar ? contact.arms : known ? 0 : contact.phi;
      const bool left_is_slack = slip > 0 && !known;
      rows(k, contact.left) = left_is_slack ? 1 : std::exp(-lean);
      rows(k, contact.right) = left_is_slack ? -std::exp(-lean) : -1;
    }
    return rows;
  }

  std::vector<int> slips_by(const Vector& tension, const Vector& moved) const {
    std::vector<int> slips(tree_.contacts.size(), 0);
    for (std::size_t k = 0; k < slips.size(); ++k) {
      const TreeContact& contact = tree_.contacts[k];
      const Real left = tension(contact.left), right = tension(contact.right);
      const Real edge = std::exp(-contact.phi), slip = moved(static_cast<Index>(k));
      const Real soft = std::min(tree_.length(contact.left), tree_.length(contact.right));
      if (slip > soft * (left - edge * right)) slips[k] = 1;
      if (-slip > soft * (right - edge * left)) slips[k] = -1;
    }
    return slips;
  }

  // All contacts that are elsewhere at first; later one after another, lest they chase each other.
  static void follow(const std::vector<int>& next, bool all, std::vector<int>& slips) {
    const auto [first, other] = std::mismatch(slips.begin(), slips.end(), next.begin());
    if (all)
      slips = next;
    else
      *first = *other;
  }

  // Not where a loop slips all round: then its ratios do not fit, or any turn of it does.
  static bool meets(const Matrix& forces, const Vector& tension) {
    return (forces * tension).cwiseAbs().maxCoeff() <= 1e-9L * tension.cwiseAbs().maxCoeff();
  }

  Vector settle(const Vector& elongation, Vector moved) const {
    const Vector free = elongation.cwiseQuotient(tree_.length);
    std::vector<int> slips = slips_by(free + ease_ * moved, moved);
    for (int attempt = 0; attempt < 200; ++attempt) {
      Matrix forces(unknowns(), tree_.length.size());
      forces << edges(slips), tree_.hangs.transpose();
      Matrix system = forces * ease_;
      const Vector off = -forces * free;
      for (Index k = 0; k < contacts(); ++k)
        if (forces.row(k).isZero(0)) system(k, k) = 1;
      moved = system.fullPivLu().solve(off);
      const Vector tension = free + ease_ * moved;
      const std::vector<int> next = slips_by(tension, moved);
      if (next == slips && meets(forces, tension)) return moved;
      if (next == slips) break;
      follow(next, attempt < 20, slips);
    }
    throw std::logic_error("reference loading: a step finds no state");
  }

  const Tree& tree_;
  Real take_up_;  // eps
  Matrix moves_;  // lengths that each segment needs more
  Matrix ease_;   // and its tension for it
};

}  // namespace
}  // namespace reference

LoadedPull loaded_pull(const std::string& word, const std::set<int>& held,
                       const ReferenceHardware& hardware, int steps, double take_up) {
  using namespace reference;
  const std::vector<Tendon> tendons = read_tendons(word);
  LoadedPull pull;
  Real motor = 0;
  for (const Tree& tree : pose_trees(tendons, held, ReferenceDirection::pull, hardware)) {
    if (tree.jams) throw std::invalid_argument("reference loading: the grasp jams");
    const Vector found = Loading(tree, take_up).pull(steps);
    motor += tree.motor.dot(found);
    for (const Span& span : tree.spans)
      for (Index i = 0; i < span.segments; ++i)
        pull.tension[tendons[span.tendon].segments[static_cast<std::size_t>(i)].name] =
            static_cast<double>(found(span.segment + i));
  }
  pull.motor = static_cast<double>(motor);
  return pull;
}

std::map<std::string, double> loaded_tensions(const std::string& word, const std::set<int>& held,
                                              const ReferenceHardware& hardware, int steps) {
  constexpr double nearly_stiff = 1e-5;
  LoadedPull pull = loaded_pull(word, held, hardware, steps, nearly_stiff);
  for (auto& [segment, tension] : pull.tension) tension /= pull.motor;
  return pull.tension;
}

}  // namespace reeve::testing
