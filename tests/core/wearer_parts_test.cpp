#include "core/wearer_parts.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"

namespace reeve {
namespace {

TEST(WearerParts, AreStrandsAlongFingersAndMovingPartsAtTheHand) {
  const WearerParts loop = wearer_parts(parse_routing("1-P-2-P-1"));
  EXPECT_EQ(loop.moving_parts, 0);
  EXPECT_EQ(loop.strands, 4);
  const WearerParts tree = wearer_parts(parse_routing("M-Y1+W1-Y1-3x+1x-W1-2x"));
  EXPECT_EQ(tree.moving_parts, 2);
  EXPECT_EQ(tree.strands, 3);
}

}  // namespace
}  // namespace reeve
