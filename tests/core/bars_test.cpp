#include "core/bars.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"

namespace reeve {
namespace {

std::string barred(const std::string& word) {
  const std::optional<Routing> routing = with_bars(parse_routing(word));
  return routing ? to_word(*routing) : "none";
}

TEST(WithBars, PutsABarInPlaceOfEachBlock) {
  EXPECT_EQ(barred("M-Y1+1x-Y1-2x"), "M-W1+1x-W1-2x");
  EXPECT_EQ(barred("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x"), "M-W1+W2-W1-W3+1x-W2-2x+3x-W3-4x");
}

TEST(WithBars, DoesNotApplyWithoutBlocks) {
  EXPECT_EQ(barred("M-1-T-2-F"), "none");
  EXPECT_EQ(barred("M-W1+1x-W1-2x"), "none");
}

// A bar has two arms.
TEST(WithBars, DoesNotApplyToATackle) { EXPECT_EQ(barred("M-B-Y1-B-Y1k+Y1-1x"), "none"); }

}  // namespace
}  // namespace reeve
