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

// Y1 and W1 are two things, and the arms are part of what a tree does.
TEST(TreeSpans, TellBarsFromBlocksAndByTheirArms) {
  std::vector<TreeSpan> spans;
  EXPECT_TRUE(split_into_trees(parse_routing("M-Y1+1x-Y1-2x+M-W1+3x-W1-4x"), spans));
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_NE(spans[0].key, spans[1].key);
  const TreeKey even = spans[1].key;
  EXPECT_TRUE(split_into_trees(parse_routing("M-W1+1x-W1-2x+M-W2+3x-W2/1:2-4x"), spans));
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].key, even);
  EXPECT_NE(spans[1].key, even);
}

TEST(TreeSpans, AreCopiedWithBlocksAndBarsFromOneOn) {
  const Routing routing = parse_routing("M-Y1+1x-Y1-2x+M-W1+3x-W1/1:2-Y2+4x-Y2-5x");
  std::vector<TreeSpan> spans;
  ASSERT_TRUE(split_into_trees(routing, spans));
  ASSERT_EQ(spans.size(), 2U);
  Routing tree;
  copy_tree(routing, spans[1], tree);
  EXPECT_EQ(to_word(tree), "M-W1+1x-W1/1:2-Y1+2x-Y1-3x");
}

}  // namespace
}  // namespace reeve
