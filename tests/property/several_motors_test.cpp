// Routings of several motors, whose carriages move as the grasp says, with second tendons on
// fingers, and of ends on spools of
// their own, locked, or behind springs and slack, against the independent solver.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "core/performance.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::ReferenceHardware;
using testing::ReferenceResult;

// Quarters add up to exactly nothing often enough.
CarriageTravels random_travels(Dice& dice, int motors) {
  CarriageTravels travels;
  if (motors == 2 && dice.chance(0.3)) return {2, {0.5, -0.5, 1, 1, 1, 1}};
  for (int motor = 0; motor < motors; ++motor) {
    travels.over_D[travels.given++] = 0.25 * dice.integer(-4, 8);
  }
  return travels;
}

struct MotorTrial {
  std::string word;
  Grasp grasp;
  Direction direction = Direction::pull;
  ReferenceHardware laws;
  TendonParts tendon{};
  std::map<std::string, double> springs_mm{};  // as a length of tendon, by the end that has one
};

std::string to_text(const MotorTrial& trial) {
  return trial.word + ", held " + to_text(trial.grasp) +
         (trial.direction == Direction::pull ? ", pulled" : ", released");
}

MotorTrial random_motor_trial(Dice& dice, const Routing& one_motor) {
  MotorTrial trial;
  const Routing routing = testing::with_several_motors(dice, one_motor);
  trial.word = to_word(routing);
  trial.grasp = testing::random_grasp(dice, finger_count(routing));
  trial.grasp.carriages = random_travels(dice, carriage_count(routing));
  trial.direction = dice.chance(0.7) ? Direction::pull : Direction::release;
  trial.laws = testing::random_reference_hardware(dice, trial.word);
  for (int motor = 1; motor <= trial.grasp.carriages.given; ++motor) {
    trial.laws.carriage_travel[motor] = trial.grasp.travel(motor);
  }
  return trial;
}

std::map<std::string, double> random_spools(Dice& dice, const Network& network) {
  std::map<std::string, double> spools;
  for (const Segment& segment : network.segments) {
    if (!find_motor_end(network, segment) || dice.chance(0.5)) continue;
    const double ratio = dice.chance(0.5) ? 0.5 : dice.log_real(0.2, 5);
    spools[segment_name(segment)] = dice.chance(0.2) ? -ratio : ratio;
  }
  return spools;
}

void lock_ends(Dice& dice, const Network& network, MotorTrial& trial) {
  const MotorEnds ends = motor_ends(network);
  for (const std::uint64_t end : ends) {
    const std::uint64_t locked = trial.grasp.locked | end;
    const bool moves = locked + 1 != std::uint64_t{1} << ends.size();
    if (moves && dice.chance(0.35)) trial.grasp.locked = locked;
  }
  for (const std::string& name : locked_ends(trial.grasp)) trial.laws.locked.insert(name);
}

// At most one of a spring and slack stands at each tendon.
void add_springs(Dice& dice, const Network& network, MotorTrial& trial) {
  constexpr double EA_N = 3000;
  constexpr double travel_mm = 50;
  trial.tendon = {EA_N, travel_mm, {}};
  trial.laws.length_override = nullptr;  // it would not know of the springs
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    std::vector<std::string> sides;
    std::vector<std::string> ends;
    for (std::size_t i = 0; i < network.tendons[t].segments; ++i) {
      const Segment& segment = network.segments[network.tendons[t].first_segment + i];
      if (segment.kind != SegmentKind::motor_side) continue;
      sides.push_back(segment_name(segment));
      if (find_motor_end(network, segment)) ends.push_back(sides.back());
    }
    TendonHardware own{static_cast<int>(t) + 1, {}, {}};
    if (ends.size() == 1 && dice.chance(0.6)) {
      own.stiffness_N_mm = dice.log_real(0.5, 500);
      trial.springs_mm[ends.front()] = EA_N / *own.stiffness_N_mm;
    } else if (!sides.empty() && !is_tied(network, network.tendons[t]) && dice.chance(0.5)) {
      own.slack_mm = dice.log_real(0.5, 100);
      trial.laws.slack[sides.back()] = *own.slack_mm / travel_mm;
    }
    if (own.stiffness_N_mm || own.slack_mm) trial.tendon.own.push_back(own);
  }
}

ReferenceHardware with_springs(const MotorTrial& trial) {
  ReferenceHardware laws = trial.laws;
  if (trial.springs_mm.empty()) return laws;
  laws.length_override = [springs_mm = trial.springs_mm](const std::string& name, double nominal) {
    const auto spring = springs_mm.find(name);
    return spring == springs_mm.end() ? nominal : nominal + spring->second;
  };
  return laws;
}

struct SeenMotors {
  int solved = 0;
  int jams = 0;
  int released = 0;
  int lets_out = 0;      // a carriage pulls, another lets out
  int turns = 0;         // … and no finger closes
  int stands_still = 0;  // a carriage
  int refused = 0;
  int opposed = 0;    // tendons that share fingers
  int unsolved = 0;   // by the library alone
  int unchecked = 0;  // by the reference alone
};

bool lets_out(const MotorTrial& trial) {
  const std::vector<double> travels = carriage_travels(trial.grasp);
  return std::any_of(travels.begin(), travels.end(), [](double way) { return way < 0; }) ||
         std::any_of(trial.laws.spool.begin(), trial.laws.spool.end(),
                     [](const auto& spool) { return spool.second < 0; });
}

void count(const MotorTrial& trial, const TensionState& state, SeenMotors& seen) {
  const std::vector<double> travels = carriage_travels(trial.grasp);
  ++seen.solved;
  seen.jams += state.jams;
  seen.released += trial.direction == Direction::release;
  seen.lets_out += lets_out(trial);
  seen.turns += lets_out(trial) && !state.jams &&
                std::count(state.closing.begin(), state.closing.end(), 0.0) ==
                    static_cast<std::ptrdiff_t>(state.closing.size());
  seen.stands_still += std::count(travels.begin(), travels.end(), 0.0) > 0;
}

void compare(const MotorTrial& trial, SeenMotors& seen) {
  const Network network = expand(parse_routing(trial.word));
  const Mechanics m = testing::mechanics_of(network, trial.laws, trial.tendon);
  TensionState state;
  TensionSolver().solve(network, m, trial.grasp, trial.direction, state);
  const auto reference = [&] {
    return testing::reference_tensions(trial.word, trial.grasp, trial.direction,
                                       with_springs(trial));
  };
  if (!state.in_range) {
    try {
      const ReferenceResult found = reference();
      const bool pulls = std::any_of(found.tension.begin(), found.tension.end(),
                                     [](const auto& tension) { return tension.second > 0; });
      ++(pulls ? seen.unsolved : seen.refused);
    } catch (const std::exception&) {  // or no state meets the conditions of either
      ++seen.refused;
    }
    return;
  }
  const testing::ComparisonTolerance tight{1e-9, 1e-15, 1e-9};
  ReferenceResult expected;
  try {
    expected = reference();
  } catch (const std::logic_error&) {
    // It finds no state of jams in which carriages let out as much as others pull.
    if (!state.jams || network.blocks.empty() || !lets_out(trial)) throw;
    ++seen.unchecked;
    return;
  }
  seen.opposed += expected.opposed;
  EXPECT_EQ(expected.jams, state.jams);
  if (!expected.opposed) {
    EXPECT_EQ(
        testing::disagreement(trial.word, expected, testing::observed(network, m, state), tight),
        "");
  }
  count(trial, state, seen);
}

void expect_all_seen(const SeenMotors& seen, int trials) {
  for (const int cases : {seen.jams, seen.released, seen.lets_out, seen.stands_still}) {
    EXPECT_GT(cases, trials / 100);
  }
  EXPECT_GT(seen.turns, 5);
  EXPECT_GT(seen.solved, trials / 2);
  EXPECT_EQ(seen.unsolved, 0);
  EXPECT_LT(seen.unchecked, trials / 500);
}

template <typename NextRouting>
void expect_solved_alike(std::uint64_t trials, const NextRouting& next_routing) {
  SeenMotors seen;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Dice dice(seed);
    const MotorTrial trial = random_motor_trial(dice, next_routing(dice));
    SCOPED_TRACE(std::to_string(seed) + ": " + to_text(trial));
    compare(trial, seen);
    if (::testing::Test::HasFailure()) return;
  }
  expect_all_seen(seen, static_cast<int>(trials));
}

TEST(SeveralMotorsProperty, TensionsSlipsAndClosingsAreThoseOfAnIndependentSolver) {
  expect_solved_alike(1500, [](Dice& dice) {
    return testing::random_routing(dice, {1, 4, true, true});
  });
}

TEST(SeveralMotorsProperty, TreesAndTacklesAreThoseOfAnIndependentSolver) {
  expect_solved_alike(3000,
                      [](Dice& dice) { return parse_routing(testing::random_mechanism(dice)); });
}

// Draws routings without and with blocks, a quarter of them with one motor.
MotorTrial random_trial(Dice& dice) {
  const Routing one = dice.chance(0.5) ? testing::random_routing(dice, {1, 4, true, true})
                                       : parse_routing(testing::random_mechanism(dice));
  MotorTrial trial = random_motor_trial(dice, one);
  if (dice.chance(0.25)) {
    trial.word = to_word(one);
    trial.grasp.carriages = {};
    trial.laws.carriage_travel.clear();
  }
  return trial;
}

TEST(SeveralMotorsProperty, UnequalSpoolsAreThoseOfAnIndependentSolver) {
  constexpr int trials = 2000;
  SeenMotors seen;
  int with_spools = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Dice dice(seed);
    MotorTrial trial = random_trial(dice);
    trial.laws.spool = random_spools(dice, expand(parse_routing(trial.word)));
    with_spools += trial.laws.spool.empty() ? 0 : 1;
    SCOPED_TRACE(std::to_string(seed) + ": " + to_text(trial));
    compare(trial, seen);
    if (::testing::Test::HasFailure()) return;
  }
  expect_all_seen(seen, trials);
  EXPECT_GT(with_spools, trials / 3);
}

TEST(SeveralMotorsProperty, LockedEndsSpringsAndSlackAreThoseOfAnIndependentSolver) {
  constexpr int trials = 3000;
  SeenMotors seen;
  int locked = 0;
  int sprung = 0;
  int slack = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Dice dice(seed);
    MotorTrial trial = random_trial(dice);
    const Network network = expand(parse_routing(trial.word));
    trial.laws.spool = random_spools(dice, network);
    lock_ends(dice, network, trial);
    add_springs(dice, network, trial);
    locked += trial.grasp.locked != 0;
    sprung += trial.tendon.own.size() > trial.laws.slack.size();
    slack += !trial.laws.slack.empty();
    SCOPED_TRACE(std::to_string(seed) + ": " + to_text(trial));
    compare(trial, seen);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(seen.solved, trials / 2);
  EXPECT_GT(seen.jams, trials / 100);
  EXPECT_EQ(seen.unsolved, 0);
  for (const int cases : {locked, sprung, slack}) EXPECT_GT(cases, trials / 5);
}

TEST(SeveralMotorsProperty, SecondTendonsAreThoseOfAnIndependentSolver) {
  constexpr int trials = 3000;
  SeenMotors seen;
  int shared = 0;
  int opening = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Dice dice(seed);
    MotorTrial trial = random_motor_trial(dice, testing::random_shared_routing(dice));
    const Network network = expand(parse_routing(trial.word));
    if (!network.shared) continue;
    ++shared;
    trial.laws.spool = random_spools(dice, network);
    SCOPED_TRACE(std::to_string(seed) + ": " + to_text(trial));
    compare(trial, seen);
    if (::testing::Test::HasFailure()) return;
    TensionState state;
    TensionSolver().solve(network, testing::mechanics_of(network, trial.laws), trial.grasp,
                          Direction::pull, state);
    opening +=
        std::any_of(state.closing.begin(), state.closing.end(), [](double way) { return way < 0; });
  }
  EXPECT_GT(seen.solved - seen.jams, shared / 5);
  EXPECT_GT(seen.opposed, shared / 20);
  EXPECT_GT(opening, shared / 50);
  EXPECT_EQ(seen.unsolved, 0);
}

// The same word with another tendon on each tied finger, which its motor lets out, or holds still
// while its finger closes.
std::string with_idle_tendons(const std::string& word, const Network& network, int motor) {
  std::string idle = word;
  for (int f = 1; f <= network.fingers; ++f) {
    const auto strand = [&](int side) {
      return find_segment(network, {SegmentKind::strand, 2 * f - 2 + side, f}).has_value();
    };
    if (strand(1) && !strand(2)) idle += fmt::format("+M{}-{}e", motor, f);
  }
  return idle;
}

TEST(SeveralMotorsProperty, IdleSecondTendonsChangeNothing) {
  int with_idle = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Dice dice(seed);
    const Routing one = parse_routing(testing::random_mechanism(dice));
    const std::string word = to_word(one);
    const Network network = expand(one);
    if (carriage_count(one) == max_carriages || network.fingers > most_second_tendons) continue;
    const std::string idle_word = with_idle_tendons(word, network, carriage_count(one) + 1);
    const Network idle_network = expand(parse_routing(idle_word));
    if (!idle_network.shared) continue;
    const ReferenceHardware laws = testing::random_reference_hardware(dice, word);
    Grasp grasp = testing::random_grasp(dice, network.fingers);
    TensionState state;
    TensionSolver().solve(network, testing::mechanics_of(network, laws), grasp, Direction::pull,
                          state);
    if (!state.in_range) continue;
    grasp.carriages.given = static_cast<std::uint8_t>(carriage_count(one) + 1);
    grasp.carriages.over_D[grasp.carriages.given - std::size_t{1}] = -50;
    TensionState idle;
    TensionSolver().solve(idle_network, testing::mechanics_of(idle_network, laws), grasp,
                          Direction::pull, idle);
    SCOPED_TRACE(std::to_string(seed) + ": " + idle_word + ", held " + to_text(grasp));
    if (idle.fault == TensionFault::uneven_sharing) continue;
    ASSERT_EQ(idle.jams, state.jams);
    ++with_idle;
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      ASSERT_NEAR(idle.tension[i], state.tension[i], 1e-12);
    }
    for (std::size_t f = 0; f < state.closing.size(); ++f) {
      ASSERT_NEAR(idle.closing[f], state.closing[f], 1e-12);
    }
  }
  EXPECT_GT(with_idle, 50);
}

// Σ T_i dl_i + Σ friction force × slip = Σ_c T_Mc D_c, T_Mc = Σ r_i T_i.
TEST(SeveralMotorsProperty, EfficiencyIsOneWithoutFrictionAndLessWithIt) {
  int without = 0;
  int with = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Dice dice(seed);
    const Routing one = dice.chance(0.5) ? testing::random_shared_routing(dice)
                                         : testing::random_routing(dice, {1, 4, true, true});
    MotorTrial trial = random_motor_trial(dice, one);
    trial.laws.spool = random_spools(dice, expand(parse_routing(trial.word)));
    trial.direction = Direction::pull;
    if (seed % 2 == 0) {
      trial.laws.phi_override = [](const std::string&, const std::string&, double) { return 0.0; };
    }
    const Network network = expand(parse_routing(trial.word));
    TensionState state;
    TensionSolver().solve(network, testing::mechanics_of(network, trial.laws), trial.grasp,
                          Direction::pull, state);
    if (!state.in_range || state.jams) continue;
    SCOPED_TRACE(std::to_string(seed) + ": " + to_text(trial));
    const double efficiency = performance(network, state).efficiency;
    const bool closes = std::any_of(state.closing.begin(), state.closing.end(),
                                    [](double way) { return way != 0; });
    if (!closes) {
      EXPECT_EQ(efficiency, 0);
    } else if (seed % 2 == 0) {
      ++without;
      EXPECT_NEAR(efficiency, 1, 1e-12);
    } else {
      ++with;
      EXPECT_LE(efficiency, 1 + 1e-12);
    }
  }
  EXPECT_GT(without, 30);
  EXPECT_GT(with, 30);
}

}  // namespace
}  // namespace reeve
