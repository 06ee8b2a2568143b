// Against the solver that goes by way of a network, for every tendon there is.
#include "search/evaluate/tendon_sums.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "tests/search/solved_tendon.hpp"

namespace reeve::testing {
namespace {

void expect_near(double seen, double expected, const std::string& what) {
  ASSERT_NEAR(seen, expected, 1e-11 * (1 + std::abs(expected))) << what;
}

void expect_same(const TreeOutline& seen, const TreeOutline& expected, const std::string& word) {
  ASSERT_EQ(seen.sums.size(), expected.sums.size()) << word;
  for (std::size_t held = 0; held < seen.sums.size(); ++held) {
    const TreeSums& a = seen.sums[held];
    const TreeSums& b = expected.sums[held];
    const std::string what = word + ", held " + std::to_string(held);
    ASSERT_FALSE(b.jams) << what;
    ASSERT_EQ(a.in_range, b.in_range) << what;
    expect_near(a.motor, b.motor, what + ", motor");
    expect_near(a.strands.least, b.strands.least, what + ", least");
    expect_near(a.strands.most, b.strands.most, what + ", most");
    expect_near(a.strands.sum, b.strands.sum, what + ", sum");
    expect_near(a.strands.work, b.strands.work, what + ", work");
  }
  const PartCount& a = seen.parts;
  const PartCount& b = expected.parts;
  for (const auto count :
       {&PartCount::sheaths, &PartCount::pulleys, &PartCount::knots, &PartCount::blocks,
        &PartCount::anchors, &PartCount::tip_bearings, &PartCount::fixed_pulleys,
        &PartCount::movable_pulleys, &PartCount::tubes, &PartCount::fixed_ends}) {
    ASSERT_EQ(a.*count, b.*count) << word;
  }
}

PartSet all_without_blocks() {
  PartSet parts = all_parts();
  parts.blocks = 0;
  return parts;
}

TreeOutline solved(const Hardware& hardware, const Routing& tree) {
  const Network network = expand(tree);
  TreeOutline outline{parts(network), network.fingers, {}};
  for (int held = 0; held <= network.fingers; ++held) {
    outline.sums.push_back(solved_sums(hardware, network, held));
  }
  return outline;
}

std::size_t compared(const Hardware& hardware, int fingers) {
  TendonSums quick(hardware);
  TreeOutline outline;
  std::vector<TreeSpan> spans;
  std::size_t many = 0;
  RoutingGenerator generator({all_without_blocks(), fingers, FingerIdentity::identical, true});
  for (Routing routing; generator.next(routing) && !::testing::Test::HasFailure();) {
    if (!is_actuated(routing)) continue;
    EXPECT_TRUE(split_into_trees(routing, spans));
    const TreeOutline expected = solved(hardware, routing);
    const bool jams = std::any_of(expected.sums.begin(), expected.sums.end(),
                                  [](const TreeSums& sums) { return sums.jams; });
    EXPECT_EQ(quick.find(routing.tendons.front(), finger_count(routing), outline), !jams)
        << to_word(routing);
    if (jams) continue;
    expect_same(outline, expected, to_word(routing));
    ++many;
  }
  return many;
}

TEST(TendonSums, AreThoseOfTheSolverForEveryTendon) {
  for (const Hardware& hardware :
       {Hardware{}, with_friction(0.31, 0.002, 0.09), with_friction(0, 0, 0),
        with_friction(0.3, 0, 0.3), with_friction(2.5, 0.4, 1.5)}) {
    EXPECT_EQ(compared(hardware, 1), 0U);  // held, its finger leaves nothing to close
    EXPECT_GT(compared(hardware, 2), 10U);
    EXPECT_GT(compared(hardware, 3), 100U);
    EXPECT_GT(compared(hardware, 4), 1000U);
  }
}

// Of a tendon that is not the first: its fingers count from another number.
TEST(TendonSums, KnowTheFingersBeforeIt) {
  const Hardware hardware = with_friction(0.2, 0.001, 0.1);
  TendonSums quick(hardware);
  const Routing routing = parse_routing("M-1-F+M-2-B-3-P-4-F");
  std::vector<TreeSpan> spans;
  ASSERT_TRUE(split_into_trees(routing, spans));
  TreeOutline outline;
  ASSERT_TRUE(quick.find(routing.tendons[1], 3, outline));
  expect_same(outline, solved(hardware, parse_routing("M-1-B-2-P-3-F")), "behind one finger");
}

TEST(TendonSums, TakeNoTendonThatBlocksTieOrNoMotorPulls) {
  TendonSums quick({});
  TreeOutline outline;
  for (const char* word : {"M-Y1+1x-Y1-2x", "F-1-T-2-F", "M-1-F"}) {
    const Routing routing = parse_routing(word);
    std::vector<TreeSpan> spans;
    ASSERT_TRUE(split_into_trees(routing, spans));
    EXPECT_FALSE(quick.find(routing.tendons.front(), finger_count(routing), outline)) << word;
  }
}

// e^{±phi} of so much friction leave the range of a double.
TEST(TendonSums, SayWhereNumbersEnd) {
  TendonSums quick(with_friction(100, 100, 100));
  const Routing routing = parse_routing("M-1-T-2-T-3-T-4-F");
  std::vector<TreeSpan> spans;
  ASSERT_TRUE(split_into_trees(routing, spans));
  TreeOutline outline;
  ASSERT_TRUE(quick.find(routing.tendons.front(), finger_count(routing), outline));
  EXPECT_FALSE(outline.sums.front().in_range);
}

}  // namespace
}  // namespace reeve::testing
