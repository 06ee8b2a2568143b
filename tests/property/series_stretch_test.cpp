// Carriage travel that springs in series take, against a solver of contacts that pulls the carriage
// in small steps, with springs of any stiffness.
#include "core/series_stretch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/reference_loading.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::LoadedPull;
using testing::ReferenceHardware;

constexpr double stiff_EA_N = 1e8;  // beside which the tendons' own lengths give way by nothing
constexpr int loading_steps = 1000;

struct SprungTrial {
  std::string word;
  Network network;
  Grasp grasp;
  ReferenceHardware laws;
  TendonParts tendon{stiff_EA_N, {}, {}};
  std::map<std::string, double> springs_mm{};  // as a length of tendon, by the end that has one
};

void add_springs(Dice& dice, SprungTrial& trial) {
  for (std::size_t t = 0; t < trial.network.tendons.size(); ++t) {
    const TendonSpan& tendon = trial.network.tendons[t];
    std::vector<std::string> ends;
    for (std::size_t i = 0; i < tendon.segments; ++i) {
      const Segment& segment = trial.network.segments[tendon.first_segment + i];
      if (find_motor_end(trial.network, segment)) ends.push_back(segment_name(segment));
    }
    if (ends.size() != 1 || dice.chance(0.2)) continue;
    const double stiffness = dice.log_real(0.5, 5);
    trial.tendon.own.push_back({static_cast<int>(t) + 1, stiffness, {}});
    trial.springs_mm[ends.front()] = stiff_EA_N / stiffness;
  }
  trial.laws.length_override = [springs_mm = trial.springs_mm](const std::string& name,
                                                               double nominal) {
    const auto spring = springs_mm.find(name);
    return spring == springs_mm.end() ? nominal : nominal + spring->second;
  };
}

SprungTrial random_sprung_trial(std::uint64_t seed) {
  Dice dice(seed);
  SprungTrial trial;
  trial.word = testing::random_mechanism(dice, {4, 2, 0.2, 0.2});
  trial.network = expand(parse_routing(trial.word));
  trial.laws = testing::random_reference_hardware(dice, trial.word);
  trial.grasp = testing::random_grasp(dice, trial.network.fingers);
  add_springs(dice, trial);
  return trial;
}

std::optional<LoadedPull> loaded(const SprungTrial& trial, double take_up) {
  const std::vector<int> held = held_fingers(trial.grasp);
  try {
    return testing::loaded_pull(trial.word, {held.begin(), held.end()}, trial.laws, loading_steps,
                                take_up);
  } catch (const std::exception&) {  // a jam, or a step without a state
    return std::nullopt;
  }
}

double greatest_difference(const SprungTrial& trial, const TensionState& state,
                           const LoadedPull& pull) {
  double difference = 0;
  for (std::size_t i = 0; i < trial.network.segments.size(); ++i) {
    const double tension = pull.tension.at(segment_name(trial.network.segments[i])) / pull.motor;
    difference = std::max(difference, std::abs(tension - state.tension[i]));
  }
  return difference;
}

struct SeenStretches {
  int compared = 0;
  int lossless = 0;
  int several_sides = 0;  // whose stretch is less than that of their springs
  int limited = 0;        // by contacts that slide otherwise behind softer springs
  int differ_beyond = 0;  // of these, with other tensions beyond the limit
};

void compare(const SprungTrial& trial, SeenStretches& seen) {
  const Mechanics m = testing::mechanics_of(trial.network, trial.laws, trial.tendon);
  TensionState state;
  TensionSolver().solve(trial.network, m, trial.grasp, Direction::pull, state);
  if (!state.in_range || state.jams || m.springs_mm.empty()) return;
  const SeriesStretch stretch = series_stretch(trial.network, m, trial.grasp, state);
  // Less: trees without a spring take the whole force.
  if (!stretch.is_known || stretch.travel_mm_N < 1e-3 || std::isinf(stretch.sliding_mm_N)) return;
  const double most = 1 / (1 + stretch.sliding_mm_N / stretch.travel_mm_N);
  const double take_up = std::min(0.9 * most, 0.6);
  const auto pull = loaded(trial, take_up);
  if (!pull) return;
  ++seen.compared;
  seen.lossless += stretch.is_lossless;
  seen.several_sides += !stretch.is_lossless;
  EXPECT_LT(greatest_difference(trial, state, *pull), 0.02);
  EXPECT_NEAR(stretch.travel_mm(stiff_EA_N * pull->motor) / take_up, 1, 0.02);
  if (stretch.sliding_mm_N == 0) return;
  ++seen.limited;
  const auto beyond = loaded(trial, std::min(0.95, most + 0.4 * (1 - most)));
  seen.differ_beyond += beyond && greatest_difference(trial, state, *beyond) > 0.02;
}

TEST(SeriesStretchProperty, IsTheTravelOfCarriagesThatPullSoftSprings) {
  SeenStretches seen;
  for (std::uint64_t seed = 1; seed <= 800; ++seed) {
    const SprungTrial trial = random_sprung_trial(seed);
    SCOPED_TRACE(std::to_string(seed) + ": " + trial.word + ", held " + to_text(trial.grasp));
    compare(trial, seen);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(seen.compared, 300);
  EXPECT_GT(seen.lossless, 100);
  EXPECT_GT(seen.several_sides, 100);
  EXPECT_GT(seen.limited, 50);
  EXPECT_GT(seen.differ_beyond, 20);
}

}  // namespace
}  // namespace reeve
