// Bounds on tendons that begin alike, held against the solver for every tendon; their numbers,
// against a list of all.
#include "search/limits/walk_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/notation.hpp"
#include "core/performance.hpp"
#include "search/limits/beginning_counts.hpp"
#include "tests/search/generated.hpp"
#include "tests/search/solved_tendon.hpp"

namespace reeve::testing {
namespace {

GeneratorOptions one_tendon(const PartSet& parts, int fingers) {
  return {parts, fingers, FingerIdentity::identical, true};
}

// Returns how many states were held against bounds.
std::size_t compared(const Hardware& hardware, int fingers, double motor_beside) {
  const double most_efficiency = std::exp(-hardware.sheath.exponent());
  WalkBounds bounds(hardware, full_parts(), fingers, motor_beside);
  TreeOutline outline;
  std::size_t many = 0;
  for_each_generated(one_tendon(full_parts(), fingers), [&](const Routing& routing) {
    const Tendon& tendon = routing.tendons.front();
    if (tendon.closed || !is_actuated(routing) || ::testing::Test::HasFailure()) return;
    const Network network = expand(routing);
    const int motor_sides = parts(network).sheaths;
    for (int held = 0; held <= fingers; ++held) {
      const TreeSums sums = solved_sums(hardware, network, held);
      const double uniformity = sums.strands.least / sums.strands.most;
      const double efficiency =
          (sums.strands.work + most_efficiency * motor_beside) / (sums.motor + motor_beside);
      for (int passed = fingers / 2; passed < fingers; ++passed, ++many) {
        if (passed == 0) continue;
        bounds.read(tendon.walk, passed);
        ASSERT_TRUE(bounds.outline(motor_sides, outline)) << to_word(routing);
        const TreeSums& bound = outline.sums[static_cast<std::size_t>(held)];
        ASSERT_LE(uniformity, bound.strands.least * (1 + 1e-10))
            << to_word(routing) << ", held " << held << ", passed " << passed;
        ASSERT_LE(efficiency, bound.strands.work + 1e-10)
            << to_word(routing) << ", held " << held << ", passed " << passed;
        ASSERT_LE(outline.parts.pulleys, parts(network).pulleys);
      }
    }
  });
  return many;
}

TEST(WalkBounds, HoldForEveryTendonThatBeginsSo) {
  for (const Hardware& hardware :
       {Hardware{}, with_friction(0.31, 0.002, 0.09), with_friction(0, 0, 0),
        with_friction(0.05, 0.2, 0.3), with_friction(2.5, 0.4, 1.5)}) {
    EXPECT_GT(compared(hardware, 2, 0), 50U);
    EXPECT_GT(compared(hardware, 3, 0.7), 500U);
    EXPECT_GT(compared(hardware, 4, 0), 5000U);
    EXPECT_GT(compared(hardware, 4, 0.02), 5000U);
  }
  EXPECT_GT(compared({}, 5, 0), 50000U);
}

// The bound on the efficiency of `M-1-T-2-…` in which no finger is held, for one sheath: the tip
// and the join take what they take in every such tendon.
TEST(WalkBounds, SeeWhatTheWalkLoses) {
  WalkBounds bounds({}, full_parts(), 4, 0);
  TreeOutline outline;
  const Routing routing = parse_routing("M-1-T-2-T-3-T-4-F");
  bounds.read(routing.tendons.front().walk, 3);
  ASSERT_TRUE(bounds.outline(1, outline));
  const TreeSums sums = solved_sums({}, expand(routing), 0);
  EXPECT_LT(outline.sums[0].strands.work, 0.8 * std::exp(-Hardware{}.sheath.exponent()));
  EXPECT_LE(sums.strands.work / sums.motor, outline.sums[0].strands.work);
  EXPECT_FALSE(bounds.outline(5, outline));  // the rest has one join and one end
}

std::string shape(const Walk& walk, std::size_t tokens) {
  std::string shape;
  for (std::size_t i = 0; i < tokens; ++i) {
    shape += std::to_string(static_cast<int>(walk[i].kind)) +
             (walk[i].tip == TipKind::bearing ? "b " : " ");
  }
  return shape;
}

void expect_counts(const PartSet& parts, int fingers, const std::vector<Constraint>& constraints) {
  const GeneratorOptions options = one_tendon(parts, fingers);
  const PartClasses classes(constraints, options);
  BeginningCounts counts(classes, parts, fingers);
  std::map<std::string, ClassCounts> listed;
  std::map<std::string, Walk> walks;
  for_each_generated(options, [&](const Routing& routing) {
    const Tendon& tendon = routing.tendons.front();
    if (tendon.closed) return;
    for (int passed = (fingers + 1) / 2; passed < fingers; ++passed) {
      const std::string key = shape(tendon.walk, 2 * static_cast<std::size_t>(passed) + 1);
      ClassCounts& numbers = listed.try_emplace(key, no_counts(classes)).first->second;
      ++numbers[classes.of_tree(classes.of(tendon))];
      walks[key] = tendon.walk;
    }
  });
  ASSERT_FALSE(listed.empty());
  for (const auto& [key, numbers] : listed) {
    const Walk& walk = walks[key];
    std::size_t tokens = 0;
    while (shape(walk, tokens) != key) ++tokens;
    EXPECT_EQ(counts.count(walk, tokens), numbers) << key;
  }
}

TEST(BeginningCounts, AreThoseOfAList) {
  const std::vector<Constraint> some{parse_constraint("sheaths<=2"),
                                     parse_constraint("pulleys<=3")};
  for (int fingers = 2; fingers <= 5; ++fingers) {
    expect_counts(full_parts(), fingers, {});
    expect_counts(full_parts(), fingers, some);
    expect_counts(paper_parts(), fingers, {});
  }
}

}  // namespace
}  // namespace reeve::testing
