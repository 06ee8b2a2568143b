#include "core/bars.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"

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

TEST(Whiffletree, PullsInTheRatioByStatics) {
  for (const std::vector<double>& pulls : std::vector<std::vector<double>>{
           {2, 1}, {2, 1, 1}, {0.5, 0.25, 0.25}, {7, 3, 0.2, 1}, {1. / 3, 1. / 3, 1. / 3}}) {
    const auto routing = whiffletree(pulls);
    ASSERT_TRUE(routing);
    const Network network = testing::network_of(to_word(*routing));
    const Mechanics plain = mechanics(network, Hardware{});
    for (std::size_t held = 0; held <= pulls.size(); ++held) {
      const Grasp grasp{held > 0 ? std::uint64_t{1} << (held - 1) : 0};
      const TensionState state = tensions(network, plain, grasp);
      const auto pull = [&](std::size_t finger) {
        return state.tension[*find_segment(
            network, {SegmentKind::strand, static_cast<int>(2 * finger + 1)})];
      };
      for (std::size_t f = 0; f < pulls.size(); ++f) {
        EXPECT_NEAR(pull(f) / pull(0), pulls[f] / pulls[0], 1e-6) << to_word(*routing);
      }
    }
  }
}

TEST(Whiffletree, IsWrittenInTheSmallestWholeNumbers) {
  EXPECT_EQ(to_word(*whiffletree({2. / 3, 1. / 3})), "M-W1+1x-W1/2:1-2x");
  EXPECT_EQ(to_word(*whiffletree({0.5, 0.25, 0.25})), "M-W1+1x-W1-W2+2x-W2-3x");
  EXPECT_EQ(to_word(*whiffletree({0.2, 0.5, 0.3})), "M-W1+1x-W1/1:4-W2+2x-W2/5:3-3x");
}

TEST(Whiffletree, IsNoneOfOneFingerOrBeyondTheArmsOfAWord) {
  EXPECT_FALSE(whiffletree({1}));
  EXPECT_FALSE(whiffletree({1000, 0.001}));
  EXPECT_FALSE(whiffletree(std::vector<double>(34, 1.0)));
}

}  // namespace
}  // namespace reeve
