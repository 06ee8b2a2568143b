#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "search/enumerate/generator.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve {
namespace {

std::vector<std::string> impossible(const std::vector<ContactHardware>& contacts, int fingers,
                                    const PartSet& parts) {
  Hardware hardware;
  hardware.contacts = contacts;
  GeneratorOptions options;
  options.fingers = fingers;
  options.parts = parts;
  return search::impossible_values(hardware, options);
}

ContactHardware contact(const std::string& a, const std::string& b) { return {a, b, 0.1, {}}; }

TEST(ImpossibleValues, AreThoseOfNoRouting) {
  EXPECT_TRUE(
      impossible({contact("a", "T1"), contact("T3", "T2"), contact("b", "a")}, 2, full_parts())
          .empty());
  EXPECT_EQ(impossible({contact("a", "T1"), contact("h1", "h7")}, 2, all_parts()),
            std::vector<std::string>{"contact.h1-h7"});
  EXPECT_EQ(impossible({contact("a", "h1")}, 2, full_parts()),
            std::vector<std::string>{"contact.a-h1"});
  EXPECT_TRUE(impossible({contact("a", "h1")}, 2, all_parts()).empty());
}

// M-5 beside F-1-T-2-T-3-T-4-F, which hangs on no motor.
TEST(ImpossibleValues, AreAlsoThoseOfRoutingsThatAreNotActuated) {
  EXPECT_EQ(impossible({contact("a", "T9")}, 5, full_parts()),
            std::vector<std::string>{"contact.a-T9"});
}

// Too many to look at: what cannot touch in any routing, whatever the parts.
TEST(ImpossibleValues, OfLargeEnumerationsAreThoseThatCannotTouch) {
  EXPECT_EQ(
      impossible({contact("h1", "h7"), contact("a", "c"), contact("m", "T14")}, 8, all_parts()),
      (std::vector<std::string>{"contact.h1-h7", "contact.a-c"}));
  EXPECT_EQ(impossible({contact("h1", "T3")}, 8, full_parts()),
            std::vector<std::string>{"contact.h1-T3"});
}

// Fingers 1 … of F-1-T-2-T-3-M are numbered along the walk, so that no sheath leads to the middle.
TEST(ImpossibleValues, AreThoseOfFingersThatNoSheathLeadsTo) {
  Hardware hardware;
  hardware.fingers.resize(3);
  for (int f = 0; f < 3; ++f) {
    FingerHardware& finger = hardware.fingers[static_cast<std::size_t>(f)];
    finger.finger = f + 1;
    finger.sheath_mu = 0.1;
    finger.tip_mu = 0.1;
  }
  GeneratorOptions options;
  options.fingers = 3;
  options.parts = paper_parts();
  EXPECT_TRUE(search::impossible_values(hardware, options).empty());
  options.parts.joins = {TokenKind::tube_join};
  options.one_tendon = true;
  EXPECT_EQ(search::impossible_values(hardware, options),
            std::vector<std::string>{"finger.2.sheath_mu"});
  // The file may describe a larger hand.
  hardware.fingers.back().finger = 4;
  options.one_tendon = false;
  EXPECT_TRUE(search::impossible_values(hardware, options).empty());
}

}  // namespace
}  // namespace reeve
