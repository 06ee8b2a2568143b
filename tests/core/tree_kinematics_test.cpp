// Tendons of a tree that only pull: hand calculations, and all sets of taut tendons tried.
#include "core/tension/tree_kinematics.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "core/performance.hpp"
#include "core/tension/jamming.hpp"
#include "core/tension/seizure.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"

namespace reeve {
namespace {

constexpr double slack_rounding = 1e-12;

struct Solved : testing::SolvedNetwork {
  explicit Solved(const std::string& word, const std::string& grasp = "none",
                  const Hardware& hardware = {}, Direction direction = Direction::pull)
      : SolvedNetwork(testing::solved_network(word, hardware, grasp_of(word, grasp), direction)),
        efficiency(core::performance(network, state, direction).efficiency) {}

  static Grasp grasp_of(const std::string& word, const std::string& grasp) {
    const Network network = testing::network_of(word);
    return parse_grasp(grasp, network.fingers, carriage_count(network));
  }

  double efficiency;
};

// The faster tail moves the block by z = v, and both fingers close by z. The motor has the sheath's
// loss alone, e^(-0.36 pi) = 0.3227: half of it at each strand.
TEST(SlackTendons, OfTwoTailsTheFasterPullsAlone) {
  const double passed = std::exp(-0.36 * std::numbers::pi);
  for (const std::string word : {"M-Y1+1x-Y1-2x+M2-Y1", "M-W1+1x-W1-2x+M2-W1"}) {
    for (const std::string travels : {"1,0", "1,0.5", "1,-1"}) {
      const Solved s(word, "none@" + travels);
      EXPECT_FALSE(s.state.jams) << word << travels;
      EXPECT_NEAR(s["a"], 1, slack_rounding) << word << travels;
      EXPECT_NEAR(s["T1"], passed / 2, slack_rounding) << word << travels;
      EXPECT_NEAR(s["T3"], passed / 2, slack_rounding) << word << travels;
      EXPECT_EQ(s["b"], 0) << word << travels;
      EXPECT_EQ(s["h2"], 0) << word << travels;
      EXPECT_EQ(s.state.motor_tension[1], 0) << word << travels;
      EXPECT_NEAR(s.efficiency, passed, slack_rounding) << word << travels;
      EXPECT_NEAR(s.state.closing[0], 1, slack_rounding) << word << travels;
    }
    const Solved second(word, "none@1,2");
    EXPECT_EQ(second["a"], 0) << word;
    EXPECT_NEAR(second.efficiency, passed, slack_rounding) << word;
    EXPECT_NEAR(second.state.closing[1], 2, slack_rounding) << word;
  }
}

TEST(SlackTendons, OfTailsOnUnequalSpoolsAreThoseOfTheSmaller) {
  Hardware hardware;
  hardware.spools = {{"b", 0.5}};
  const Solved s("M-Y1+1x-Y1-2x+Y1-M", "none", hardware);
  EXPECT_EQ(s["b"], 0);
  EXPECT_NEAR(s["a"], 1, slack_rounding);
  EXPECT_NEAR(s.efficiency, std::exp(-0.36 * std::numbers::pi), slack_rounding);
}

// Whatever is slack could as well be missing.
TEST(SlackTendons, ChangeNothing) {
  struct Beside {
    std::string word;
    std::string without;
    std::string grasp = "none";
    std::string slack;
    std::string travels = "";
  };
  for (const Beside& beside :
       {// The block moves towards the end that is fixed there.
        Beside{.word = "M-Y1+1x-Y1-2x+Y1-F", .without = "M-Y1+1x-Y1-2x", .slack = "h2"},
        Beside{
            .word = "M-Y1+1x-Y1-2x+Y1-F", .without = "M-Y1+1x-Y1-2x", .grasp = "1", .slack = "h2"},
        // z1 = 1 and z2 = -1/2, so that the rope between the tails has 1/2 to spare; then nothing
        // holds the second block.
        Beside{.word = "M-Y1+1x-Y1-2x+M-Y2-F+Y2-Y1", .without = "M-Y1+1x-Y1-2x", .slack = "b"},
        // A bar's tail on finger 3, which stays open.
        Beside{.word = "1x-W1-2x+W1-M+W1-3x", .without = "1x-W1-2x+W1-M", .slack = "T5"},
        // 2 dl + z = 1 and 2 dl = 2 z: z = 1/3, which is more than the second motor takes in.
        Beside{.word = "M-1-Y1+2x-Y1-3x+M2-Y1",
        .without = "M-1-Y1+2x-Y1-3x",
        .slack = "b",
        .travels = "@1,0.3"},
        // The second motor lets out 3, of which two strands to the block need 2 z = 2.
        Beside{.word = "M-Y1+1x-Y1-2x+M2-Y1-3x",
        .without = "M-Y1+1x-Y1-2x",
        .slack = "T5",
        .travels = "@1,-3"},
        // Extensors that are let out, beside a tree of which one tail is slack.
        Beside{.word = "M-Y1+1x-Y1-2x+M2-1e+M2-2e+Y1-F",
        .without = "M-Y1+1x-Y1-2x+M2-1e+M2-2e",
        .slack = "h2",
        .travels = "@1,-1"}}) {
    SCOPED_TRACE(beside.word);
    const bool second_motor_stays = beside.without.find("M2") != std::string::npos;
    for (const Direction direction : {Direction::pull, Direction::release}) {
      const Solved s(beside.word, beside.grasp + beside.travels, {}, direction);
      const Solved alone(beside.without, beside.grasp + (second_motor_stays ? beside.travels : ""),
                         {}, direction);
      EXPECT_FALSE(s.state.jams);
      EXPECT_EQ(s[beside.slack], 0);
      for (std::size_t i = 0; i < alone.network.segments.size(); ++i) {
        EXPECT_NEAR(s.state.tension[i], alone.state.tension[i], slack_rounding) << i;
      }
      for (std::size_t f = 0; f < alone.state.closing.size(); ++f) {
        EXPECT_NEAR(s.state.closing[f], alone.state.closing[f], slack_rounding) << f;
      }
      EXPECT_NEAR(s.efficiency, alone.efficiency, slack_rounding);
    }
  }
}

// A strand's own finger takes what the common closing leaves too short: 2 dl + z = 1, 2 dl = 2 z
// and z = 0.6 give 0.2 and 0.6.
TEST(SlackTendons, AreNoneThatTheClosingsLeaveTooShort) {
  const Solved s("M-1-Y1+2x-Y1-3x+M2-Y1", "none@1,0.6");
  EXPECT_NEAR(s.state.closing[0], 0.2, slack_rounding);
  EXPECT_NEAR(s.state.closing[1], 0.6, slack_rounding);
  EXPECT_GT(s["a"], 0.1);
  EXPECT_GT(s["b"], 0.1);
}

TEST(SlackTendons, DoNotHideAJam) {
  // The motor pulls the block by 1/2 from an end that is fixed, or lets out only 0.1.
  EXPECT_TRUE(Solved("M-Y1-F+Y1-1x+Y1-F").state.jams);
  EXPECT_TRUE(Solved("M-Y1-F+Y1-1x+Y1-M2", "none@1,-0.1").state.jams);
  EXPECT_FALSE(Solved("M-Y1-F+Y1-1x+Y1-M2", "none@1,-0.6").state.jams);
  EXPECT_TRUE(Solved("M-Y1+1x-Y1-2x+M2-Y1", "1,2@1,0").state.jams);
}

TEST(SlackTendons, OfWholeTreesLeaveNothingToPull) {
  const std::string word = "M-Y1-3x+M2-Y1+1x-Y1-2x";  // z = -0.5 of at most -1 gives the motor all
  const Network network = testing::network_of(word);
  TensionState state;
  TensionSolver().solve(network, mechanics(network, Hardware{}),
                        Solved::grasp_of(word, "none@1,-1"), Direction::pull, state);
  EXPECT_FALSE(state.in_range);
  EXPECT_EQ(state.fault, TensionFault::slack_remains);
  EXPECT_FALSE(state.jams);
}

TEST(SlackTendons, AreNoReasonToCountAJam) {
  const Network network = testing::network_of("M-Y1+1x-Y1-2x+Y1-F");
  EXPECT_EQ(JamFinder().grasps(network, mechanics(network, Hardware{})), 0);
}

TEST(SlackTendons, BesideASeizedContactDoNotJam) {
  const Network network = testing::network_of("M-Y1+1x-Y1-2x+Y1-F");
  const SeizedNetwork seized = seize(network, {*find_contact(network, "T1-T3")});
  const TensionState state =
      restored(seized, tensions(seized.network, mechanics(seized.network, Hardware{}), {}));
  EXPECT_FALSE(state.jams);
  EXPECT_EQ(state.tension[*find_segment(network, parse_segment("h2"))], 0);
  EXPECT_NEAR(state.closing[0], 1, 1e-9);
}

// The least common closing is the greatest λ·m / λ·c of the tensions λ >= 0 that balance the
// blocks, each of as few tendons as can be: their work. Where such tensions do no work at the
// fingers (λ·c = 0), and the motors pull (λ·m > 0), the tree jams.
struct AllSets {
  double closing = 0;
  std::vector<bool> taut;
  bool jams = false;

  AllSets(const Network& network, const Mechanics& numbers, const Grasp& grasp) {
    const std::size_t n = network.tendons.size();
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(network.blocks.size()),
                                                   static_cast<Eigen::Index>(n));
    Eigen::VectorXd fingers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
    Eigen::VectorXd motors = fingers;
    for (Eigen::Index t = 0; t < motors.size(); ++t) {
      core::for_each_term(
          network, numbers, network.tendons[static_cast<std::size_t>(t)], grasp,
          [&](double length) { motors(t) += length; },
          [&](int, double factor) { fingers(t) += factor; },
          [&](std::size_t block, double factor) {
            blocks(static_cast<Eigen::Index>(block), t) += factor;
          });
    }
    for (unsigned set = 1; set < 1U << n; ++set) try_set(set, blocks, fingers, motors);
  }

 private:
  void try_set(unsigned set, const Eigen::MatrixXd& blocks, const Eigen::VectorXd& fingers,
               const Eigen::VectorXd& motors) {
    std::vector<Eigen::Index> members;
    for (Eigen::Index t = 0; t < motors.size(); ++t) {
      if ((set >> t & 1U) != 0) members.push_back(t);
    }
    const Eigen::MatrixXd balance = blocks(Eigen::all, members);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(balance);
    if (lu.dimensionOfKernel() != 1) return;
    Eigen::VectorXd pull = lu.kernel().col(0);
    if (pull.maxCoeff() <= 0) pull = -pull;
    if (pull.minCoeff() <= 1e-9) return;
    const double asked = pull.dot(motors(members));
    const double given = pull.dot(fingers(members));
    if (given < 1e-9) {
      jams |= asked > 1e-9;
    } else if (asked / given > closing) {
      closing = asked / given;
      taut.assign(static_cast<std::size_t>(motors.size()), false);
      for (const Eigen::Index t : members) taut[static_cast<std::size_t>(t)] = true;
    }
  }
};

// All fingers hang on one tendon, so that all of them close alike.
TEST(SlackTendons, AreThoseOfAllSetsTried) {
  std::mt19937 dice(1);
  std::uniform_real_distribution<double> travel(-1, 2);
  int jams = 0;
  int slack = 0;
  for (const std::string word :
       {"M-Y1+1x-Y1-2x+M2-Y1+M3-Y1", "M-W1+1x-W1/2:1-2x+M2-W1+W1-F+M3-Y1-F+Y1-W1",
        "M-Y1+M2-Y2-F+Y2-Y1+1x-Y1-2x+M3-Y1k", "M-Y1-F+Y1-Y2+M2-Y2+1x-Y2-2x+Y1-Y2k+M3-Y2",
        "M-Y1-M2+Y1-1x+Y1-M3", "M-Y1+Y2-Y1-M2+Y2-F+F-1-Y2-T-2-F+M3-Y2",
        "M-Y1+M2-Y1+Y2-Y1-F+M3-Y2+1x-Y2-2x+Y2-F"}) {
    const Network network = testing::network_of(word);
    const Mechanics numbers = mechanics(network, Hardware{});
    for (int trial = 0; trial < 200; ++trial) {
      Grasp grasp;
      grasp.carriages = {3, {1, travel(dice), travel(dice)}};
      if (trial % 4 == 0 && network.fingers == 2) grasp.held = 1;
      SCOPED_TRACE(word + " " + to_text(grasp));
      const AllSets expected(network, numbers, grasp);
      TensionState state;
      TensionSolver().solve(network, numbers, grasp, Direction::pull, state);
      EXPECT_EQ(state.jams, expected.jams);
      jams += expected.jams ? 1 : 0;
      if (expected.jams || expected.closing == 0) continue;
      ASSERT_TRUE(state.in_range);
      EXPECT_NEAR(state.closing.back(), expected.closing, 1e-9);
      for (std::size_t t = 0; t < network.tendons.size(); ++t) {
        const double tension = state.tension[network.tendons[t].first_segment];
        EXPECT_EQ(tension > 0, expected.taut[t]) << t;
        slack += expected.taut[t] ? 0 : 1;
      }
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(jams, 50);
  EXPECT_GT(slack, 500);
}

}  // namespace
}  // namespace reeve
