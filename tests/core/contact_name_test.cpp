#include "core/contact_name.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"
#include "tests/core/network_of.hpp"

namespace reeve::testing {
namespace {

using std::numbers::pi;

std::vector<std::string> contact_names(const Network& network) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    names.push_back(contact_name(network, k));
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(ContactName, HasTheSegmentsInTheOrderOfTheWalk) {
  EXPECT_EQ(contact_names(network_of("M-1-T-2-F")), (Names{"a-T1", "T1-T2", "T2-T3", "T3-T4"}));
  EXPECT_EQ(contact_names(network_of("1-T-1")), (Names{"T2-T1", "T1-T2"}));
  EXPECT_EQ(contact_names(network_of("M-Y1+1-Y1-1")), (Names{"a-h1", "T2-T1", "T1-T2"}));
}

TEST(ContactName, FindsItsContact) {
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1", "1-T-1", "M-Y1+1-Y1-1", "M-W1+1-W1-1"}) {
    const Network network = network_of(word);
    for (std::size_t k = 0; k < network.contacts.size(); ++k) {
      EXPECT_EQ(find_contact(network, contact_name(network, k)), k) << word;
    }
  }
}

TEST(ContactName, MayHaveTheOtherOrderWhereOneContactJoinsTheSegments) {
  const Network network = network_of("M-1-T-2-F");
  EXPECT_EQ(find_contact(network, "T1-a"), 0U);
  EXPECT_EQ(find_contact(network, "T2-T1"), 1U);
}

TEST(ContactName, FindsNothingThatIsNotThere) {
  const Network network = network_of("M-1-T-2-F");
  for (const char* name : {"", "-", "T1", "T1-", "T1-T3", "T1-Q", "T1-T2-T3", "T4-b"}) {
    EXPECT_EQ(find_contact(network, name), std::nullopt) << name;
  }
}

TEST(ContactName, MeansTheSameAsAnotherOneInEveryRouting) {
  const auto same = [](const char* a, const char* b) {
    return mean_the_same(*contact_named(a), *contact_named(b));
  };
  EXPECT_TRUE(same("T1-T2", "T1-T2"));
  EXPECT_TRUE(same("T2-T3", "T3-T2"));
  EXPECT_TRUE(same("a-h1", "h1-a"));
  EXPECT_FALSE(same("T1-T2", "T2-T1"));  // the two contacts of 1-T-1
  EXPECT_FALSE(same("T1-T2", "T2-T3"));
}

// Both strands of the finger give up the same length, so that neither contact slides.
TEST(TwoContactLoop, HasTwoCoefficientsAndOneTension) {
  const Network network = network_of("M-Y1+1-Y1-1");
  Hardware hardware;
  hardware.contacts = {{"T1", "T2", 0.3, 2.0}, {"T2", "T1", 0.05, {}}};
  const Mechanics result = mechanics(network, hardware);
  EXPECT_EQ(result.phi, (std::vector<double>{0.18 * 2 * pi, 0.05 * pi, 0.6}));
  EXPECT_EQ(result.decay[1], std::exp(-0.05 * pi));
  EXPECT_EQ(result.decay[2], std::exp(-0.6));
  const TensionState state = tensions(network, result, Grasp{});
  const double strand = std::exp(-0.18 * 2 * pi) / 2;
  for (const char* name : {"T1", "T2"}) {
    const std::size_t segment = *find_segment(network, *segment_named(name));
    EXPECT_NEAR(state.tension[segment], strand, 1e-12) << name;
  }
}

TEST(TwoContactLoop, TakesEachContactByTheOrderOfItsName) {
  const Network network = network_of("1-T-1");
  Hardware hardware;
  hardware.contacts = {{"T1", "T2", 0.3, 1.0}};
  EXPECT_EQ(mechanics(network, hardware).phi, (std::vector<double>{0.18 * pi, 0.3}));
  hardware.contacts = {{"T2", "T1", 0.3, 1.0}};
  EXPECT_EQ(mechanics(network, hardware).phi, (std::vector<double>{0.3, 0.18 * pi}));
  EXPECT_TRUE(MechanicsBuilder(hardware).unmatched_contacts(network).empty());
}

// A hardware file of several routings may have both names.
TEST(BothNamesOfOneContact, LeaveItToTheOneInWalkOrder) {
  const Network network = network_of("M-1-T-2-F");
  Hardware hardware;
  hardware.contacts = {{"T2", "T1", 0.3, 1.0}, {"T1", "T2", 0.2, 1.0}};
  const MechanicsBuilder builder(hardware);
  EXPECT_EQ(mechanics(network, hardware).phi[1], 0.2);
  EXPECT_EQ(builder.unmatched_contacts(network), Names{"T2-T1"});
  EXPECT_TRUE(builder.unmatched_contacts(network_of("1-T-1")).empty());
}

TEST(TwoContactLoop, NamesTheContactWhoseExponentIsOutOfRange) {
  Hardware hardware;
  hardware.contacts = {{"T2", "T1", 9.0, 2.0}};
  try {
    mechanics(network_of("M-Y1+1-Y1-1"), hardware);
    FAIL();
  } catch (const OutOfRange& error) {
    EXPECT_STREQ(error.what(), "hardware: T2-T1: mu * angle = 18: expected at most 10");
  }
}

}  // namespace
}  // namespace reeve::testing
