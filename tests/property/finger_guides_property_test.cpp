// Guides at the joints of fingers, in routings of one or several motors, with blocks and
// springs: the library puts the guides of a finger into the contact at its tip; here the
// independent solver has a contact for each of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/finger_guides.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_words.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::ReferenceHardware;
using testing::ReferenceResult;

// Exponents of the guides of a finger, from the palm to the tip.
using Guides = std::map<int, std::vector<double>>;

double sum_of(const std::vector<double>& exponents, std::size_t count) {
  double sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += exponents[j];
  return sum;
}

// A tube for each guide that a strand passes. What leads into the first finger of a loop stands at
// the end of its walk.
Routing with_tubes(const Routing& routing, const Guides& guides) {
  Routing result;
  for (const Tendon& tendon : routing.tendons) {
    Tendon led{{}, tendon.closed};
    std::size_t before_first = 0;
    for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
      const Token& token = tendon.walk[i];
      const auto own = guides.find(token.finger);
      const std::size_t tubes =
          is_of_finger(token.kind) && own != guides.end() ? own->second.size() : 0;
      const bool anchors = token.kind == TokenKind::anchored_tip;
      const bool begins_loop = tendon.closed && i == 0;
      if (begins_loop) before_first = tubes;
      const std::size_t before = begins_loop || (anchors && i == 0) ? 0 : tubes;
      const std::size_t after = anchors && i > 0 ? 0 : tubes;
      led.walk.insert(led.walk.end(), before, plain(TokenKind::tube_join));
      led.walk.push_back(token);
      led.walk.insert(led.walk.end(), after, plain(TokenKind::tube_join));
    }
    led.walk.insert(led.walk.end(), before_first, plain(TokenKind::tube_join));
    result.tendons.push_back(led);
  }
  return result;
}

// One strand of a finger past its guides: the segment at the palm, and that behind each guide.
struct GuidedStrand {
  std::size_t palm = 0;
  std::vector<std::size_t> behind;
};

// The network with tubes, and where what the plain one has stands in it.
struct GuidedNetwork {
  Network network;
  std::map<int, std::vector<GuidedStrand>> strands;  // of each finger: left, right
  std::map<std::size_t, double> guide_phi;           // by contact
  std::set<std::size_t> inner;                       // stretches between guides
  std::vector<std::size_t> place;                    // of the plain network's segments
};

class GuideReader {
 public:
  GuideReader(const Network& plain, const Routing& routing, const Guides& guides)
      : guides_(guides) {
    result_.network = expand(with_tubes(routing, guides));
    for (const TendonSpan& tendon : result_.network.tendons) {
      for (std::size_t i = 0; i < tendon.segments; ++i) read_strand(tendon, i);
    }
    find_places(plain);
  }

  GuidedNetwork result() && { return std::move(result_); }

 private:
  // From the fingertip outward: against the walk for T(2f-1), along it for T(2f). An anchored tip
  // is at either end of its tendon.
  void read_strand(const TendonSpan& tendon, std::size_t i) {
    const Segment& strand = result_.network.segments[tendon.first_segment + i];
    const auto own = guides_.find(strand.finger);
    if (strand.kind != SegmentKind::strand || own == guides_.end()) return;
    const bool against = strand.number % 2 == 1 && (i > 0 || tendon.closed);
    const std::size_t n = own->second.size();
    GuidedStrand read;
    read.behind.resize(n);
    std::size_t at = i;
    for (std::size_t j = n; j-- > 0;) {
      read.behind[j] = tendon.first_segment + at;
      result_.inner.insert(read.behind[j]);
      const std::size_t contact = against ? (at + tendon.segments - 1) % tendon.segments : at;
      result_.guide_phi[tendon.first_contact + contact] = own->second[j];
      at = against ? contact : (at + 1) % tendon.segments;
    }
    read.palm = tendon.first_segment + at;
    result_.strands[strand.finger].push_back(read);
  }

  void find_places(const Network& plain) {
    std::set<std::size_t> added = result_.inner;
    for (const auto& [finger, strands] : result_.strands) {
      for (const GuidedStrand& strand : strands) added.insert(strand.palm);
    }
    std::vector<std::size_t> hands;
    for (std::size_t i = 0; i < result_.network.segments.size(); ++i) {
      const bool is_hand = result_.network.segments[i].kind == SegmentKind::hand;
      if (is_hand && !added.contains(i)) hands.push_back(i);
    }
    std::size_t next = 0;
    for (const Segment& segment : plain.segments) {
      const auto guided = result_.strands.find(segment.finger);
      if (segment.kind == SegmentKind::strand && guided != result_.strands.end()) {
        result_.place.push_back(palm_of(segment, guided->second));
      } else if (segment.kind == SegmentKind::hand) {
        result_.place.push_back(hands.at(next++));
      } else {
        result_.place.push_back(find_segment(result_.network, segment).value());
      }
    }
  }

  std::size_t palm_of(const Segment& strand, const std::vector<GuidedStrand>& strands) const {
    for (const GuidedStrand& each : strands) {
      const Segment& tip = result_.network.segments[each.behind.back()];
      if (tip.number == strand.number) return each.palm;
    }
    return strands.front().palm;
  }

  const Guides& guides_;
  GuidedNetwork result_;
};

struct GuidedTrial {
  Routing routing;
  Grasp grasp;
  Direction direction;
  ReferenceHardware laws;
  TendonParts tendon{};
  std::map<std::string, double> springs_mm{};
  Guides guides;
};

void add_springs(Dice& dice, const Network& network, GuidedTrial& trial) {
  constexpr double EA_N = 3000;
  trial.tendon = {EA_N, 50, {}};
  trial.laws.length_override = nullptr;  // it would not know of the springs
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    std::vector<std::string> ends;
    for (std::size_t i = 0; i < network.tendons[t].segments; ++i) {
      const Segment& segment = network.segments[network.tendons[t].first_segment + i];
      if (find_motor_end(network, segment)) ends.push_back(segment_name(segment));
    }
    if (ends.size() != 1 || dice.chance(0.4)) continue;
    const double stiffness = dice.log_real(0.5, 500);
    trial.tendon.own.push_back({static_cast<int>(t) + 1, stiffness, {}});
    trial.springs_mm[ends.front()] = EA_N / stiffness;
  }
}

std::set<int> fingers_of_loops(const Routing& routing) {
  std::set<int> fingers;
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (tendon.closed && is_of_finger(token.kind)) fingers.insert(token.finger);
    }
  }
  return fingers;
}

GuidedTrial random_guided_trial(Dice& dice) {
  Routing routing = dice.chance(0.6) ? testing::random_routing(dice, {1, 4, true, true})
                                     : parse_routing(testing::random_mechanism(dice));
  if (dice.chance(0.5)) routing = testing::with_several_motors(dice, routing);
  GuidedTrial trial{routing,
                    testing::random_grasp(dice, finger_count(routing)),
                    dice.chance(0.3) ? Direction::release : Direction::pull,
                    {},
                    {},
                    {},
                    {}};
  trial.laws = testing::random_reference_hardware(dice, to_word(routing));
  if (dice.chance(0.5)) add_springs(dice, expand(routing), trial);
  const std::set<int> of_loops = fingers_of_loops(routing);
  for (int finger = 1; finger <= finger_count(routing); ++finger) {
    if (dice.chance(0.2)) continue;
    // Circulation round a loop follows another law there (finger_guides.hpp).
    if (!trial.grasp.holds(finger) && of_loops.contains(finger)) continue;
    for (int n = dice.integer(1, 3); n > 0; --n) {
      trial.guides[finger].push_back(dice.real(0, 0.4));
    }
  }
  return trial;
}

// With stretches between guides as short as nothing.
ReferenceResult reference_of(const GuidedTrial& trial, const Network& plain, const Mechanics& m,
                             const GuidedNetwork& guided) {
  testing::ExponentsByName phi;
  std::vector<double> others;
  for (const TendonSpan& tendon : plain.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k)
      others.push_back(m.phi[tendon.first_contact + k]);
  }
  std::size_t next = 0;
  for (const TendonSpan& tendon : guided.network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto own = guided.guide_phi.find(tendon.first_contact + k);
      phi[testing::name_of(guided.network, tendon, k)] =
          own == guided.guide_phi.end() ? others.at(next++) : own->second;
    }
  }
  std::map<std::string, double> length;
  for (const std::size_t i : guided.inner) length[segment_name(guided.network.segments[i])] = 1e-12;
  for (std::size_t i = 0; i < plain.segments.size(); ++i) {
    const std::string name = segment_name(plain.segments[i]);
    double own = plain.segments[i].kind == SegmentKind::strand       ? trial.laws.strand_length
                 : plain.segments[i].kind == SegmentKind::motor_side ? trial.laws.motor_side_length
                                                                     : trial.laws.hand_length;
    if (trial.laws.length_override) own = trial.laws.length_override(name, own);
    const auto spring = trial.springs_mm.find(name);
    if (spring != trial.springs_mm.end()) own += spring->second;
    length[segment_name(guided.network.segments[guided.place[i]])] = own;
  }
  ReferenceHardware laws = trial.laws;
  laws.phi_override = [phi](const std::string& left, const std::string& right, double) {
    return phi.at({left, right});
  };
  laws.length_override = [length](const std::string& name, double) { return length.at(name); };
  return testing::reference_tensions(to_word(with_tubes(trial.routing, trial.guides)), trial.grasp,
                                     trial.direction, laws);
}

void put_guides(const Network& network, const Guides& guides, Mechanics& m) {
  m.guided_tips.resize(network.contacts.size());
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    const Contact& contact = network.contacts[k];
    const auto own = guides.find(contact.finger);
    if (contact.place != ContactPlace::tip || own == guides.end()) continue;
    const double of_guides = 2 * sum_of(own->second, own->second.size());
    m.phi[k] += of_guides;
    m.decay[k] = std::exp(-m.phi[k]);
    m.guided_tips[k] = {m.phi[k], of_guides};
  }
}

// A strand of a finger rests at its palm end. Tied by blocks or on a loop, and as the finger opens,
// its guides count as sliding, and for the other solver they rest.
bool rests_otherwise(const Network& network, const GuidedTrial& trial, const TensionState& state) {
  for (const TendonSpan& tendon : network.tendons) {
    if (trial.direction == Direction::pull && !is_tied(network, tendon)) continue;
    for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
      const Contact& contact = network.contacts[k];
      if (contact.place != ContactPlace::tip || !trial.guides.contains(contact.finger)) continue;
      const double closing = state.closing[static_cast<std::size_t>(contact.finger) - 1];
      if (closing > 0 && std::abs(std::abs(state.slip[k]) - closing) < 1e-9) return true;
    }
  }
  return false;
}

TEST(FingerGuidesProperty, TensionsAtPalmAndJointsAreThoseOfAnIndependentSolver) {
  constexpr int trials = 2000;
  constexpr double tight = 1e-9;
  int joints = 0;
  int several_motors = 0;
  int sprung = 0;
  int blocks = 0;
  int unsolved = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Dice dice(seed);
    const GuidedTrial trial = random_guided_trial(dice);
    if (trial.guides.empty()) continue;
    SCOPED_TRACE(std::to_string(seed) + ": " + to_word(trial.routing) + ", held " +
                 to_text(trial.grasp));
    const Network network = expand(trial.routing);
    const Mechanics plain = testing::mechanics_of(network, trial.laws, trial.tendon);
    Mechanics m = plain;
    put_guides(network, trial.guides, m);
    TensionState state;
    TensionSolver().solve(network, m, trial.grasp, trial.direction, state);
    if (!state.in_range || rests_otherwise(network, trial, state)) continue;
    const GuidedNetwork guided = GuideReader(network, trial.routing, trial.guides).result();
    ReferenceResult expected;
    try {
      expected = reference_of(trial, network, plain, guided);
    } catch (const std::logic_error&) {  // stretches so short leave it without an answer
      ++unsolved;
      continue;
    }
    const auto tension = [&](std::size_t i) {
      return expected.tension.at(segment_name(guided.network.segments[i]));
    };
    EXPECT_EQ(state.jams, expected.jams);
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      const double there = tension(guided.place[i]);
      EXPECT_NEAR(state.tension[i], there, tight * there + 1e-15)
          << segment_name(network.segments[i]);
    }
    const FingerPullArray pulls = finger_pulls_of(network, m, state);
    for (const auto& [finger, exponents] : trial.guides) {
      if (trial.direction == Direction::release) break;  // pulls are of motors that pull
      for (std::size_t j = 0; j < exponents.size(); ++j) {
        double behind = 0;
        for (const GuidedStrand& strand : guided.strands.at(finger)) {
          behind += tension(strand.behind[j]);
        }
        const double decay = std::exp(-sum_of(exponents, j + 1));
        EXPECT_NEAR(pulls[static_cast<std::size_t>(finger)].behind_guide_N(decay), behind,
                    tight * behind + 1e-15)
            << "finger " << finger << ", joint " << j + 1;
        ++joints;
      }
    }
    several_motors += carriage_count(trial.routing) > 1;
    sprung += !trial.springs_mm.empty();
    blocks += !network.blocks.empty();
    if (::testing::Test::HasFailure()) return;
  }
  for (const int cases : {joints, several_motors, sprung, blocks}) EXPECT_GT(cases, trials / 20);
  EXPECT_LT(unsolved, trials / 100);
}

}  // namespace
}  // namespace reeve
