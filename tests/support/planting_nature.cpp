#include "tests/support/planting_nature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "tests/support/planting_seizure.hpp"
#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

// Beyond slack_phi nothing that a sensor could see comes through; a contact that never slides
// must outweigh all others of its loop together.
constexpr double slack_phi = 18;
constexpr double locked_phi = 60;
constexpr double stand_in_length = 1e-12;

using Exponents = std::map<ContactName, double>;

double factor(double value) { return std::max(0.0, value); }

double condition_factor(const Nature& nature, const Condition& condition) {
  double product = 1;
  if (condition.direction == ReferenceDirection::release) product += nature.release_change;
  if (condition.speed_mm_s) {
    product *= factor(1 + nature.speed_slope * std::log(*condition.speed_mm_s / 10));
  }
  if (condition.cycle) {
    const double worn = 1 - std::exp(-*condition.cycle / nature.wear_cycles);
    product *= factor(1 + nature.wear_change * worn);
  }
  if (condition.temperature_C) {
    product *= factor(1 - nature.temperature_slope_per_K * (*condition.temperature_C - 20));
  }
  return product;
}

// One contact, named by the routing's own segments.
struct PlantedLaw {
  double phi;       // but for the load
  double exponent;  // gamma
  double force_N;
  double slope = 0;  // of a force that grows with T_high, above the onset
  double onset_N = 0;

  // "Less F" is T_low = T_high e^{-phi} - F and T_high = (T_low + F) e^{phi}. As an exponent, the
  // first ends at once where T_high is given from outside; only the second is stable where T_low
  // is, and always, but slow where T_low is far below F.
  double from_high(double high_N) const {
    if (high_N <= 0) return exponent > 0 || force_N > 0 ? slack_phi : phi;
    const double share = std::exp(-loaded(high_N)) - force(high_N) / high_N;
    return share > 0 ? std::min(slack_phi, -std::log(share)) : slack_phi;
  }

  double from_low(double high_N, double low_N) const {
    if (force(high_N) == 0 || low_N <= 0) return from_high(high_N);
    return std::min(slack_phi, loaded(high_N) + std::log1p(force(high_N) / low_N));
  }

 private:
  double force(double high_N) const { return force_N + slope * std::max(0.0, high_N - onset_N); }
  double loaded(double high_N) const { return phi * std::pow(high_N / 10, -exponent); }
};

double sheath_change(const Nature& nature, const ContactName& name) {
  const int finger = std::max(finger_of_strand(name.first), finger_of_strand(name.second));
  const auto found = nature.sheath_change_rad.find(finger);
  return found == nature.sheath_change_rad.end() ? 0 : found->second;
}

PlantedLaw law_of(const std::string& kind, const ContactName& name, const Nature& nature,
                  double condition) {
  const double half_turn = std::numbers::pi;
  if (kind == "bearing")
    return {nature.bearing_mu * half_turn, 0, nature.drag_force_N, nature.drag_slope,
            nature.drag_onset_N};
  const double mu_theta = kind == "tube"
                              ? nature.tube_mu * half_turn
                              : nature.sheath_mu * (2 * half_turn + sheath_change(nature, name));
  return {mu_theta * condition, nature.load_exponent, nature.bending_force_N};
}

// A routing, perhaps cut, in one condition.
class NatureProblem {
 public:
  NatureProblem(const Nature& nature, const Condition& condition, const CutRouting& cut)
      : condition_(condition), cut_(cut) {
    hardware_ = nominal_hardware();
    hardware_.length_override = [this](const std::string& segment, double nominal) {
      return cut_.stand_ins.contains(segment) ? stand_in_length : nominal;
    };
    hardware_.phi_override = [this](const std::string& left, const std::string& right,
                                    double nominal) {
      if (cut_.locked.contains({left, right})) return locked_phi;
      const auto found = phi_.find({left, right});
      return found == phi_.end() ? nominal : found->second;
    };
    solve();
    const double factors = condition_factor(nature, condition);
    for (const ReferenceContact& contact : result_.contacts) {
      const ContactName name{contact.left, contact.right};
      if (!cut.locked.contains(name)) {
        PlantedLaw law = law_of(contact.kind, original(name), nature, factors);
        const auto mounted = condition.exponent_factor.find(original(name));
        if (mounted != condition.exponent_factor.end()) law.phi *= mounted->second;
        laws_.emplace(name, law);
      }
    }
  }

  NatureProblem(const NatureProblem&) = delete;
  NatureProblem& operator=(const NatureProblem&) = delete;

  const ReferenceResult& fixed_point() {
    for (int step = 0; step < 4000; ++step) {
      if (move(step) < 1e-10) return result_;
      solve();
    }
    throw std::runtime_error("planting: no fixed point of the tensions of " + condition_.word);
  }

  bool goes_slack() const {
    return std::any_of(phi_.begin(), phi_.end(),
                       [](const auto& contact) { return contact.second > slack_phi - 1; });
  }

 private:
  void solve() {
    result_ = reference_tensions(cut_.word, condition_.held, condition_.direction, hardware_);
  }

  // By how much the greatest step was to change an exponent.
  double move(int step) {
    const double share = step < 200 ? 1 : step < 600 ? 0.5 : step < 1000 ? 0.2 : 0.05;
    double greatest = 0;
    for (const auto& [name, law] : laws_) {
      const double left = condition_.motor_tension_N * result_.tension.at(name.first);
      const double right = condition_.motor_tension_N * result_.tension.at(name.second);
      const double high = std::max(left, right);
      const double wanted =
          step < 30 ? law.from_high(high) : law.from_low(high, std::min(left, right));
      const auto [at, is_new] = phi_.emplace(name, wanted);
      greatest = std::max(greatest, is_new ? 1.0 : std::abs(wanted - at->second));
      at->second += share * (wanted - at->second);
    }
    return greatest;
  }

  ContactName original(const ContactName& name) const {
    const auto of = [this](const std::string& segment) {
      const auto found = cut_.segment.find(segment);
      return found == cut_.segment.end() ? segment : found->second;
    };
    return {of(name.first), of(name.second)};
  }

  const Condition& condition_;
  const CutRouting& cut_;
  ReferenceHardware hardware_{};
  ReferenceResult result_{};
  std::map<ContactName, PlantedLaw> laws_;
  Exponents phi_;
};

CutRouting cut_of(const Nature& nature, const std::string& word) {
  for (const SeizedContact& seized : nature.seized) {
    if (seized.word == word) return cut_at(word, seized.contact);
  }
  return whole(word);
}

Condition actual(const Nature& nature, Condition condition) {
  for (const WrongGrasp& wrong : nature.wrong_grasps) {
    if (wrong.word != condition.word || wrong.recorded != condition.held) continue;
    condition.held = wrong.actual;
    break;
  }
  return condition;
}

}  // namespace

ReferenceHardware nominal_hardware() {
  const double pi = std::numbers::pi;
  ReferenceHardware hardware{};
  hardware.tube = {0.18, pi};
  hardware.bearing = {0.001, pi};
  hardware.sheath = {0.18, 2 * pi};
  return hardware;
}

std::map<std::string, double> planted_tensions(const Nature& nature, const Condition& recorded) {
  const Condition condition = actual(nature, recorded);
  const CutRouting cut = cut_of(nature, condition.word);
  std::map<std::string, double> tension;
  for (const auto& [segment, original] : whole(condition.word).segment) tension[original] = 0;
  if (cut.word.empty()) {
    tension.at(cut.blocked) = condition.motor_tension_N;
    return tension;
  }
  NatureProblem problem(nature, condition, cut);
  const ReferenceResult& result = problem.fixed_point();
  for (const auto& [segment, original] : cut.segment) {
    tension.at(original) = condition.motor_tension_N * result.tension.at(segment);
  }
  return tension;
}

bool goes_slack(const Nature& nature, const Condition& recorded) {
  if (nature.bending_force_N == 0 && nature.drag_force_N == 0 && nature.load_exponent == 0) {
    return false;
  }
  const Condition condition = actual(nature, recorded);
  const CutRouting cut = cut_of(nature, condition.word);
  if (cut.word.empty()) return false;
  NatureProblem problem(nature, condition, cut);
  try {
    problem.fixed_point();
  } catch (const std::runtime_error&) {
    return true;
  }
  return problem.goes_slack();
}

}  // namespace reeve::testing
