// The tension solver against an independent one (support/reference_model.hpp), which is given the
// word and the numbers of the hardware and shares no code with the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::ReferenceResult;
using testing::Trial;

ReferenceResult reference(const Trial& trial, const Mechanics& m) {
  return testing::reference_tensions(
      to_word(trial.routing), trial.grasp, trial.direction,
      testing::reference_hardware(trial.network, m, testing::exponents_by_name(trial.network, m)));
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
    EXPECT_EQ(
        testing::disagreement(to_word(trial.routing), expected,
                              testing::observed(trial.network, m, state), {1e-9, 1e-15, 1e-9}),
        "");
    count(trial, m, state, seen);
    if (::testing::Test::HasFailure()) return;
  }
  for (const int cases : {seen.jams, seen.slack, seen.loops, seen.released, seen.several_tendons,
                          seen.frictionless_contacts}) {
    EXPECT_GT(cases, 50);
  }
}

TEST(ReferenceComparison, NamesTheFirstDisagreementOfTwoAnswers) {
  testing::ReferenceHardware hardware{};
  hardware.tube = hardware.bearing = hardware.sheath = {0.18, 3};
  const char* word = "M-Y1+1x-Y1-2x";
  const ReferenceResult expected =
      testing::reference_tensions(word, hold({1}), Direction::pull, hardware);
  EXPECT_EQ(testing::disagreement(word, expected, expected), "");
  ReferenceResult other = expected;
  other.tension["T3"] *= 1.00001;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 3), "T3:");
  other = expected;
  other.contacts.back().slip = 1;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 13), "slip at T1-T3");
  other = expected;
  other.closing[2] = 1;
  EXPECT_EQ(testing::disagreement(word, expected, other).substr(0, 19), "closing of finger 2");
  other = expected;
  other.jams = true;
  EXPECT_EQ(testing::disagreement(word, expected, other), "jams");
}

}  // namespace
}  // namespace reeve
