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
  return search::impossible_contacts(hardware, options);
}

ContactHardware contact(const std::string& a, const std::string& b) { return {a, b, 0.1, {}}; }

TEST(ImpossibleContacts, AreThoseOfNoRouting) {
  EXPECT_TRUE(
      impossible({contact("a", "T1"), contact("T3", "T2"), contact("b", "a")}, 2, full_parts())
          .empty());
  EXPECT_EQ(impossible({contact("a", "T1"), contact("h1", "h7")}, 2, all_parts()),
            std::vector<std::string>{"h1-h7"});
  EXPECT_EQ(impossible({contact("a", "h1")}, 2, full_parts()), std::vector<std::string>{"a-h1"});
  EXPECT_TRUE(impossible({contact("a", "h1")}, 2, all_parts()).empty());
}

// M-5 beside F-1-T-2-T-3-T-4-F, which hangs on no motor.
TEST(ImpossibleContacts, AreAlsoThoseOfRoutingsThatAreNotActuated) {
  EXPECT_EQ(impossible({contact("a", "T9")}, 5, full_parts()), std::vector<std::string>{"a-T9"});
}

// Too many to look at: what cannot touch in any routing, whatever the parts.
TEST(ImpossibleContacts, OfLargeEnumerationsAreThoseThatCannotTouch) {
  EXPECT_EQ(
      impossible({contact("h1", "h7"), contact("a", "c"), contact("m", "T14")}, 8, all_parts()),
      (std::vector<std::string>{"h1-h7", "a-c"}));
  EXPECT_EQ(impossible({contact("h1", "T3")}, 8, full_parts()), std::vector<std::string>{"h1-T3"});
}

}  // namespace
}  // namespace reeve
