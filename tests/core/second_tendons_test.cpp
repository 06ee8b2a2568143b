// Second flexors and extensors: closed forms by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/performance.hpp"
#include "core/tension/jamming.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::network_of;
using testing::solved_network;

const double sheath_ratio = std::exp(-0.18 * 2 * std::numbers::pi);
const double pulley_ratio = std::exp(-0.001 * std::numbers::pi);

Grasp travels(std::array<double, 2> of_motors, std::vector<int> held = {}) {
  Grasp grasp = hold(held);
  grasp.carriages.given = 2;
  std::copy(of_motors.begin(), of_motors.end(), grasp.carriages.over_D.begin());
  return grasp;
}

TEST(SecondTendons, FlexorsOfEqualTravelShareTheTension) {
  const auto solved = solved_network("M-1x+M2-1x", Hardware{});
  for (const char* side : {"a", "b"}) EXPECT_DOUBLE_EQ(solved[side], 0.5);
  for (const char* strand : {"T1", "T2"}) EXPECT_DOUBLE_EQ(solved[strand], sheath_ratio / 2);
  EXPECT_EQ(solved.state.closing, std::vector<double>{1});
  const Performance found = performance(solved.network, solved.state);
  EXPECT_DOUBLE_EQ(found.efficiency, sheath_ratio);
  EXPECT_DOUBLE_EQ(pulls_by_finger(solved.network, solved.state)[1], sheath_ratio);
}

TEST(SecondTendons, TheSlowerFlexorOfAFingerIsSlack) {
  const auto solved = solved_network("M-1x+M2-1x", Hardware{}, travels({1, 2}));
  EXPECT_EQ(solved["a"], 0);
  EXPECT_EQ(solved["T1"], 0);
  EXPECT_EQ(solved["b"], 1);
  EXPECT_DOUBLE_EQ(solved["T2"], sheath_ratio);
  EXPECT_EQ(solved.state.closing, std::vector<double>{2});
  EXPECT_DOUBLE_EQ(performance(solved.network, solved.state).efficiency, sheath_ratio);
}

// M2 closes finger 1 by 1.5, so that the tendon over the pulley closes finger 2 by 0.5.
TEST(SecondTendons, ATendonClosesItsOtherFingersByWhatItHasLeft) {
  Hardware hardware;
  hardware.strand_mm = 100;
  hardware.motor_side_mm = 300;
  const auto solved = solved_network("1x-P-2x+M2-1x", hardware, travels({1, 1.5}));
  const double over_pulley =
      2 / (100 * sheath_ratio * (1 + pulley_ratio) + 300 * (1 + pulley_ratio));
  const double alone = 1.5 / (100 * sheath_ratio + 300);
  const double motors = over_pulley * (1 + pulley_ratio) + alone;
  EXPECT_NEAR(solved.state.closing[0], 1.5, 1e-13);
  EXPECT_NEAR(solved.state.closing[1], 0.5, 1e-13);
  EXPECT_NEAR(solved["a"], over_pulley * pulley_ratio / motors, 1e-13);
  EXPECT_NEAR(solved["b"], over_pulley / motors, 1e-13);
  EXPECT_NEAR(solved["T1"], over_pulley * pulley_ratio * sheath_ratio / motors, 1e-13);
  EXPECT_NEAR(solved["T3"], over_pulley * sheath_ratio / motors, 1e-13);
  EXPECT_NEAR(solved["T2"], alone * sheath_ratio / motors, 1e-13);
}

TEST(SecondTendons, ExtensorsFollowWithoutTensionWhileTheirMotorLetsOut) {
  for (const auto& held : {std::vector<int>{}, std::vector<int>{1}}) {
    const auto alone = solved_network("1x-P-2x", Hardware{}, hold(held));
    const auto solved = solved_network("1x-P-2x+M2-1e+M2-2e", Hardware{},
                                       travels({1, held.empty() ? -1.0 : -2.0}, held));
    EXPECT_FALSE(solved.state.jams);
    for (const char* name : {"a", "b", "T1", "T3"}) EXPECT_DOUBLE_EQ(solved[name], alone[name]);
    for (const char* name : {"c", "d", "T2", "T4"}) EXPECT_EQ(solved[name], 0);
    EXPECT_EQ(solved.state.closing, alone.state.closing);
    EXPECT_EQ(performance(solved.network, solved.state).efficiency,
              performance(alone.network, alone.state).efficiency);
  }
}

TEST(SecondTendons, ExtensorsOpenTheFingersWhileTheFlexorsAreLetOut) {
  const auto solved = solved_network("1x-P-2x+M2-1e+M2-2e", Hardware{}, travels({-1, 1}));
  for (const char* name : {"a", "b", "T1", "T3"}) EXPECT_EQ(solved[name], 0);
  for (const char* name : {"c", "d"}) EXPECT_DOUBLE_EQ(solved[name], 0.5);
  for (const char* name : {"T2", "T4"}) EXPECT_DOUBLE_EQ(solved[name], sheath_ratio / 2);
  EXPECT_EQ(solved.state.closing, (std::vector<double>{-1, -1}));
  const FingerArray pulls = pulls_by_finger(solved.network, solved.state);
  EXPECT_DOUBLE_EQ(pulls[1], -sheath_ratio / 2);
  const Performance found = performance(solved.network, solved.state);
  EXPECT_DOUBLE_EQ(found.efficiency, sheath_ratio);
  EXPECT_EQ(found.finger_uniformity, 1);
  EXPECT_EQ(found.uniformity, 1);
}

// 1 is pulled by its flexor alone, 2 by neither.
TEST(SecondTendons, CountAsSlackInTheUniformityUnlessTheAntagonistPulls) {
  const auto solved = solved_network("M-1x+M2-1e+M2-2x", Hardware{}, travels({1, -1}));
  EXPECT_EQ(solved["T2"], 0);
  EXPECT_EQ(performance(solved.network, solved.state).uniformity, 0);
  const auto closing = solved_network("M-1x+M2-1e", Hardware{}, travels({1, -1}));
  EXPECT_EQ(performance(closing.network, closing.state).uniformity, 1);
  const auto flexors = solved_network("M-1x+M2-1x", Hardware{}, travels({1, 0}));
  EXPECT_EQ(performance(flexors.network, flexors.state).uniformity, 0);
}

TEST(SecondTendons, OpposeEachOtherIfTheirFingerCanMoveNeitherWay) {
  const auto opposed = [](const std::string& word, const Grasp& grasp) {
    const TensionState state = solved_network(word, Hardware{}, grasp).state;
    EXPECT_EQ(state.jams, state.opposed > 0);
    return state.opposed;
  };
  EXPECT_EQ(opposed("M-1x+M-1e", Grasp{}), 1);
  EXPECT_EQ(opposed("M-1x+M2-1e", travels({1, 1})), 1);
  EXPECT_EQ(opposed("M-1x+M2-1e", travels({1, -0.5})), 1);
  EXPECT_EQ(opposed("M-1x+M2-1e", travels({1, 0})), 1);
  EXPECT_EQ(opposed("M-1x+M2-1e", travels({1, -1})), 0);
  EXPECT_EQ(opposed("1x-P-2x+M2-1e+M2-2e", travels({1, -1}, {1})), 2);
  const auto jammed = solved_network("M-1x+M2-1e", Hardware{}, travels({1, -0.5}));
  EXPECT_EQ(jammed["a"], 1);
  EXPECT_EQ(jammed.state.closing, std::vector<double>{0});
  EXPECT_EQ(performance(jammed.network, jammed.state).efficiency, 0);
}

TEST(SecondTendons, AHeldFingerJamsItsFlexorsAsOneDoes) {
  const TensionState state = solved_network("M-1x+M2-1x", Hardware{}, hold({1})).state;
  EXPECT_TRUE(state.jams);
  EXPECT_EQ(state.opposed, 0);
}

TEST(SecondTendons, LeaveATreeThatTheyFollowAsItIs) {
  const std::string tree = "M-Y1+1x-Y1-Y2+2x-Y2-3x";
  const auto alone = solved_network(tree, Hardware{});
  const auto solved = solved_network(tree + "+M2-1e", Hardware{}, travels({1, -9}));
  for (const char* name : {"a", "h1", "h2", "T1", "T3", "T5"}) {
    EXPECT_EQ(solved[name], alone[name]) << name;
  }
  EXPECT_EQ(solved.state.closing, alone.state.closing);
  EXPECT_EQ(solved.state.block_travel, alone.state.block_travel);
}

// One motor winds the flexor up and the extensor, on its spool the other way round, off.
TEST(SecondTendons, OnASpoolWoundTheOtherWayAreLetOut) {
  Hardware hardware;
  hardware.spools = {{"b", -1}};
  const auto solved = solved_network("M-1x+M-1e", hardware);
  EXPECT_EQ(solved["a"], 1);
  EXPECT_EQ(solved["b"], 0);
  EXPECT_DOUBLE_EQ(solved["T1"], sheath_ratio);
  EXPECT_EQ(solved.state.closing, std::vector<double>{1});
  EXPECT_DOUBLE_EQ(performance(solved.network, solved.state).efficiency, sheath_ratio);
}

// A differential spool: the finger closes by half of what the end at r = 1 takes in beyond what the
// other lets out, and the motor has T_a − T_b / 2.
TEST(SpoolsWoundTheOtherWay, PullWithTheDifferenceOfBothEnds) {
  Hardware hardware;
  hardware.spools = {{"b", -0.5}};
  hardware.tube.mu = hardware.sheath.mu = 0;
  const auto solved = solved_network("M-1-M", hardware);
  for (const char* name : {"a", "T1", "T2", "b"}) EXPECT_DOUBLE_EQ(solved[name], 2);
  EXPECT_EQ(solved.state.closing, std::vector<double>{0.25});
}

TEST(SpoolsWoundTheOtherWay, AreOutOfRangeWhereTheyWouldPullTheMotor) {
  Hardware hardware;
  hardware.spools = {{"b", -0.5}};
  EXPECT_NE(testing::out_of_range([&] {
              const Network network = network_of("M-1-M");
              tensions(network, mechanics(network, hardware), {}, Direction::release);
            }).find("the ends that move against the others pull the motor"),
            std::string::npos);
}

TEST(SecondTendons, BesideSlackAreRefused) {
  Hardware hardware;
  hardware.tendon.EA_N = 1000;
  hardware.tendon.travel_mm = 10;
  hardware.tendon.own.push_back({1, {}, 5});
  const std::string said = testing::out_of_range([&] { solved_network("M-1x+M2-1x", hardware); });
  EXPECT_NE(said.find("beside a second tendon on a finger, seized contacts and slack"),
            std::string::npos)
      << said;
}

TEST(SecondTendons, HaveTheStrandsOfTheirFinger) {
  const auto strands = [](const std::string& word) {
    std::string names;
    for (const Segment& segment : network_of(word).segments) {
      if (segment.kind == SegmentKind::strand) names += segment_name(segment) + " ";
    }
    return names;
  };
  EXPECT_EQ(strands("M-1x+M2-1x"), "T1 T2 ");
  EXPECT_EQ(strands("M2-1e+M-1x"), "T2 T1 ");
  EXPECT_EQ(strands("M-1e"), "T2 ");
  EXPECT_EQ(strands("1x-P-1x"), "T1 T2 ");
  EXPECT_EQ(finger_count(parse_routing("1x-P-2x+M2-1e+M2-2e")), 2);
  EXPECT_EQ(parts(network_of("1x-P-2x+M2-1e+M2-2e")).anchors, 4);
  EXPECT_EQ(parts(network_of("1x-P-2x+M2-1e+M2-2e")).fixed_ends, 0);
}

TEST(SecondTendons, HaveOneCanonicalWord) {
  const auto same = [](const std::string& word, const std::string& canonical_word) {
    for (const std::string& each : {word, canonical_word}) {
      EXPECT_EQ(to_word(parse_routing(each)), each);
      EXPECT_EQ(to_word(canonical(parse_routing(each), FingerIdentity::identical)), canonical_word);
    }
  };
  same("M2-1x+M-1x", "M-1x+M2-1x");
  same("2e-M2+M2-1e+2x-P-1x", "1x-P-2x+M2-1e+M2-2e");
  same("M-1e+M2-1x", "M-1x+M2-1e");
  same("M-Y1+1x-Y1-2x+M2-2e", "M-Y1+1x-Y1-2x+M2-1e");
  same("1x-P-2x+3x-P-4x+M2-4e", "1x-P-2x+3x-P-4x+M2-1e");
  same("1x-P-4x+3x-P-2x+1e-P2-3e+4e-P2-2e", "1x-P-2x+3x-P-4x+1e-P2-3e+2e-P2-4e");
  EXPECT_NE(canonical(parse_routing("1x-P-2x+M2-1x"), FingerIdentity::identical),
            canonical(parse_routing("1x-P-2x+M2-1e"), FingerIdentity::identical));
  const auto distinct = [](const std::string& word) {
    return to_word(canonical(parse_routing(word), FingerIdentity::distinct));
  };
  EXPECT_EQ(distinct("M2-2e+2x-P-1x"), "1x-P-2x+M2-2e");
}

TEST(SecondTendons, CountTheirJamsWithAllCarriagesAlike) {
  const auto jams = [](const std::string& word) {
    const Network network = network_of(word);
    return JamFinder().grasps(network, mechanics(network, Hardware{}));
  };
  EXPECT_EQ(jams("1x-P-2x+M2-1x"), 1);  // finger 1 held stops M2
  EXPECT_EQ(jams("1x-P-2x+M2-1e"), 2);  // either finger held
}

}  // namespace
}  // namespace reeve
