// Routings of several motors: their numbers by formula, generated, and by brute force. What limits/
// does not know is explored one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "search/enumerate/counting.hpp"
#include "search/routing_source.hpp"
#include "tests/search/counted_parts.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/naive_exploration.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

RoutingNumbers by_formula(const PartSet& parts, int fingers, FingerIdentity identity) {
  return numbers_of(count_routings(parts, fingers, identity));
}

RoutingNumbers by_brute_force(const PartSet& parts, int fingers, FingerIdentity identity) {
  RoutingNumbers sum(3, 0);
  for (int blocks = 0; blocks <= parts.blocks; ++blocks) {
    const RoutingNumbers counts = numbers_of(
        brute_force_trees(counted_with_trees(parts), fingers, blocks, identity == identical));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
  }
  return sum;
}

TEST(MotorGenerator, TwoMotorsOnTwoFingers) {
  EXPECT_EQ(generated_words(generating(with_motors(paper_parts(), 2), 2, identical, true)),
            (std::vector<std::string>{"M-1-T-2-M2", "M-1-P-2-M2", "M-1-P2-2-M", "M-1-P2-2-F",
                                      "1-P-2-P2-1"}));
  EXPECT_EQ(
      generated_words(generating(with_motors(parts_of("tube", "", "M,F"), 2), 2, identical)),
      (std::vector<std::string>{"M-1-M+M-2-M2", "M-1-M+M2-2-M2", "M-1-M2+M-2-M2", "M-1-M+M2-2-F",
                                "M-1-M2+M-2-F", "M-1-M2+F-2-F", "M-1-F+M2-2-F"}));
}

TEST(MotorGenerator, ThreeMotorsThatAreToldApart) {
  EXPECT_EQ(generated_words(generating(with_motors(parts_of("tube", "P", "M"), 3), 1, distinct)),
            std::vector<std::string>{});
  const auto words =
      generated_words(generating(with_motors(parts_of("tube", "P", "M"), 3), 2, distinct, true));
  EXPECT_EQ(std::set<std::string>(words.begin(), words.end()),
            (std::set<std::string>{"M-1-P2-2-M3", "M-2-P2-1-M3", "M-1-P3-2-M2", "M-2-P3-1-M2",
                                   "M2-1-P-2-M3", "M2-2-P-1-M3"}));
}

void expect_brute_force(const PartSet& parts, int fingers, FingerIdentity identity) {
  EXPECT_EQ(by_formula(parts, fingers, identity), by_brute_force(parts, fingers, identity))
      << label_of(generating(parts, fingers, identity));
}

TEST(MotorGenerator, CountsAreThoseOfBruteForce) {
  SKIP_UNDER_SANITIZERS();
  for (const FingerIdentity identity : {identical, distinct}) {
    for (const int motors : {2, 3, 4}) {
      for (const PartSet& parts :
           {paper_parts(), anchored(full_parts()), parts_of("tube", "T,P", ""),
            parts_of("tube", "", "M,F"), parts_of("tube", "P", "F"), parts_of("bearing", "T", "M"),
            parts_of("tube", "P", "M")}) {
        for (const int fingers : {1, 2}) {
          expect_brute_force(with_motors(parts, motors), fingers, identity);
        }
      }
      expect_brute_force(with_motors(with_blocks(anchored(paper_parts()), 1), motors), 2, identity);
      expect_brute_force(with_motors(with_blocks(parts_of("tube", "P", "M"), 2), motors), 2,
                         identity);
    }
    expect_brute_force(with_motors(paper_parts(), 2), 3, identity);
  }
  expect_brute_force(with_motors(parts_of("tube", "P", "M"), 6), 3, identical);
}

// Each canonical, each once, as many as the formula says, no motor idle.
void expect_as_counted(const GeneratorOptions& o) {
  SCOPED_TRACE(label_of(o));
  std::set<std::string> seen;
  std::uint64_t actuated = 0;
  for_each_generated(o, [&](const Routing& routing) {
    const std::string word = to_word(routing);
    ASSERT_EQ(to_word(canonical(routing, o.identity)), word);
    ASSERT_EQ(parse_routing(word), routing) << word;
    ASSERT_EQ(carriage_count(routing), o.parts.motors) << word;
    ASSERT_TRUE(seen.insert(word).second) << word;
    actuated += is_actuated(routing) ? 1 : 0;
  });
  const auto counts = count_routings(o.parts, o.fingers, o.identity);
  EXPECT_EQ(seen.size(), RoutingGenerator(o).total());
  EXPECT_EQ(actuated, o.one_tendon ? counts.one_tendon : counts.actuated);
  if (!o.one_tendon) {
    EXPECT_EQ(seen.size(), counts.all);
  }
}

TEST(MotorGenerator, RoutingsAreCanonicalAndUniqueAndAsManyAsCounted) {
  for (const bool one_tendon : {false, true}) {
    for (const int motors : {2, 3}) {
      for (int fingers = 1; fingers <= 4; ++fingers) {
        expect_as_counted(
            generating(with_motors(paper_parts(), motors), fingers, identical, one_tendon));
      }
      for (int fingers = 1; fingers <= 3; ++fingers) {
        expect_as_counted(
            generating(with_motors(paper_parts(), motors), fingers, distinct, one_tendon));
        expect_as_counted(generating(with_motors(with_blocks(anchored(paper_parts()), 1), motors),
                                     fingers, identical, one_tendon));
      }
      expect_as_counted(
          generating(with_motors(anchored(full_parts()), motors), 2, identical, one_tendon));
    }
    expect_as_counted(generating(with_motors(paper_parts(), 6), 3, identical, one_tendon));
    expect_as_counted(generating(with_motors(with_blocks(anchored(paper_parts()), 2), 2), 2,
                                 distinct, one_tendon));
  }
}

// One after the other they are those of one motor.
TEST(MotorGenerator, FollowsTheOrderOfOneMotor) {
  const PartSet parts = with_blocks(anchored(paper_parts()), 1);
  std::vector<std::string> of_one = generated_words(generating(parts, 2, identical));
  auto place = of_one.begin();
  for_each_generated(generating(with_motors(parts, 2), 2, identical), [&](Routing routing) {
    for (Tendon& tendon : routing.tendons) {
      for (Token& token : tendon.walk) token.carriage = 1;
    }
    place = std::find(place, of_one.end(), to_word(canonical(routing, identical)));
    ASSERT_NE(place, of_one.end()) << to_word(routing);
  });
}

TEST(MotorGenerator, SeekGoesToAnyIndex) {
  const GeneratorOptions o =
      generating(with_motors(with_blocks(anchored(paper_parts()), 1), 2), 2, identical);
  const std::vector<std::string> whole = generated_words(o);
  RoutingGenerator generator(o);
  Routing routing;
  for (std::size_t step = 0; step < 2 * whole.size(); ++step) {
    const std::size_t i = step * 37 % (whole.size() + 1);
    generator.seek(i);
    ASSERT_EQ(generator.next(routing), i < whole.size());
    if (i == whole.size()) continue;
    ASSERT_EQ(to_word(routing), whole[i]);
  }
}

void expect_explored(ExploreOptions options) {
  options.constraints = constraints_of({"sheaths<=3", "efficiency>=0.1"});
  options.top = 5;
  EXPECT_EQ(pruning_constraints(options), 0U);
  const Naive naive = naive_program(options);
  const ExploreResult result = explore(options);
  EXPECT_EQ(result.generated, naive.generated);
  EXPECT_EQ(result.rejected[0].count, naive.not_actuated);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(result.rejected[c + 1].count, naive.failed[c]);
  const auto ranked = rank(naive.kept, options.order);
  ASSERT_FALSE(ranked.empty());
  ASSERT_EQ(result.top.size(), std::min<std::size_t>(5, ranked.size()));
  for (std::size_t i = 0; i < result.top.size(); ++i) expect_same(result.top[i], ranked[i]);
}

TEST(MotorGenerator, ExploresWhatANaiveProgramFinds) {
  ExploreOptions options = options_for(with_motors(anchored(paper_parts()), 2), 2);
  options.grasps = parse_grasps("none@1,0.5/1@1,1:2/2@0.5,1", 2, 2);
  expect_explored(options);
  expect_explored(options_for(with_beside(with_blocks(anchored(paper_parts()), 1), "P"), 2));
}

}  // namespace
}  // namespace reeve::testing
