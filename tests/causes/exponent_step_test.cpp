// One step of Newton's method: near the solution its error is of second order, which that of going
// all of the way is not.
#include "causes/exponent_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/tension/tension.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using causes::ExponentErrors;
using causes::ExponentStep;
using testing::Dice;
using testing::Trial;

// phi_k = p_k T_high,k^-gamma, at T_M = 1.
constexpr double gamma_ = 0.2;

class PowerLaw {
 public:
  explicit PowerLaw(const Trial& trial)
      : trial_(trial), nominal_(mechanics(trial.network, trial.hardware)), at_(nominal_) {}

  const Mechanics& at() const { return at_; }
  const TensionState& state() const { return state_; }

  void solve_at(const std::vector<double>& phi) {
    at_.phi = phi;
    for (std::size_t k = 0; k < phi.size(); ++k) at_.decay[k] = std::exp(-phi[k]);
    TensionSolver().solve(trial_.network, at_, trial_.grasp, trial_.direction, state_);
    errors_.way.assign(phi.size(), 0.0);
    errors_.slope.assign(phi.size(), 0.0);
    for (const TendonSpan& tendon : trial_.network.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) look_at(tendon, k);
    }
  }

  const ExponentErrors& errors() const { return errors_; }

 private:
  void look_at(const TendonSpan& tendon, std::size_t k) {
    const auto [left, right] = ends_of(tendon, k);
    const std::size_t contact = tendon.first_contact + k;
    const double high = std::max(state_.tension[left], state_.tension[right]);
    if (high == 0) return;
    const double wanted = nominal_.phi[contact] * std::pow(high, -gamma_);
    errors_.way[contact] = wanted - at_.phi[contact];
    errors_.slope[contact] = -gamma_ * wanted;
  }

  const Trial& trial_;
  Mechanics nominal_;
  Mechanics at_;
  TensionState state_;
  ExponentErrors errors_;
};

double greatest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

// All of the way, so often that nothing is left of it.
std::vector<double> settled(PowerLaw& law) {
  std::vector<double> phi = law.at().phi;
  for (int turn = 0; turn < 300; ++turn) {
    law.solve_at(phi);
    phi = sum(phi, law.errors().way);
    if (greatest(law.errors().way) < 1e-14) break;
  }
  return phi;
}

TEST(ExponentStep, LeavesAnErrorOfSecondOrder) {
  int tried = 0;
  int loops = 0;
  int several = 0;
  int worse = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Trial trial = testing::random_trial(seed, {1, 4, true, true});
    if (!trial.network.blocks.empty()) continue;
    PowerLaw law(trial);
    const std::vector<double> there = settled(law);
    if (!law.state().in_range || greatest(law.errors().way) > 1e-12) continue;
    Dice dice(seed + 77);
    std::vector<double> near = there;
    for (double& phi : near) phi *= 1 + dice.real(-1e-4, 1e-4);
    law.solve_at(near);
    const double before = greatest(law.errors().way);
    if (before < 1e-8) continue;
    ExponentStep step;
    const std::vector<double> changes =
        step.changes(trial.network, law.at(), law.state(), law.errors());
    law.solve_at(sum(near, changes));
    ++tried;
    loops += trial.network.tendons[0].closed ? 1 : 0;
    several += trial.network.tendons.size() > 1 ? 1 : 0;
    // Where a contact begins to slide in between, it is of first order.
    worse += greatest(law.errors().way) > 1e-3 * before ? 1 : 0;
  }
  EXPECT_GT(tried, 150);
  EXPECT_GT(loops, 20);
  EXPECT_GT(several, 20);
  EXPECT_LE(worse, tried / 50);
}

}  // namespace
}  // namespace reeve
