#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"

namespace reeve {
namespace {

std::vector<double> pulls(const std::string& word, int fingers, Grasp grasp) {
  const Network network = testing::network_of(word);
  const TensionState state = tensions(network, mechanics(network, Hardware{}), grasp);
  std::vector<double> found;
  for (int f = 1; f <= fingers; ++f) {
    found.push_back(state.tension[*find_segment(network, {SegmentKind::strand, 2 * f - 1})]);
  }
  return found;
}

TEST(Plate, SharesAPullInItsCentreEquallyAmongThreeTies) {
  for (std::uint64_t held = 0; held < 7; ++held) {
    const std::vector<double> found = pulls("1x-W1-2x+3x-W1k+M-W1", 3, Grasp{held});
    EXPECT_NEAR(found[1] / found[0], 1, 1e-6) << held;
    EXPECT_NEAR(found[2] / found[0], 1, 1e-6) << held;
  }
}

// Ties at (0, 0), (10, 0) and (2, 6) mm, the pull at (4, 1.5) mm: one force and two moments.
TEST(Plate, BalancesOneForceAndTwoMoments) {
  Eigen::Matrix3d balance;
  balance << 1, 1, 1, 0, 10, 2, 0, 0, 6;
  const Eigen::Vector3d parts = balance.fullPivLu().solve(Eigen::Vector3d(1, 4, 1.5));
  ASSERT_NEAR(parts[0] / parts[1], 8. / 7, 1e-12);
  ASSERT_NEAR(parts[2], 1. / 4, 1e-12);
  for (std::uint64_t held = 0; held < 7; ++held) {
    const std::vector<double> found = pulls("1x-W1/8:7-2x+3x-W1k/1:3+M-W1", 3, Grasp{held});
    const double sum = found[0] + found[1] + found[2];
    for (std::size_t f = 0; f < 3; ++f) {
      EXPECT_NEAR(found[f] / sum, parts[static_cast<Eigen::Index>(f)], 1e-6) << held;
    }
  }
}

TEST(Plate, IsWrittenWithTwoBars) {
  EXPECT_EQ(to_word(parse_routing("1x-W1-2x+3x-W1k+W1-M")), "1x-W2-2x+3x-W1/1:2-W2+W1-M");
  EXPECT_EQ(to_word(parse_routing("W1k/2:3-3x+1x-W1-2x+M-W1+M-W2+4x-W2-5x")),
            "W3-W1/3:2-3x+1x-W3-2x+M-W1+M-W2+4x-W2-5x");
  EXPECT_EQ(canonical(parse_routing("1x-W1-2x+3x-W1k+W1-M"), FingerIdentity::identical),
            canonical(parse_routing("M-W9+W9k-2x+3x-W9-1x"), FingerIdentity::identical));
}

TEST(Plate, HangsOnAnotherPlate) {
  const std::string word = "1x-W1-2x+3x-W1k+4x-W2-5x+W1-W2k/3:2+M-W2";
  for (const double pull : pulls(word, 5, Grasp{})) {
    EXPECT_NEAR(pull, pulls(word, 5, Grasp{}).front(), 1e-6);
  }
}

}  // namespace
}  // namespace reeve
