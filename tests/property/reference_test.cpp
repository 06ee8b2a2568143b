// The tension solver against an independent one (support/reference_model.hpp), which is given the
// word and the numbers of the hardware and shares no code with the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/property/observed_state.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve {
namespace {

using testing::ReferenceDirection;
using testing::ReferenceHardware;
using testing::ReferenceResult;
using testing::Trial;

using testing::ContactName;

std::map<ContactName, double> exponents_by_name(const Network& network, const Mechanics& m) {
  std::map<ContactName, double> phi;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      phi[testing::name_of(network, tendon, k)] = m.phi[tendon.first_contact + k];
    }
  }
  return phi;
}

std::map<std::string, double> lengths_by_name(const Network& network, const Mechanics& m) {
  std::map<std::string, double> length;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    length[segment_name(network.segments[i])] = m.length[i];
  }
  return length;
}

ReferenceHardware reference_hardware(const Network& network, const Mechanics& m) {
  ReferenceHardware hardware{};
  const auto phi = exponents_by_name(network, m);
  const auto length = lengths_by_name(network, m);
  hardware.phi_override = [phi](const std::string& left, const std::string& right, double) {
    return phi.at({left, right});
  };
  hardware.length_override = [length](const std::string& segment, double) {
    return length.at(segment);
  };
  for (int f = 1; f <= network.fingers; ++f) {
    hardware.closing_weight[f] = m.closing[static_cast<std::size_t>(f - 1)];
  }
  return hardware;
}

ReferenceResult reference(const Trial& trial, const Mechanics& m) {
  const std::vector<int> held = held_fingers(trial.grasp);
  return testing::reference_tensions(
      to_word(trial.routing), std::set<int>(held.begin(), held.end()),
      trial.direction == Direction::pull ? ReferenceDirection::pull : ReferenceDirection::release,
      reference_hardware(trial.network, m));
}

struct Seen {
  int jams = 0;
  int slack = 0;
  int loops = 0;
  int released = 0;
  int several_tendons = 0;
  int frictionless_contacts = 0;
};

void count(const Trial& trial, const Mechanics& m, const TensionState& state, Seen& seen) {
  seen.jams += state.jams;
  seen.slack += std::count(state.tension.begin(), state.tension.end(), 0.0) > 0;
  seen.loops += std::any_of(trial.network.tendons.begin(), trial.network.tendons.end(),
                            [](const TendonSpan& t) { return t.closed; });
  seen.released += trial.direction == Direction::release;
  seen.several_tendons += trial.network.tendons.size() > 1;
  seen.frictionless_contacts += std::count(m.phi.begin(), m.phi.end(), 0.0) > 0;
}

TEST(ReferenceProperty, TensionsSlipsAndClosingsAreThoseOfAnIndependentSolver) {
  Seen seen;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    const Mechanics m = mechanics(trial.network, trial.hardware);
    const TensionState state = tensions(trial.network, m, trial.grasp, trial.direction);
    const ReferenceResult expected = reference(trial, m);
    EXPECT_EQ(testing::disagreement(to_word(trial.routing), expected,
                                    testing::observed(trial.network, m, state)),
              "");
    count(trial, m, state, seen);
    if (::testing::Test::HasFailure()) return;
  }
  for (const int cases : {seen.jams, seen.slack, seen.loops, seen.released, seen.several_tendons,
                          seen.frictionless_contacts}) {
    EXPECT_GT(cases, 50);
  }
}

}  // namespace
}  // namespace reeve
