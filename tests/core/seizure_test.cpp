// Seized contacts by hand, and against routings in which the tendon ends where it is seized.
#include "core/tension/seizure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>

#include "core/notation.hpp"
#include "core/performance.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using std::numbers::pi;

const double sheath = std::exp(-0.36 * pi);
const double tube = std::exp(-0.18 * pi);
constexpr double tolerance = 1e-12;

struct Seized : testing::SolvedNetwork {
  double efficiency() const { return performance(network, state).efficiency; }
};

template <typename T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::size_t>& from) {
  std::vector<T> result;
  for (const std::size_t i : from) result.push_back(values[i]);
  return result;
}

TensionState seized_state(const Network& network, const Mechanics& plain,
                          const std::vector<std::size_t>& contacts, Grasp grasp,
                          Direction direction = Direction::pull) {
  const SeizedNetwork seized = seize(network, contacts);
  Mechanics m = plain;
  m.length = reordered(plain.length, seized.segment_from);
  m.phi = reordered(plain.phi, seized.contact_from);
  m.decay = reordered(plain.decay, seized.contact_from);
  return restored(seized, tensions(seized.network, m, grasp, direction));
}

Seized seized(const std::string& word, const std::vector<std::string>& contacts, Grasp grasp = {},
              Direction direction = Direction::pull) {
  Seized result;
  result.network = testing::network_of(word);
  std::vector<std::size_t> indices;
  for (const std::string& contact : contacts) {
    indices.push_back(find_contact(result.network, contact).value());
  }
  result.state =
      seized_state(result.network, mechanics(result.network, {}), indices, grasp, direction);
  return result;
}

TEST(SeizedTr1, InItsSheathBlocksTheCarriage) {
  const Seized s = seized("M-1-T-2-F", {"a-T1"});
  EXPECT_TRUE(s.state.jams);
  EXPECT_EQ(s["a"], 1);
  for (const char* strand : {"T1", "T2", "T3", "T4"}) EXPECT_EQ(s[strand], 0);
  EXPECT_EQ(s.efficiency(), 0);
}

// What the carriage hangs on it still hangs on while it is let go.
TEST(SeizedEndSheath, BlocksTheReleasedCarriageToo) {
  for (const auto& [word, contact, end] :
       {std::tuple("M-1-T-2-F", "a-T1", "a"), std::tuple("M-1-P-2-M", "a-T1", "a"),
        std::tuple("M-1-P-2-M", "T4-d", "d")}) {
    const Seized s = seized(word, {contact}, {}, Direction::release);
    EXPECT_TRUE(s.state.jams) << word;
    EXPECT_EQ(s[end], 1) << word;
    for (const char* strand : {"T1", "T2", "T3", "T4"}) EXPECT_EQ(s[strand], 0) << word;
  }
}

// The motor closes finger 1 by its one strand, and so twice as far; the rest goes slack.
TEST(SeizedTr1, InTheFirstTipPullsOneStrandAlone) {
  for (const Grasp& grasp : {Grasp{}, hold({2})}) {
    const Seized s = seized("M-1-T-2-F", {"T1-T2"}, grasp);
    EXPECT_FALSE(s.state.jams);
    EXPECT_NEAR(s["T1"], sheath, tolerance);
    for (const char* strand : {"T2", "T3", "T4"}) EXPECT_EQ(s[strand], 0);
    EXPECT_NEAR(s.state.closing[0], 1, tolerance);
    EXPECT_EQ(s.state.closing[1], 0);
    EXPECT_NEAR(s.efficiency(), sheath, tolerance);
  }
  EXPECT_TRUE(seized("M-1-T-2-F", {"T1-T2"}, hold({1})).state.jams);
}

TEST(SeizedTr1, InTheJoinIsFingerOneAlone) {
  const Seized s = seized("M-1-T-2-F", {"T2-T3"});
  EXPECT_NEAR(s["T1"], sheath, tolerance);
  EXPECT_NEAR(s["T2"], sheath * tube, tolerance);
  EXPECT_EQ(s["T3"], 0);
  EXPECT_NEAR(s.state.closing[0], 0.5, tolerance);
  EXPECT_NEAR(s.efficiency(), sheath * (1 + tube) / 2, tolerance);
}

// 2 dl1 + dl2 = 1, the strands of finger 2 by only one of them: dl_f in proportion to the strands
// on the tendon, 2 : 1, so dl1 = 0.4 and dl2 = 0.2.
TEST(SeizedTr1, InTheLastTipClosesFingersInProportionToTheirStrands) {
  const Seized s = seized("M-1-T-2-F", {"T3-T4"});
  EXPECT_NEAR(s["T3"], sheath * tube * tube, tolerance);
  EXPECT_EQ(s["T4"], 0);
  EXPECT_NEAR(s.state.closing[0], 0.4, 1e-9);
  EXPECT_NEAR(s.state.closing[1], 0.2, 1e-9);
  EXPECT_NEAR(s.slip("T2-T3"), -0.2, 1e-9);
  const Seized held = seized("M-1-T-2-F", {"T3-T4"}, hold({1}));
  EXPECT_NEAR(held["T3"], sheath * tube * tube, tolerance);
  EXPECT_NEAR(held.state.closing[1], 1, 1e-9);
}

// Both pieces must be served: dl1 >= 1 and dl1 + 2 dl2 >= 3. Then every sheath draws 1.
TEST(SeizedTr5, InATipWithBothClosingPullsAllStrandsAlike) {
  const Seized s = seized("M-1-P-2-M", {"T1-T2"});
  for (const char* strand : {"T1", "T2", "T3", "T4"}) EXPECT_NEAR(s[strand], sheath / 4, 1e-9);
  EXPECT_NEAR(s.state.closing[0], 1, 1e-9);
  EXPECT_NEAR(s.state.closing[1], 1, 1e-9);
  EXPECT_NEAR(s.efficiency(), sheath, 1e-9);
}

// Finger 1 alone has to give the three that the longer piece needs: dl1 = 3, and the other piece,
// which needs 1, goes slack. T2 - b - c - T3 - T4 - d all slide towards finger 1.
TEST(SeizedTr5, InATipWithTheOtherFingerHeldLeavesAPieceSlack) {
  const Seized s = seized("M-1-P-2-M", {"T1-T2"}, hold({2}));
  EXPECT_EQ(s["a"], 0);
  EXPECT_EQ(s["T1"], 0);
  const double pulley = std::exp(-0.001 * pi);
  const double T4 = sheath;  // in units of d
  const double T3 = T4 * tube;
  const double c = T3 * sheath;
  const double b = c * pulley;
  const double motor = b + c + 1;
  EXPECT_NEAR(s["T4"], T4 / motor, 1e-9);
  EXPECT_NEAR(s["T3"], T3 / motor, 1e-9);
  EXPECT_NEAR(s["b"], b / motor, 1e-9);
  EXPECT_NEAR(s["T2"], b * sheath / motor, 1e-9);
  EXPECT_NEAR(s.state.closing[0], 3, 1e-9);
  EXPECT_NEAR(s.efficiency(), 3 * b * sheath / motor, 1e-9);
}

// TR7, a loop, opened at the first tip: every other contact may still slide, and with both fingers
// closing none has to: as before.
TEST(SeizedTr7, InATipWithBothClosingIsAsBefore) {
  const Seized s = seized("1-P-2-P-1", {"T1-T2"});
  for (const char* strand : {"T1", "T2", "T3", "T4"}) EXPECT_NEAR(s[strand], sheath / 4, 1e-9);
  EXPECT_NEAR(s.efficiency(), sheath, 1e-9);
}

// With finger 2 held, finger 1's strands give 2 each, and the tendon slides from the middle, which
// rests, to both ends of the open walk. The held strands carry the least that friction allows.
TEST(SeizedTr7, InATipWithTheOtherFingerHeldSlidesToBothSides) {
  const Seized s = seized("1-P-2-P-1", {"T1-T2"}, hold({2}));
  const double pulley = std::exp(-0.001 * pi);
  const double inner = 1 / (2 * (1 + pulley));  // of each pair of motor-side segments
  for (const char* strand : {"T1", "T2"}) EXPECT_NEAR(s[strand], inner * pulley * sheath, 1e-9);
  for (const char* strand : {"T3", "T4"}) EXPECT_NEAR(s[strand], inner * sheath, 1e-9);
  EXPECT_EQ(s.slip("T3-T4"), 0);
  EXPECT_NEAR(s.state.closing[0], 2, 1e-9);
}

// TR6 opened at the join of the fingers is F-1-P-2-F written from its middle: TR3.
TEST(SeizedTr6, InTheJoinIsTr3) {
  for (const Grasp& grasp : {Grasp{}, hold({1}), hold({2})}) {
    const Seized s = seized("1-T-2-P-1", {"T2-T3"}, grasp);
    const Network tr3 = expand(parse_routing("F-1-P-2-F"));
    const TensionState expected = tensions(tr3, mechanics(tr3, {}), grasp);
    // In TR3 the strands of finger 1 are walked from the fixed end: T1, T2; here T2, T1.
    EXPECT_NEAR(s["T2"], expected.tension[0], 1e-9);
    EXPECT_NEAR(s["T1"], expected.tension[1], 1e-9);
    EXPECT_NEAR(s["T4"], expected.tension[4], 1e-9);
    EXPECT_NEAR(s["T3"], expected.tension[5], 1e-9);
  }
}

// ---- a contact between two segments at the hand: both pieces are routings with an end F ----

struct Cut {
  Routing routing;          // with the join at the seized contact replaced by two ends F
  std::size_t contact = 0;  // of the whole routing
};

// Of an open tendon: at its `join`, the number of a T or B in its walk, between two fingers.
Cut cut(const Routing& whole, std::size_t tendon, std::size_t join) {
  Cut result{whole, 0};
  const Tendon& walk = whole.tendons[tendon];
  Tendon head;
  Tendon tail;
  head.walk.assign(walk.walk.begin(), walk.walk.begin() + static_cast<std::ptrdiff_t>(join));
  head.walk.push_back(fixed_end());
  tail.walk.push_back(fixed_end());
  tail.walk.insert(tail.walk.end(), walk.walk.begin() + static_cast<std::ptrdiff_t>(join) + 1,
                   walk.walk.end());
  result.routing.tendons[tendon] = head;
  result.routing.tendons.insert(
      result.routing.tendons.begin() + static_cast<std::ptrdiff_t>(tendon) + 1, tail);
  const Network network = expand(whole);
  const Token& before = walk.walk[join - 1];
  const Token& behind = walk.walk[join + 1];
  const std::string at =
      "T" + std::to_string(2 * before.finger) + "-T" + std::to_string(2 * behind.finger - 1);
  result.contact = find_contact(network, at).value();
  return result;
}

bool is_finger(const Token& token) { return token.kind == TokenKind::finger; }
bool is_hand_join(const Token& token) { return is_join(token.kind) && !is_on_carriage(token.kind); }

// The first join of an open tendon at the hand, between two fingers, that leaves a motor on both
// sides; {} if there is none.
std::optional<Cut> first_cut(const Routing& routing) {
  for (std::size_t t = 0; t < routing.tendons.size(); ++t) {
    const Walk& walk = routing.tendons[t].walk;
    if (routing.tendons[t].closed) continue;
    for (std::size_t j = 1; j + 1 < walk.size(); ++j) {
      if (!is_hand_join(walk[j]) || !is_finger(walk[j - 1]) || !is_finger(walk[j + 1])) continue;
      Cut result = cut(routing, t, j);
      if (is_actuated(result.routing)) return result;
    }
  }
  return std::nullopt;
}

TEST(SeizedContact, BetweenSegmentsAtTheHandLeavesTwoRoutingsOfTheirOwn) {
  int compared = 0;
  int jammed = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    testing::Trial trial = testing::random_trial(seed);
    const std::optional<Cut> pieces = first_cut(trial.routing);
    if (!pieces) continue;
    SCOPED_TRACE(testing::to_text(trial));
    trial.hardware.contacts.clear();  // the seized contact is in one network alone
    const TensionState whole = seized_state(trial.network, mechanics(trial.network, trial.hardware),
                                            {pieces->contact}, trial.grasp, trial.direction);
    const Network network = expand(pieces->routing);
    const TensionState apart =
        tensions(network, mechanics(network, trial.hardware), trial.grasp, trial.direction);
    EXPECT_EQ(whole.jams, apart.jams);
    ASSERT_EQ(whole.tension.size(), apart.tension.size());
    for (std::size_t i = 0; i < apart.tension.size(); ++i) {
      EXPECT_NEAR(whole.tension[i], apart.tension[i], 1e-8 * apart.tension[i] + 1e-14) << i;
    }
    for (std::size_t f = 0; f < apart.closing.size(); ++f) {
      EXPECT_NEAR(whole.closing[f], apart.closing[f], 1e-8);
    }
    if (::testing::Test::HasFailure()) return;
    ++compared;
    jammed += apart.jams;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(jammed, 10);
}

}  // namespace
}  // namespace reeve
