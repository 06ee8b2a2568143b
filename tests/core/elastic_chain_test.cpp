#include "core/tension/elastic_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

std::vector<double> solve(const std::vector<ChainSegment>& segments,
                          const std::vector<ChainContact>& contacts) {
  std::vector<double> tension(segments.size(), -1);
  ElasticChain().solve(segments, contacts, tension);
  return tension;
}

ChainContact still(double phi) { return {std::exp(-phi), Slide::no}; }
ChainContact to_right(double phi) { return {std::exp(-phi), Slide::to_right}; }
ChainContact to_left(double phi) { return {std::exp(-phi), Slide::to_left}; }

// ---- closed forms ----

TEST(ElasticChain, OneSegmentIsASpring) {
  EXPECT_DOUBLE_EQ(solve({{4, 3}}, {})[0], 0.75);  // T = E / L
}

TEST(ElasticChain, AStillContactLetsEachSideBeASpringInsideTheCone) {
  const auto tension = solve({{1, 1}, {2, 2.4}}, {still(0.5)});
  EXPECT_DOUBLE_EQ(tension[0], 1);
  EXPECT_DOUBLE_EQ(tension[1], 1.2);
}

TEST(ElasticChain, AStillContactTransmitsWhatIsOutsideTheCone) {
  // T1 = T2 e^{-phi} and L1 T1 + L2 T2 = E1 + E2
  const double d = std::exp(-0.5);
  const auto tension = solve({{3, 1}, {2, 7}}, {still(0.5)});
  EXPECT_DOUBLE_EQ(tension[1], 8 / (3 * d + 2));
  EXPECT_DOUBLE_EQ(tension[0], d * 8 / (3 * d + 2));
  const auto mirrored = solve({{2, 7}, {3, 1}}, {still(0.5)});
  EXPECT_DOUBLE_EQ(mirrored[0], tension[1]);
  EXPECT_DOUBLE_EQ(mirrored[1], tension[0]);
}

TEST(ElasticChain, WithoutFrictionAllSegmentsAreOneSpring) {
  for (const double t : solve({{1, 0}, {2, 5}, {3, 1}}, {still(0), still(0)})) {
    EXPECT_DOUBLE_EQ(t, 1);
  }
}

TEST(ElasticChain, ASlidingContactIsAnExactRatio) {
  const double d = std::exp(-0.7);
  // To the right: T1 = d T2, L1 d T2 + L2 T2 = E1 + E2.
  const auto right = solve({{1, 0}, {2, 3}}, {to_right(0.7)});
  EXPECT_DOUBLE_EQ(right[1], 3 / (d + 2));
  EXPECT_DOUBLE_EQ(right[0], d * right[1]);
  // To the left: T2 = d T1.
  const auto left = solve({{1, 0}, {2, 3}}, {to_left(0.7)});
  EXPECT_DOUBLE_EQ(left[0], 3 / (1 + 2 * d));
  EXPECT_DOUBLE_EQ(left[1], d * left[0]);
}

TEST(ElasticChain, ASlidingContactKeepsItsRatioWhateverTheElasticitySays) {
  const auto tension = solve({{1, 100}, {1, 1}}, {to_right(0.3)});
  EXPECT_DOUBLE_EQ(tension[0] / tension[1], std::exp(-0.3));
}

TEST(ElasticChain, ASegmentThatTakesNothingUpHangsAtTheEdgeOfTheCone) {
  const auto tension = solve({{1, 0}, {5, 0}, {1, 1}}, {still(0.2), still(0.3)});
  EXPECT_DOUBLE_EQ(tension[1], tension[2] * std::exp(-0.3));
  EXPECT_DOUBLE_EQ(tension[0], tension[1] * std::exp(-0.2));
}

TEST(ElasticChain, ASegmentBehindVeryMuchFrictionStillHangsAtTheEdgeOfTheCone) {
  // Its own stiffness is lost in the rounding of what stands before it.
  for (int i = 0; i < 100; ++i) {
    const double phi = 9 + 0.01 * i;
    const auto tension =
        solve({{1, 1}, {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 0}},
              {to_left(phi), to_left(phi), to_left(phi), to_left(phi), still(0.3)});
    EXPECT_NEAR(tension[0], 1, 1e-3) << phi;
    EXPECT_NEAR(tension[4] / tension[0], std::exp(-4 * phi), 1e-12 * std::exp(-4 * phi)) << phi;
    EXPECT_DOUBLE_EQ(tension[5], tension[4] * std::exp(-0.3)) << phi;
  }
}

TEST(ElasticChain, NothingTakenUpIsNoTension) {
  for (const double t : solve({{1, 0}, {2, 0}, {1, 0}}, {still(0.2), to_left(0.3)})) {
    EXPECT_EQ(t, 0);
  }
}

TEST(ElasticChain, IsReusable) {
  ElasticChain chain;
  std::vector<double> one(1);
  std::vector<double> three(3);
  const std::vector<ChainSegment> segments{{1, 1}, {2, 1}, {1, 3}};
  const std::vector<ChainContact> contacts{still(0.1), still(0.2)};
  chain.solve(segments, contacts, three);
  chain.solve(std::vector<ChainSegment>{{2, 3}}, {}, one);
  EXPECT_DOUBLE_EQ(one[0], 1.5);
  std::vector<double> again(3);
  chain.solve(segments, contacts, again);
  EXPECT_EQ(again, three);
}

// ---- optimality of random chains ----

struct Chain {
  std::vector<ChainSegment> segments;
  std::vector<ChainContact> contacts;
};

ChainContact random_contact(testing::Dice& dice) {
  const double phi = dice.chance(0.2) ? 0 : dice.log_real(1e-3, 2);
  const Slide slide = dice.chance(0.6)   ? Slide::no
                      : dice.chance(0.5) ? Slide::to_left
                                         : Slide::to_right;
  return {std::exp(-phi), slide};
}

Chain random_chain(testing::Dice& dice) {
  Chain chain;
  const int segments = dice.integer(1, 20);
  for (int i = 0; i < segments; ++i) {
    chain.segments.push_back(
        {dice.log_real(0.1, 10), dice.chance(0.4) ? 0 : dice.log_real(0.01, 10)});
    if (i > 0) chain.contacts.push_back(random_contact(dice));
  }
  chain.segments[static_cast<std::size_t>(dice.integer(0, segments - 1))].take_up = 1;
  return chain;
}

// The force that contact k carries, from the stationarity of the cost in u_0 … u_k: minus the
// partial sum of L_i T_i − E_i. Positive where it keeps the left tension from rising further.
std::vector<double> contact_forces(const Chain& chain, const std::vector<double>& tension) {
  std::vector<double> force;
  double sum = 0;
  for (std::size_t i = 0; i < tension.size(); ++i) {
    sum -= chain.segments[i].length * tension[i] - chain.segments[i].take_up;
    force.push_back(sum);
  }
  return force;
}

void expect_sliding_ratio(const ChainContact& contact, double left, double right) {
  if (contact.slide == Slide::to_right) {
    EXPECT_NEAR(left / right, contact.decay, 1e-12);
  }
  if (contact.slide == Slide::to_left) {
    EXPECT_NEAR(right / left, contact.decay, 1e-12);
  }
}

void expect_stick(const ChainContact& contact, double left, double right, double force) {
  constexpr double tolerance = 1e-9;
  EXPECT_LE(left * contact.decay, right * (1 + tolerance));
  EXPECT_LE(right * contact.decay, left * (1 + tolerance));
  // Only a contact at the edge of its cone carries a force, and only towards the cone.
  if (force > tolerance) {
    EXPECT_NEAR(right / left, contact.decay, tolerance);
  }
  if (force < -tolerance) {
    EXPECT_NEAR(left / right, contact.decay, tolerance);
  }
}

TEST(ElasticChain, RandomChainsMeetTheOptimalityConditions) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::Dice dice(seed);
    const Chain chain = random_chain(dice);
    const std::vector<double> tension = solve(chain.segments, chain.contacts);
    const std::vector<double> force = contact_forces(chain, tension);
    EXPECT_NEAR(force.back(), 0, 1e-9);  // nothing holds the whole chain
    for (std::size_t k = 0; k < chain.contacts.size(); ++k) {
      const ChainContact& contact = chain.contacts[k];
      if (contact.slide == Slide::no) {
        expect_stick(contact, tension[k], tension[k + 1], force[k]);
      } else {
        expect_sliding_ratio(contact, tension[k], tension[k + 1]);
      }
    }
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace reeve
