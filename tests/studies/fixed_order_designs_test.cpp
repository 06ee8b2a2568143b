#include "studies/fixed_order_designs.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/canonical.hpp"
#include "core/notation.hpp"

namespace reeve {
namespace {

TEST(FixedOrderDesigns, OfTwoFingersAreTheSevenOfThePaper) {
  std::set<std::string> words;
  for (const Routing& routing : fixed_order_designs(2)) {
    words.insert(to_word(canonical(routing, FingerIdentity::identical)));
  }
  EXPECT_EQ(words, (std::set<std::string>{"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F",
                                          "M-1-P-2-M", "1-T-2-P-1", "1-P-2-P-1"}));
}

TEST(FixedOrderDesigns, AreTwoToTheNPlusOneLessOne) {
  for (int fingers = 1; fingers <= 8; ++fingers) {
    EXPECT_EQ(fixed_order_designs(fingers).size(), (std::size_t{2} << fingers) - 1) << fingers;
  }
}

}  // namespace
}  // namespace reeve
