#include "causes/model_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace reeve::causes {
namespace {

constexpr double tolerance = 1e-10;
constexpr double growth = 1.05;
constexpr int most_steps = 1000;

template <typename T>
void gather(std::vector<T>& values, const std::vector<std::size_t>& from) {
  std::vector<T> result;
  result.reserve(from.size());
  for (const std::size_t i : from) result.push_back(values[i]);
  values = std::move(result);
}

void number_by_kind(const Network& network, std::vector<std::size_t>& numbers) {
  std::array<std::size_t, contact_kinds> met{};
  numbers.clear();
  for (const Contact& contact : network.contacts) {
    numbers.push_back(met[static_cast<std::size_t>(contact.kind)]++);
  }
}

}  // namespace

ModelSolver::ModelSolver(const Model& model) : model_(&model) {
  for (const Effect& effect : model.effects) {
    const Reach reach = effect.cause->reach();
    if (reach == Reach::load) depends_on_load_ = true;
    if (reach == Reach::load || reach == Reach::conditions || reach == Reach::exponent) {
      exponent_effects_.push_back(&effect);
    }
  }
}

ModelSolver::ModelSolver(const Model& model, const Hardware& hardware, const std::string& word,
                         const Network& network)
    : ModelSolver(model) {
  Mechanics plain;
  MechanicsBuilder(hardware).apply(network, plain);
  set_routing(word, network, plain);
}

void ModelSolver::set_routing(const std::string& word, const Network& network,
                              const Mechanics& plain) {
  plain_ = plain;
  seized_.network = network;
  number_by_kind(network, number_);
  const std::vector<std::size_t> contacts = seized_contacts(*model_, word, network);
  if (!contacts.empty()) {
    seized_ = seize(network, contacts);
    gather(plain_.length, seized_.segment_from);
    gather(plain_.phi, seized_.contact_from);
    gather(plain_.decay, seized_.contact_from);
    gather(number_, seized_.contact_from);
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

double ModelSolver::exponent(std::size_t contact, double high_N, Direction direction,
                             const Conditions& conditions) const {
  const ContactLoad load{seized_.network.contacts[contact].kind, high_N, number_[contact],
                         direction};
  double phi = plain_.phi[contact];
  for (const Effect* effect : exponent_effects_) {
    phi = effect->cause->exponent(phi, load, conditions, *effect);
  }
  return std::clamp(phi, 0.0, max_exponent);
}

void ModelSolver::restart_steps() {
  share_.assign(plain_.phi.size(), 1.0);
  way_.assign(plain_.phi.size(), 0.0);
}

// Moves each exponent by its share of the way to where it should be; the greatest way there was.
double ModelSolver::change_exponents(Direction direction, const Conditions& conditions) {
  double greatest = 0;
  for (std::size_t k = 0; k < plain_.phi.size(); ++k) {
    const double high =
        conditions.motor_tension_N *
        (state_.tension.empty() ? 1
                                : std::max(state_.tension[left_[k]], state_.tension[right_[k]]));
    const double wanted = exponent(k, high, direction, conditions);
    const double way = wanted - mechanics_.phi[k];
    greatest = std::max(greatest, std::abs(way) / (tolerance + wanted));
    share_[k] = way * way_[k] < 0 ? share_[k] / 2 : std::min(1.0, share_[k] * growth);
    way_[k] = way;
    mechanics_.phi[k] += share_[k] * way;
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
    restart_steps();
    change_exponents(direction, conditions);
    restart_steps();
  }
  solve_once();
  if (depends_on_load_) {
    converged_ = false;
    for (int step = 0; step < most_steps && !converged_ && state_.in_range; ++step) {
      converged_ = change_exponents(direction, conditions) < tolerance;
      solve_once();
    }
  }
  if (!seized_.network.split || !state_.in_range) return state_;
  restored_ = restored(seized_, state_);
  return restored_;
}

}  // namespace reeve::causes
