#include "search/evaluate/tree_spans.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/notation.hpp"

namespace reeve {
namespace {

// The key of a tree has no angles: M-1-F would stand for M-1/90-F.
TEST(TreeSpans, AreNotThoseOfARoutingThatGivesAWrapAngle) {
  std::vector<TreeSpan> spans;
  EXPECT_TRUE(split_into_trees(parse_routing("M-1-F+M-2-F"), spans));
  EXPECT_FALSE(split_into_trees(parse_routing("M-1-F+M-2/90-F"), spans));
}

}  // namespace
}  // namespace reeve
