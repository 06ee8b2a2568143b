#include "core/nearest_name.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace reeve::core {
namespace {

// Computes the distance by the recursion that defines it, exponential in the lengths.
std::size_t by_recursion(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return std::max(a.size(), b.size());
  const std::string a1 = a.substr(1);
  const std::string b1 = b.substr(1);
  std::size_t least = by_recursion(a1, b1) + (a[0] == b[0] ? 0U : 1U);
  least = std::min({least, by_recursion(a1, b) + 1, by_recursion(a, b1) + 1});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0]) {
    least = std::min(least, by_recursion(a.substr(2), b.substr(2)) + 1);
  }
  return least;
}

RC_GTEST_PROP(EditDistance, IsThatOfTheRecursionThatDefinesIt, ()) {
  const auto letters = rc::gen::container<std::string>(rc::gen::elementOf(std::string("abc")));
  const std::string a = (*letters).substr(0, 5);
  const std::string b = (*letters).substr(0, 5);
  RC_ASSERT(edit_distance(a, b) == by_recursion(a, b));
}

TEST(NearestName, IsFoundThoughLettersAreMissingDoubledOrExchanged) {
  const std::vector<std::string> known{"fingers", "hardware", "threads", "top"};
  EXPECT_EQ(nearest_name("fingerz", known), "fingers");
  EXPECT_EQ(nearest_name("finger", known), "fingers");
  EXPECT_EQ(nearest_name("hradware", known), "hardware");
  EXPECT_EQ(nearest_name("Threads", known), "threads");
  EXPECT_EQ(nearest_name("tpo", known), "top");
}

TEST(NearestName, MayBeginWithTheWord) {
  EXPECT_EQ(nearest_name("obj", {"top", "objectives"}), "objectives");
  EXPECT_EQ(nearest_name("ob", {"objectives"}), "objectives");
  EXPECT_EQ(nearest_name("o", {"objectives"}), std::nullopt);
}

TEST(NearestName, IsNoneIfTooMuchWouldHaveToChange) {
  EXPECT_EQ(nearest_name("friction", {"fingers", "mu"}), std::nullopt);
  EXPECT_EQ(nearest_name("x", {"mu", "y"}), std::nullopt);
  EXPECT_EQ(nearest_name("", {"mu"}), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), {"a"}), std::nullopt);
}

TEST(NearestName, IsNoneIfMoreThanTwoAreEquallyNear) {
  EXPECT_EQ(nearest_name("TR9", {"TR1", "TR2", "TR3"}), std::nullopt);
  EXPECT_EQ(nearest_name("tr3", {"TR1", "TR2", "TR3"}), "TR3");
  EXPECT_EQ(nearest_name("min", {"mint", "mine", "most"}), "mint");
}

TEST(DidYouMean, IsEmptyWithoutANearName) {
  EXPECT_EQ(did_you_mean("wearr", {"wear"}), "; did you mean wear?");
  EXPECT_EQ(did_you_mean("rust", {"wear"}), "");
}

}  // namespace
}  // namespace reeve::core
