#include "causes/model_solver.hpp"

#include <algorithm>
#include <cmath>

namespace reeve {
namespace {

constexpr double tolerance = 1e-10;
constexpr int full_steps = 30;
constexpr int most_steps = 200;

template <typename T>
std::vector<T> gathered(const std::vector<T>& values, const std::vector<std::size_t>& from) {
  std::vector<T> result;
  result.reserve(from.size());
  for (const std::size_t i : from) result.push_back(values[i]);
  return result;
}

}  // namespace

ModelSolver::ModelSolver(const Model& model, const Hardware& hardware, const std::string& word,
                         const Network& network) {
  for (const Effect& effect : model.effects) {
    const Reach reach = effect.cause->reach();
    if (reach == Reach::load) depends_on_load_ = true;
    if (reach == Reach::load || reach == Reach::conditions) exponent_effects_.push_back(&effect);
  }
  plain_ = mechanics(network, hardware);
  seized_.network = network;
  const std::vector<std::size_t> contacts = seized_contacts(model, word, network);
  if (!contacts.empty()) {
    seized_ = seize(network, contacts);
    plain_.length = gathered(plain_.length, seized_.segment_from);
    plain_.phi = gathered(plain_.phi, seized_.contact_from);
    plain_.decay = gathered(plain_.decay, seized_.contact_from);
  }
  mechanics_ = plain_;
  left_.assign(network.contacts.size(), 0);
  right_.assign(network.contacts.size(), 0);
  for (const TendonSpan& tendon : seized_.network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      left_[tendon.first_contact + k] = left;
      right_[tendon.first_contact + k] = right;
    }
  }
}

double ModelSolver::exponent(std::size_t contact, double high_N,
                             const Conditions& conditions) const {
  const ContactLoad load{seized_.network.contacts[contact].kind, high_N};
  double phi = plain_.phi[contact];
  for (const Effect* effect : exponent_effects_) {
    phi = effect->cause->exponent(phi, load, conditions, *effect);
  }
  return std::clamp(phi, 0.0, max_exponent);
}

// Moves each exponent by this share of the way to where it should be; the greatest way there was.
double ModelSolver::change_exponents(const Conditions& conditions, double share) {
  double greatest = 0;
  for (std::size_t k = 0; k < plain_.phi.size(); ++k) {
    const double high =
        conditions.motor_tension_N *
        (state_.tension.empty() ? 1
                                : std::max(state_.tension[left_[k]], state_.tension[right_[k]]));
    const double wanted = exponent(k, high, conditions);
    const double way = wanted - mechanics_.phi[k];
    greatest = std::max(greatest, std::abs(way) / (tolerance + wanted));
    mechanics_.phi[k] += share * way;
    mechanics_.decay[k] = std::exp(-mechanics_.phi[k]);
  }
  return greatest;
}

const TensionState& ModelSolver::solve(Grasp grasp, Direction direction,
                                       const Conditions& conditions) {
  const auto solve_once = [&] {
    solver_.solve(seized_.network, mechanics_, grasp, direction, state_);
  };
  converged_ = true;
  if (!exponent_effects_.empty()) {
    state_.tension.clear();
    mechanics_ = plain_;
    change_exponents(conditions, 1);
  }
  solve_once();
  if (depends_on_load_) {
    converged_ = false;
    double share = 1;
    for (int step = 0; step < most_steps && !converged_; ++step) {
      if (step > 0 && step % full_steps == 0) share /= 2;
      converged_ = change_exponents(conditions, share) < tolerance;
      solve_once();
    }
  }
  if (!seized_.network.split) return state_;
  restored_ = restored(seized_, state_);
  return restored_;
}

}  // namespace reeve
