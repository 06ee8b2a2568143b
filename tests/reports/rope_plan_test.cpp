#include "reports/mujoco/rope_plan.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "core/network.hpp"
#include "core/notation.hpp"

namespace reeve::testing {
namespace {

std::pair<PointKind, std::size_t> what(const RopePoint& point) { return {point.kind, point.index}; }

TEST(RopePlan, ALoopComesBackToItsFirstPoint) {
  for (const char* word : {"1-P-2-P-1", "1-T-2-T-1"}) {
    const Routing routing = parse_routing(word);
    const RopePlan plan = rope_plan(routing, expand(routing));
    ASSERT_EQ(plan.ropes.size(), 1U) << word;
    const std::vector<RopePoint>& points = plan.ropes.front().points;
    ASSERT_GT(points.size(), 2U) << word;
    EXPECT_EQ(what(points.back()), what(points.front())) << word;
  }
}

TEST(RopePlan, AnOpenTendonEndsElsewhere) {
  const Routing routing = parse_routing("M-1-T-2-F");
  const RopePlan plan = rope_plan(routing, expand(routing));
  ASSERT_EQ(plan.ropes.size(), 1U);
  EXPECT_NE(what(plan.ropes.front().points.back()), what(plan.ropes.front().points.front()));
}

}  // namespace
}  // namespace reeve::testing
