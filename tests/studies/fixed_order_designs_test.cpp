#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/canonical.hpp"
#include "core/notation.hpp"
#include "studies/catalogue_check.hpp"
#include "tests/support/published_words.hpp"

namespace reeve {
namespace {

TEST(FixedOrderDesigns, OfTwoFingersAreTheSevenOfThePaper) {
  std::set<std::string> words;
  for (const Routing& routing : fixed_order_designs(2)) {
    words.insert(to_word(canonical(routing, FingerIdentity::identical)));
  }
  const auto& published = testing::published_words();
  EXPECT_EQ(words, std::set<std::string>(published.begin(), published.end()));
}

TEST(FixedOrderDesigns, AreTwoToTheNPlusOneLessOne) {
  for (int fingers = 1; fingers <= 8; ++fingers) {
    EXPECT_EQ(fixed_order_designs(fingers).size(), (std::size_t{2} << fingers) - 1) << fingers;
  }
}

}  // namespace
}  // namespace reeve
