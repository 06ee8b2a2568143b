#include "causes/model_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace reeve::causes {
namespace {

constexpr double exact_tolerance = 1e-10;
constexpr double quick_tolerance = 1e-6;
constexpr double growth = 1.05;
constexpr int most_steps = 1000;
// Limit for Newton's method, which takes about four steps.
constexpr int most_quick_steps = 30;
// Nearer than this (in ln T) two tensions tell no slope.
constexpr double least_difference = 1e-6;

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
  word_ = word;
  seized_.network = network;
  number_by_kind(network, number_);
  const std::vector<std::size_t> contacts = seized_contacts(*model_, word, network);
  if (!contacts.empty()) {
    seized_ = seize(network, contacts);
    gather(number_, seized_.contact_from);
  }
  has_motion_ = false;
  set_friction(plain);
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

void ModelSolver::set_friction(const Mechanics& plain) {
  plain_ = plain;
  if (seized_.network.split) {
    restored_mechanics_ = plain;
    gather(plain_.length, seized_.segment_from);
    if (!plain_.spools.empty()) gather(plain_.spools, seized_.segment_from);
    if (!plain_.slack_mm.empty()) gather(plain_.slack_mm, seized_.segment_from);
    if (!plain_.guided_tips.empty()) gather(plain_.guided_tips, seized_.contact_from);
    gather(plain_.phi, seized_.contact_from);
    gather(plain_.decay, seized_.contact_from);
  }
  mechanics_ = plain_;
  is_settled_ = false;
}

double ModelSolver::exponent(std::size_t contact, double high_N, Direction direction,
                             const Conditions& conditions) const {
  const Contact& at = seized_.network.contacts[contact];
  const ContactLoad load{at.kind, high_N, number_[contact], direction, at.finger, grasp_, word_};
  double phi = plain_.phi[contact];
  for (const Effect* effect : exponent_effects_) {
    phi = effect->cause->exponent(phi, load, conditions, *effect);
  }
  return std::clamp(phi, 0.0, max_exponent);
}

const Mechanics& ModelSolver::solved() {
  if (!seized_.network.split) return mechanics_;
  for (std::size_t k = 0; k < mechanics_.phi.size(); ++k) {
    const std::size_t from = seized_.contact_from[k];
    const bool is_seized = left_[k] == right_[k];
    restored_mechanics_.decay[from] = is_seized ? 0 : mechanics_.decay[k];
    if (!is_seized) restored_mechanics_.phi[from] = mechanics_.phi[k];
  }
  return restored_mechanics_;
}

std::vector<SolvedContact> ModelSolver::contacts() const {
  std::vector<SolvedContact> result;
  for (std::size_t k = 0; k < mechanics_.phi.size(); ++k) {
    if (left_[k] == right_[k]) continue;
    const Contact& at = seized_.network.contacts[k];
    result.push_back({at.kind, at.finger, number_[k], mechanics_.phi[k],
                      std::max(state_.tension[left_[k]], state_.tension[right_[k]])});
  }
  return result;
}

void ModelSolver::restart_steps() {
  share_.assign(plain_.phi.size(), 1.0);
  way_.assign(plain_.phi.size(), 0.0);
}

// Moves each exponent by its share of the way to where it should be; the greatest way there was.
double ModelSolver::change_exponents(Direction direction, const Conditions& conditions) {
  double greatest = 0;
  for (std::size_t k = 0; k < plain_.phi.size(); ++k) {
    const double high = high_N(k);
    const double wanted = exponent(k, high, direction, conditions);
    const double way = wanted - mechanics_.phi[k];
    greatest = std::max(greatest, std::abs(way) / (exact_tolerance + wanted));
    share_[k] = way * way_[k] < 0 ? share_[k] / 2 : std::min(1.0, share_[k] * growth);
    way_[k] = way;
    set_exponent(k, mechanics_.phi[k] + share_[k] * way);
  }
  return greatest;
}

double ModelSolver::high_N(std::size_t contact) const {
  return unit_N_ * std::max(state_.tension[left_[contact]], state_.tension[right_[contact]]);
}

void ModelSolver::solve_tensions(Grasp grasp, Direction direction) {
  if (prescribed_ == Prescribed::take_up) {
    solver_.solve_relative(seized_.network, mechanics_, grasp, direction, state_);
  } else {
    solver_.solve(seized_.network, mechanics_, grasp, direction, state_);
  }
}

void ModelSolver::solve_tensions_again(Grasp grasp, Direction direction) {
  if (prescribed_ == Prescribed::take_up) {
    solver_.solve_relative_again(seized_.network, mechanics_, grasp, direction, state_);
  } else {
    solver_.solve_again(seized_.network, mechanics_, grasp, direction, state_);
  }
}

// Each contact as if it carried all that the motor pulls.
void ModelSolver::guess_exponents(Direction direction, const Conditions& conditions) {
  mechanics_ = plain_;
  for (std::size_t k = 0; k < plain_.phi.size(); ++k) {
    set_exponent(k, exponent(k, conditions.motor_tension_N, direction, conditions));
  }
}

void ModelSolver::set_exponent(std::size_t contact, double phi) {
  mechanics_.phi[contact] = phi;
  mechanics_.decay[contact] = std::exp(-phi);
}

// Slopes are those of the secants from step to step. Returns the greatest way, relative.
double ModelSolver::compare_exponents(Direction direction, const Conditions& conditions) {
  double greatest = 0;
  for (std::size_t k = 0; k < plain_.phi.size(); ++k) {
    const double high = high_N(k);
    const double wanted = exponent(k, high, direction, conditions);
    errors_.way[k] = wanted - mechanics_.phi[k];
    greatest = std::max(greatest, std::abs(errors_.way[k]) / (exact_tolerance + wanted));
    if (wanted != wanted_[k]) {
      const double difference = std::log(high / seen_N_[k]);
      if (std::abs(difference) > least_difference) {
        errors_.slope[k] = (wanted - wanted_[k]) / difference;
        wanted_[k] = wanted;
        seen_N_[k] = high;
      }
    }
  }
  return greatest;
}

void ModelSolver::begin_newton(const Conditions& conditions) {
  errors_.way.resize(plain_.phi.size());
  errors_.slope.assign(plain_.phi.size(), 0.0);
  wanted_ = mechanics_.phi;
  seen_N_.assign(plain_.phi.size(), conditions.motor_tension_N);
}

bool ModelSolver::settle_by_newton(Grasp grasp, Direction direction, const Conditions& conditions,
                                   double tolerance) {
  for (int step = 0; step < most_quick_steps && state_.in_range; ++step) {
    if (compare_exponents(direction, conditions) < tolerance) return true;
    const std::vector<double>& changes =
        step_.changes(seized_.network, mechanics_, state_, errors_, prescribed_);
    for (std::size_t k = 0; k < changes.size(); ++k) {
      if (changes[k] == 0) continue;
      set_exponent(k, std::clamp(mechanics_.phi[k] + changes[k], 0.0, max_exponent));
    }
    solve_tensions_again(grasp, direction);
  }
  return false;
}

bool ModelSolver::settle_in_turn(Grasp grasp, Direction direction, const Conditions& conditions) {
  restart_steps();
  for (int step = 0; step < most_steps && state_.in_range; ++step) {
    const bool is_near = change_exponents(direction, conditions) < exact_tolerance;
    solver_.solve_again(seized_.network, mechanics_, grasp, direction, state_);
    if (is_near) return true;
  }
  return false;
}

void ModelSolver::settle_afresh(Grasp grasp, Direction direction, const Conditions& conditions) {
  const auto begin = [&] {
    if (!exponent_effects_.empty()) guess_exponents(direction, conditions);
    if (has_motion_) {
      solve_tensions_again(grasp, direction);
    } else {
      solve_tensions(grasp, direction);
      has_motion_ = true;
    }
  };
  begin();
  converged_ = !depends_on_load_;
  if (!converged_ && seized_.network.blocks.empty()) {
    begin_newton(conditions);
    is_settled_ = converged_ = settle_by_newton(grasp, direction, conditions, exact_tolerance);
    if (!converged_) begin();
  }
  if (!converged_) converged_ = settle_in_turn(grasp, direction, conditions);
}

// Where a force takes all that a contact has, the exponents of another load may be those of another
// balance.
bool ModelSolver::can_go_on(Grasp grasp, Direction direction) const {
  return depends_on_load_ && is_settled_ && has_motion_ && grasp == grasp_ &&
         direction == direction_ && *std::ranges::max_element(mechanics_.phi) < max_exponent;
}

const TensionState& ModelSolver::solve(Grasp grasp, Direction direction,
                                       const Conditions& conditions) {
  const bool goes_on = can_go_on(grasp, direction);
  has_motion_ = has_motion_ && grasp == grasp_ && direction == direction_;
  grasp_ = grasp;
  direction_ = direction;
  prescribed_ = Prescribed::motor_tension;
  unit_N_ = conditions.motor_tension_N;
  is_settled_ = goes_on && settle_by_newton(grasp, direction, conditions, exact_tolerance);
  if (!is_settled_) settle_afresh(grasp, direction, conditions);
  if (!seized_.network.split || !state_.in_range) return state_;
  restored_ = restored(seized_, state_);
  return restored_;
}

const TensionState& ModelSolver::solve_from_last(Grasp grasp, Prescribed prescribed, double unit_N,
                                                 const Conditions& conditions) {
  grasp_ = grasp;
  direction_ = Direction::pull;
  has_motion_ = false;
  prescribed_ = prescribed;
  unit_N_ = unit_N;
  if (!is_settled_) guess_exponents(direction_, conditions);
  solve_tensions(grasp, direction_);
  if (!is_settled_) begin_newton(conditions);
  is_settled_ = converged_ = settle_by_newton(grasp, direction_, conditions, quick_tolerance);
  return state_;
}

}  // namespace reeve::causes
