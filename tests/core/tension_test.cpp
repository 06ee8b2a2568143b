#include "core/tension/tension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/notation.hpp"
#include "core/part_prices.hpp"
#include "core/performance.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using std::exp;
using std::numbers::pi;
using testing::solved_network;

// ---- the paper's closed forms, finger 1 held ----

// Friction exponents of the paper's three kinds of contact.
struct Friction {
  double s;  // sheath: mu_s theta_s
  double t;  // tube: mu_t pi
  double b;  // bearing: mu_b pi
};

using Strands = std::array<double, 4>;  // T1 … T4 at T_M = 1

Strands equation_5(const Friction& f) {  // TR1
  return {exp(-f.s), exp(-f.s - f.t), exp(-f.s - 2 * f.t), exp(-f.s - 3 * f.t)};
}

Strands equation_8(const Friction& f) {  // TR2
  const double k = 1 / (1 + exp(-f.t));
  return {k * exp(-f.s), k * exp(-f.s - f.t), k * exp(-f.s - 2 * f.t), k * exp(-f.s - f.t)};
}

Strands equation_11(const Friction& f) {  // TR3
  const double k = 1 / (1 + exp(-f.b));
  return {k * exp(-f.s - f.t), k * exp(-f.s), k * exp(-f.b - f.s), k * exp(-f.b - f.s - f.t)};
}

Strands equation_14(const Friction& f) {  // TR4
  const double k = 1 / (1 + exp(-2 * f.s - f.t) + exp(-2 * f.s - f.t - f.b));
  return {k * exp(-f.s), k * exp(-f.s - f.t), k * exp(-3 * f.s - f.t - f.b),
          k * exp(-3 * f.s - 2 * f.t - f.b)};
}

Strands equation_17(const Friction& f) {  // TR5
  const double k = 1 / (1 + exp(-2 * f.s - f.t) * (1 + exp(-f.b) + exp(-f.t - f.b)));
  return {k * exp(-f.s), k * exp(-f.s - f.t), k * exp(-3 * f.s - f.t - f.b),
          k * exp(-3 * f.s - 2 * f.t - f.b)};
}

Strands equation_20(const Friction& f) {  // TR6
  const double k = 1 / (1 + exp(-f.b));
  return {k * exp(-f.s), k * exp(-f.s - f.t), k * exp(-f.b - f.s - f.t), k * exp(-f.s - f.b)};
}

Strands equation_23(const Friction& f) {  // TR7
  const double k = 0.5 / (1 + exp(-f.b));
  return {k * exp(-f.s), k * exp(-f.s), k * exp(-f.s - f.b), k * exp(-f.s - f.b)};
}

Hardware random_coefficients(testing::Dice& dice) {
  Hardware hardware;
  hardware.tube.mu = dice.real(0.01, 0.4);
  hardware.sheath = {dice.real(0.01, 0.4), dice.real(0.5, 12)};
  hardware.bearing.mu = dice.log_real(1e-4, 0.02);
  return hardware;
}

Friction exponents(const Hardware& h) {
  return {h.sheath.exponent(), h.tube.exponent(), h.bearing.exponent()};
}

void expect_strands(const std::string& word, const Hardware& hardware, const Strands& expected) {
  const auto found = solved_network(word, hardware, hold({1}));
  for (std::size_t i = 0; i < 4; ++i) {
    const double tension = found["T" + std::to_string(i + 1)];
    EXPECT_NEAR(tension, expected[i], 1e-9 * expected[i]) << word << " T" << i + 1;
  }
}

void expect_closed_form(const std::string& word, Strands (*equation)(const Friction&),
                        bool (*applies)(const Hardware&)) {
  testing::Dice dice(20);
  for (int found = 0; found < 1000;) {
    const Hardware hardware = random_coefficients(dice);
    if (!applies(hardware)) continue;
    expect_strands(word, hardware, equation(exponents(hardware)));
    ++found;
  }
}

bool always(const Hardware&) { return true; }

TEST(PaperTension, Equation5GivesTr1) { expect_closed_form("M-1-T-2-F", equation_5, always); }
TEST(PaperTension, Equation8GivesTr2) { expect_closed_form("M-1-T-2-M", equation_8, always); }
TEST(PaperTension, Equation11GivesTr3) { expect_closed_form("F-1-P-2-F", equation_11, always); }
TEST(PaperTension, Equation14GivesTr4) { expect_closed_form("M-1-P-2-F", equation_14, always); }
TEST(PaperTension, Equation17GivesTr5) { expect_closed_form("M-1-P-2-M", equation_17, always); }
TEST(PaperTension, Equation23GivesTr7) { expect_closed_form("1-P-2-P-1", equation_23, always); }

// Eq. 20 lets T2 and T3 differ by the bearing's factor while the tube between them holds, which a
// tube can do only if it has at least the bearing's friction.
bool tube_can_hold_against_the_bearing(const Hardware& h) { return h.bearing.mu <= h.tube.mu; }

TEST(PaperTension, Equation20GivesTr6WhileTheTubeHolds) {
  expect_closed_form("1-T-2-P-1", equation_20, tube_can_hold_against_the_bearing);
}

TEST(PaperTension, WithABearingWorseThanTheTubeTr6SlidesThroughTheTubeInstead) {
  Hardware hardware;
  hardware.tube.mu = 0.01;
  hardware.bearing.mu = 0.02;
  const auto found = solved_network("1-T-2-P-1", hardware, hold({1}));
  const Friction f = exponents(hardware);
  EXPECT_NEAR(found["T3"], found["T2"] * exp(-f.t), 1e-12);  // Eq. 20 has e^{-b}
  EXPECT_GT(found["b"], found["a"] * exp(-f.b));             // the pulley stands
}

// ---- release, jam, bench ----

TEST(Tension, ReleasingTurnsEveryRatioOfASlidingTendonRound) {
  const auto found = solved_network("M-1-T-2-F", Hardware{}, Grasp{}, Direction::release);
  const Friction f = exponents(Hardware{});
  EXPECT_NEAR(found["T1"], exp(f.s), 1e-12);
  EXPECT_NEAR(found["T4"], exp(f.s + 3 * f.t), 1e-10);
}

TEST(Tension, OfAJammedTendonFallsFromTheCarriageAtEveryContact) {
  const auto found = solved_network("M-1-F", Hardware{}, hold({1}));
  const Friction f = exponents(Hardware{});
  EXPECT_TRUE(found.state.jams);
  EXPECT_NEAR(found["T1"], exp(-f.s), 1e-12);
  EXPECT_NEAR(found["T2"], exp(-f.s - f.t), 1e-12);
}

TEST(Tension, OfAJammedTendonInReleaseIsHighestAtTheHand) {
  // T1 and T2 stay stretched by the same length; a gives way as far as its sheath lets it.
  const auto found = solved_network("M-1-F", Hardware{}, hold({1}), Direction::release);
  const Friction f = exponents(Hardware{});
  EXPECT_NEAR(found["T1"], exp(f.s), 1e-12);
  EXPECT_NEAR(found["T2"], found["T1"] * (1 + exp(-f.s)), 1e-12);  // T2 L = T1 L + a L
}

TEST(Tension, OnATestBenchIsTheSheathsCapstanFactor) {
  const double s = Hardware{}.sheath.exponent();
  EXPECT_NEAR(solved_network("M-F", Hardware{}, Grasp{})["h1"], exp(-s), 1e-12);
  EXPECT_NEAR(solved_network("M-F", Hardware{}, Grasp{}, Direction::release)["h1"], exp(s), 1e-12);
  const double t = Hardware{}.tube.exponent();
  EXPECT_NEAR(solved_network("M-T-F", Hardware{}, Grasp{})["h2"], exp(-s - t), 1e-12);
}

TEST(Tension, AJammedTendonTakesTheWholeMotorTension) {
  const auto found = solved_network("M-1-F+M-2-F", Hardware{}, hold({2}));
  EXPECT_TRUE(found.state.jams);
  EXPECT_EQ(found["a"], 0);
  EXPECT_EQ(found["T1"], 0);
  EXPECT_EQ(found["T2"], 0);
  EXPECT_DOUBLE_EQ(found["b"], 1);
}

TEST(Tension, JammedTendonsShareTheMotorTensionByStiffness) {
  Hardware hardware;
  hardware.tube.mu = hardware.sheath.mu = 0;
  FingerHardware second;
  second.finger = 2;
  second.strand_mm = 300;
  hardware.fingers = {second};
  // Frictionless: T L = travel, with L = 300 and 700 mm.
  const auto found = solved_network("M-1-F+M-2-F", hardware, hold({1, 2}));
  EXPECT_NEAR(found["a"], 0.7, 1e-12);
  EXPECT_NEAR(found["b"], 0.3, 1e-12);
}

std::string tendon_through_all(int fingers) {
  std::string word = "M-1";
  for (int f = 2; f <= fingers; ++f) word += "-T-" + std::to_string(f);
  return word + "-F";
}

TEST(Tension, FallsAtEveryContactHoweverManyThereAre) {
  // Everything slides to the carriage, or hangs behind what does: T = e^{-s - (2n - 1) t}.
  for (int fingers = 2; fingers <= max_fingers; ++fingers) {
    for (const double mu : {0.09, 0.18, 0.4}) {
      Hardware hardware;
      hardware.tube.mu = mu;
      const Friction f = exponents(hardware);
      const double expected = exp(-f.s - (2 * fingers - 1) * f.t);
      for (const Grasp& grasp : {Grasp{}, hold({fingers})}) {
        const auto found = solved_network(tendon_through_all(fingers), hardware, grasp);
        const double last = found["T" + std::to_string(2 * fingers)];
        EXPECT_NEAR(last, expected, 1e-9 * expected) << fingers << " fingers, mu_t " << mu;
      }
    }
  }
}

// ---- several tendons ----

TEST(Tension, TendonsTakeUpTheSameFractionOfTheirTravel) {
  // Scale of a tendon: take-up / Σ t_i L_i, with t_i its tensions at t = 1 on its motor side.
  Hardware hardware;
  hardware.strand_mm = 80;
  hardware.motor_side_mm = 250;
  const Friction f = exponents(hardware);
  const double one = 1 / (250 + 80 * (exp(-f.s) + exp(-f.s - f.t)));
  const double two =
      1 / (250 + 80 * (exp(-f.s) + exp(-f.s - f.t) + exp(-f.s - 2 * f.t) + exp(-f.s - 3 * f.t)));
  const auto found = solved_network("M-1-F+M-2-T-3-F", hardware, Grasp{});
  EXPECT_NEAR(found["a"], one / (one + two), 1e-12);
  EXPECT_NEAR(found["b"], two / (one + two), 1e-12);
  EXPECT_NEAR(found["T6"], two / (one + two) * exp(-f.s - 3 * f.t), 1e-12);
}

TEST(Tension, ATendonWithTwoMotorSidesTakesUpTwice) {
  Hardware hardware;
  hardware.tube.mu = hardware.sheath.mu = hardware.bearing.mu = 0;
  // Frictionless: 2 / (2 + 2) against 1 / (1 + 2) segments of the same length.
  const auto found = solved_network("M-1-M+M-2-F", hardware, Grasp{});
  EXPECT_NEAR(found["T1"] / found["T3"], 1.5, 1e-12);
  EXPECT_NEAR(found["a"] + found["b"] + found["c"], 1, 1e-12);
}

// ---- unequal spools ----

Hardware with_spools(std::vector<SpoolHardware> spools) {
  Hardware hardware;
  hardware.spools = std::move(spools);
  return hardware;
}

TEST(UnequalSpools, ShareTheMotorsForceByVirtualWork) {
  const double r = exp(-0.18 * 2 * pi);
  const auto solved = solved_network("1x-M+2x-M", with_spools({{"b", 0.5}}), Grasp{});
  EXPECT_DOUBLE_EQ(solved["a"], 0.8);  // a + b/2 = 1, and b takes up half of what a does
  EXPECT_DOUBLE_EQ(solved["b"], 0.4);
  EXPECT_DOUBLE_EQ(solved["T1"], 0.8 * r);
  EXPECT_DOUBLE_EQ(solved["T3"], 0.4 * r);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{1, 0.5}));
  EXPECT_DOUBLE_EQ(solved.state.motor_tension[0], 1);
  EXPECT_EQ(solved.state.motor_work, 1);
  EXPECT_DOUBLE_EQ(performance(solved.network, solved.state).efficiency, r);
}

TEST(UnequalSpools, OfBothEndsOfATendonCloseItsFingerByTheirMean) {
  const double s = exp(-0.18 * 2 * pi);
  const auto solved = solved_network("M-1b-M", with_spools({{"b", 0.5}}), Grasp{});
  const double b = exp(-0.001 * pi);
  EXPECT_EQ(solved.state.closing, std::vector<double>{0.75});
  EXPECT_EQ(solved.state.slip, (std::vector<double>{-1, -0.25, 0.5}));
  EXPECT_DOUBLE_EQ(solved["T2"], solved["T1"] * b);
  EXPECT_DOUBLE_EQ(solved["b"], solved["T2"] / s);
  EXPECT_DOUBLE_EQ(solved["a"] + 0.5 * solved["b"], 1);
}

// The motor pulls a jammed tendon through its spool.
TEST(UnequalSpools, TurnTheMotorsForceIntoMoreOfAJammedTendon) {
  const auto solved = solved_network("1x-M+2x-M", with_spools({{"b", 0.5}}), hold({2}));
  EXPECT_TRUE(solved.state.jams);
  EXPECT_EQ(solved["b"], 2);
  EXPECT_EQ(solved["a"], 0);
}

TEST(UnequalSpools, TieNoPulleyOfTheCarriage) {
  const Network network = expand(parse_routing("M-1-P-2-M"));
  const MechanicsBuilder builder(with_spools({{"a", 2}, {"b", 2}, {"d", 2}, {"e", 2}}));
  EXPECT_EQ(builder.unmatched_spools(network), (std::vector<std::string>{"b", "e"}));
  Mechanics mechanics;
  builder.apply(network, mechanics);
  EXPECT_EQ(std::accumulate(mechanics.spools.begin(), mechanics.spools.end(), 0.0),
            static_cast<double>(network.segments.size()) + 2);
}

// ---- locked ends ----

// Its motor side a stands still: the tendon is a fixed end there, which no motor pulls.
TEST(LockedEnds, AreFixedEndsWhoseTensionNoMotorGives) {
  const double s = exp(-0.18 * 2 * pi);
  const double t = exp(-0.18 * pi);
  Grasp grasp;
  grasp.locked = 1;
  const auto solved = solved_network("M-1-T-2-M", Hardware{}, grasp);
  const auto fixed = solved_network("F-1-T-2-M", Hardware{}, Grasp{});
  for (const char* strand : {"T1", "T2", "T3", "T4"}) {
    EXPECT_DOUBLE_EQ(solved[strand], fixed[strand]) << strand;
  }
  EXPECT_DOUBLE_EQ(solved["b"], 1);
  EXPECT_DOUBLE_EQ(solved["T1"], s * t * t * t);
  // Its sheath has no slip: at the far end of it the segment is as long as T1.
  EXPECT_EQ(solved.state.slip[0], 0);
  EXPECT_GT(solved["a"], 0);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{0.25, 0.25}));
  EXPECT_EQ(solved.state.motor_work, 1);
  EXPECT_LT(performance(solved.network, solved.state).efficiency, 1);
}

TEST(LockedEnds, LeaveATendonThatNothingElsePullsSlack) {
  Grasp grasp = hold({2});
  grasp.locked = 2;
  const auto solved = solved_network("1x-M+2x-M", Hardware{}, grasp);
  EXPECT_FALSE(solved.state.jams);
  EXPECT_EQ(solved["a"], 1);
  EXPECT_EQ(solved["b"], 0);
  EXPECT_EQ(solved["T3"], 0);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{1, 0}));
}

// ---- springs and slack between motor and tendon ----

Hardware with_tendons(std::vector<TendonHardware> own) {
  Hardware hardware;
  hardware.tendon = {2000, 40, std::move(own)};
  return hardware;
}

// Compliances Σ t_i L_i / EA + t_end / k of a tendon of two segments of 100 mm.
TEST(SpringsInSeries, ShareACarriageByTheComplianceOfTheTendons) {
  const double r = exp(-0.18 * 2 * pi);
  const double plain = (1 + r) * 100 / 2000;
  const double sprung = plain + 1 / 5.0;
  const auto closing = solved_network("1x-M+2x-M", with_tendons({{1, 5, {}}}), Grasp{});
  EXPECT_DOUBLE_EQ(closing["a"], plain / (plain + sprung));
  EXPECT_DOUBLE_EQ(closing["b"], sprung / (plain + sprung));
  EXPECT_DOUBLE_EQ(closing["T1"], closing["a"] * r);
  // Jammed, nothing slides at the sheaths at order one, and the motor sides stretch first.
  const auto jammed =
      solved_network("1x-M+2x-M", with_tendons({{1, 5, {}}, {2, 20, {}}}), hold({1, 2}));
  const double first = plain + 1 / 5.0;
  const double second = plain + 1 / 20.0;
  EXPECT_DOUBLE_EQ(jammed["a"], second / (first + second));
  EXPECT_DOUBLE_EQ(jammed["b"], first / (first + second));
}

TEST(SpringsInSeries, AreNoTendonToPayFor) {
  const Network network = expand(parse_routing("1x-M+2x-M"));
  const Mechanics sprung = mechanics(network, with_tendons({{1, 5, {}}}));
  EXPECT_EQ(sprung.length, (std::vector<double>{100, 500, 100, 100}));
  EXPECT_DOUBLE_EQ(tendon_length(sprung), 400);
}

TEST(Slack, DelaysATendonAndLeavesItLessOfTheCarriage) {
  // Behind 10 of 40 mm it has taken up three quarters of what the other has.
  const auto solved = solved_network("1x-M+2x-M", with_tendons({{2, {}, 10}}), Grasp{});
  EXPECT_DOUBLE_EQ(solved["a"], 4.0 / 7);
  EXPECT_DOUBLE_EQ(solved["b"], 3.0 / 7);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{1, 1}));
  // Both of its ends take slack in.
  const auto both = solved_network("1x-M+M-2-M", with_tendons({{2, {}, 10}}), Grasp{});
  const auto none = solved_network("1x-M+M-2-M", Hardware{}, Grasp{});
  EXPECT_DOUBLE_EQ(both["b"] / both["a"], 7.0 / 8 * none["b"] / none["a"]);
}

TEST(Slack, LeavesATendonWithoutTensionUntilItIsTakenIn) {
  for (const double slack_mm : {40.0, 50.0}) {
    const auto solved = solved_network("1x-M+2x-M", with_tendons({{2, {}, slack_mm}}), hold({2}));
    EXPECT_FALSE(solved.state.jams);
    EXPECT_EQ(solved["a"], 1);
    EXPECT_EQ(solved["b"], 0);
    EXPECT_EQ(solved.state.closing, (std::vector<double>{1, 0}));
    EXPECT_EQ(solved.state.slip, (std::vector<double>{solved.state.slip[0], 0}));
  }
  EXPECT_TRUE(solved_network("1x-M+2x-M", with_tendons({{2, {}, 39}}), hold({2})).state.jams);
}

TEST(SpringsInSeries, AreOfATendonWithOneEndAtAMotorAndSlackOfOneWithoutBlocks) {
  const auto unmatched = [](const std::string& word, const TendonHardware& own) {
    return MechanicsBuilder(with_tendons({own})).unmatched_tendons(expand(parse_routing(word)));
  };
  const std::vector<std::string> first{"1"};
  for (const char* word : {"M-1-F", "1x-M", "M-1-P-2-F", "M-Y1+1x-Y1-2x"}) {
    EXPECT_EQ(unmatched(word, {1, 5, {}}), std::vector<std::string>{}) << word;
  }
  for (const char* word : {"M-1-M", "1-P-2-P-1", "F-1-P-2-F", "1x-P-2x"}) {
    EXPECT_EQ(unmatched(word, {1, 5, {}}), first) << word;
    EXPECT_EQ(unmatched(word, {1, {}, 5}), std::vector<std::string>{}) << word;
  }
  EXPECT_EQ(unmatched("M-Y1+1x-Y1-2x", {1, {}, 5}), first);
  EXPECT_EQ(unmatched("M-1-F", {2, {}, 5}), std::vector<std::string>{"2"});
}

// ---- several motors ----

Grasp carriages(std::array<double, 2> travel, Grasp grasp = {}) {
  grasp.carriages.given = 2;
  std::copy(travel.begin(), travel.end(), grasp.carriages.over_D.begin());
  return grasp;
}

TEST(SeveralMotors, AreOneMotorIfTheirCarriagesTravelAlike) {
  const TensionState one = solved_network("M-1-P-2-M+3x-M", Hardware{}, hold({1})).state;
  const TensionState several = solved_network("M-1-P3-2-M2+3x-M", Hardware{}, hold({1})).state;
  EXPECT_EQ(several.tension, one.tension);
  EXPECT_EQ(several.slip, one.slip);
  EXPECT_EQ(several.motor_work, 1);
}

TEST(SeveralMotors, OfSeparateTendonsShareTheTensionByTheTravelOfTheirCarriages) {
  const double r = exp(-0.18 * 2 * pi);
  const auto solved = solved_network("1x-M+2x-M2", Hardware{}, carriages({1, 0.5}));
  EXPECT_DOUBLE_EQ(solved["a"], 2.0 / 3);
  EXPECT_DOUBLE_EQ(solved["b"], 1.0 / 3);
  EXPECT_DOUBLE_EQ(solved["T1"], 2 * r / 3);
  EXPECT_DOUBLE_EQ(solved["T3"], r / 3);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{1, 0.5}));
  EXPECT_DOUBLE_EQ(solved.state.motor_work, 2.0 / 3 + 0.5 / 3);
  EXPECT_DOUBLE_EQ(performance(solved.network, solved.state).efficiency, r);
}

TEST(SeveralMotors, ATendonWhoseCarriageStandsStillCarriesNothingAndDoesNotJam) {
  const auto solved = solved_network("1x-M+2x-M2", Hardware{}, carriages({1, 0}, hold({2})));
  EXPECT_FALSE(solved.state.jams);
  EXPECT_EQ(solved["a"], 1);
  EXPECT_EQ(solved["b"], 0);
  EXPECT_EQ(solved["T3"], 0);
  EXPECT_TRUE(solved_network("1x-M+2x-M2", Hardware{}, carriages({1, 1}, hold({2}))).state.jams);
}

TEST(SeveralMotors, ThatPullAgainstEachOtherTurnTheTendonThroughAllContacts) {
  const double s = exp(-0.18 * 2 * pi);
  const double b = exp(-0.001 * pi);
  for (const Grasp& grasp : {Grasp{}, hold({1})}) {
    const auto solved = solved_network("M-1b-M2", Hardware{}, carriages({1, -1}, grasp));
    EXPECT_FALSE(solved.state.jams);
    const double a = 1 / (1 + s * b * s);
    EXPECT_DOUBLE_EQ(solved["a"], a);
    EXPECT_DOUBLE_EQ(solved["T1"], a * s);
    EXPECT_DOUBLE_EQ(solved["T2"], a * s * b);
    EXPECT_DOUBLE_EQ(solved["b"], a * s * b * s);
    EXPECT_EQ(solved.state.closing, std::vector<double>{0});
    EXPECT_EQ(solved.state.slip, (std::vector<double>{-1, -1, -1}));
    EXPECT_DOUBLE_EQ(solved.state.motor_work, a - solved["b"]);
  }
}

TEST(SeveralMotors, ASecondCarriageThatStandsStillIsAFixedEndBehindItsSheath) {
  Hardware hardware;
  hardware.sheath.mu = 0.01;
  const auto solved = solved_network("M-1-M2", hardware, carriages({1, 0}));
  const auto fixed = solved_network("M-1-F", hardware, Grasp{});
  EXPECT_NEAR(solved["T2"] / solved["T1"], fixed["T2"] / fixed["T1"], 1e-15);
  EXPECT_EQ(solved.state.closing, std::vector<double>{0.5});
  EXPECT_EQ(solved.state.slip.back(), 0);
}

TEST(SeveralMotors, ThatWouldOpenAFingerAreRefused) {
  const auto said = [](const std::string& word) {
    return testing::out_of_range([&] { solved_network(word, Hardware{}, carriages({-1, 0.5})); });
  };
  const std::string since = "held none@-1,0.5: the motor tension cannot be computed: ";
  for (const std::string word : {"M-1-M2", "1x-M+2x-M2", "M-Y1+1x-Y1-2x+M2-3x"}) {
    EXPECT_EQ(said(word), since + "a finger would have to open") << word;
  }
}

TEST(TensionSolver, ReportsSlipAndClosing) {
  const TensionState state = solved_network("M-1-T-2-M", Hardware{}, hold({1})).state;
  EXPECT_EQ(state.slip, (std::vector<double>{-1, -1, -1, 0, 1}));
  EXPECT_EQ(state.closing, (std::vector<double>{0, 1}));
  EXPECT_FALSE(state.jams);
}

TEST(TensionSolver, ForgetsTheNetworkBefore) {
  TensionSolver solver;
  TensionState state;
  for (const std::string word : {"1-P-2-P-1+M-3-F", "M-1-F", "F-1-P-2-F"}) {
    const Network network = expand(parse_routing(word));
    const Mechanics m = mechanics(network, Hardware{});
    solver.solve(network, m, Grasp{}, Direction::pull, state);
    EXPECT_EQ(state.tension, tensions(network, m, Grasp{}).tension) << word;
    EXPECT_EQ(state.slip.size(), network.contacts.size());
    EXPECT_EQ(state.closing.size(), static_cast<std::size_t>(network.fingers));
  }
}

std::string refusal(const std::string& word, const Hardware& hardware = {}, Grasp grasp = {}) {
  return testing::out_of_range([&] { solved_network(word, hardware, grasp); });
}

std::string cannot_since(const std::string& reason) {
  return "held none: the motor tension cannot be computed: " + reason;
}

TEST(TensionSolver, NeedsAMotor) {
  for (const std::string word : {"F-1-F", "1-T-1", "F-1-F+M-2-F", "F-Y1+1x-Y1-2x"}) {
    EXPECT_EQ(refusal(word), cannot_since("a tendon hangs on no motor")) << word;
  }
}

TEST(TensionSolver, SaysThatNoTendonIsTaut) {
  Hardware hardware;
  hardware.tendon = {.travel_mm = 50, .own = {{.tendon = 1, .slack_mm = 50}}};
  EXPECT_EQ(refusal("1x-M", hardware),
            cannot_since("every tendon is still slack after the whole carriage travel"));
  EXPECT_NO_THROW(solved_network("1x-M+2x-M", hardware, Grasp{}));
  const Grasp still{.carriages = {2, {0, 1}}, .locked = 2};
  EXPECT_EQ(refusal("1x-M+2x-M2", {}, still),
            "held b@0,1: the motor tension cannot be computed: no end at a motor moves");
}

// Others may well have tensions.
TEST(TensionSolver, NamesTheGraspThatHasNoTensions) {
  const auto said = [](const std::string& word, Grasp grasp) {
    return testing::out_of_range([&] { solved_network(word, Hardware{}, grasp); });
  };
  const std::string word = "Y1-P-Y2+1x-Y1-T-Y2-2x";
  const std::string one = said(word, hold({1}));
  EXPECT_TRUE(one.starts_with("held 1: the motor tension cannot")) << one;
  EXPECT_TRUE(said(word, Grasp{}).starts_with("held none: ")) << said(word, Grasp{});
  EXPECT_NO_THROW(solved_network(word, Hardware{}, hold({1, 2})));
}

// Who only tries, asks; and a solver that met such a case solves the next as if it had not.
TEST(TensionSolver, SaysThatTensionsAreOutOfRange) {
  Hardware hardware;
  hardware.tube = {2, 5};
  const Network network = expand(parse_routing(tendon_through_all(max_fingers)));
  const Network plain = expand(parse_routing("M-1-F"));
  TensionSolver solver;
  TensionState state;
  solver.solve(network, mechanics(network, hardware), Grasp{}, Direction::pull, state);
  EXPECT_FALSE(state.in_range);
  EXPECT_TRUE(std::isnan(state.tension.front()));
  solver.solve(plain, mechanics(plain, Hardware{}), Grasp{}, Direction::pull, state);
  EXPECT_TRUE(state.in_range);
  EXPECT_EQ(state.tension, tensions(plain, mechanics(plain, Hardware{}), Grasp{}).tension);
}

TEST(TensionSolver, RefusesFrictionThatNoDoubleCanHold) {
  Hardware hardware;
  hardware.tube = {2, 5};
  const std::string word = tendon_through_all(max_fingers);
  EXPECT_EQ(refusal(word, hardware),
            cannot_since("friction is so strong that tensions fall out of range"));
}

}  // namespace
}  // namespace reeve
