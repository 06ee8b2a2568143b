#include "sizing/size_space.hpp"

#include <gtest/gtest.h>

#include "core/hand.hpp"
#include "core/notation.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

std::string names(const std::string& word, SizedQuantity quantity, const Hardware& hardware = {}) {
  std::string list;
  for (const PlacedDimension& placed :
       dimensions_of(expand(parse_routing(word)), hardware, quantity)) {
    list += (list.empty() ? "" : " ") + to_text(placed.dimension);
  }
  return list;
}

SizeSpace space_of(const std::string& word, const std::vector<std::string>& vary,
                   const std::vector<std::string>& equal = {}, const Hardware& hardware = {}) {
  std::vector<VariedRange> ranges;
  for (const std::string& text : vary) ranges.push_back(parse_varied(text));
  std::vector<EqualGroup> groups;
  for (const std::string& text : equal) {
    for (const EqualGroup& group : parse_equal(text)) groups.push_back(group);
  }
  require_ranges_to_match({parse_routing(word)}, hardware, ranges, groups);
  return size_space(expand(parse_routing(word)), hardware, ranges, groups);
}

std::string variables(const SizeSpace& space) {
  std::string list;
  for (const SizeVariable& variable : space.variables) {
    list += (list.empty() ? "" : " ") + variable.name;
  }
  return list;
}

std::string error_of(const std::string& word, const std::vector<std::string>& vary,
                     const std::vector<std::string>& equal = {}) {
  try {
    space_of(word, vary, equal);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Dimensions, AreThoseThatARoutingHas) {
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::sheath_angle), "sheath_angle[1]");
  EXPECT_EQ(names("1-P-2-P-1", SizedQuantity::sheath_angle), "sheath_angle[1] sheath_angle[2]");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::tip_angle), "tip_angle[1] tip_angle[2]");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::contact_angle),
            "contact_angle[a-T1] contact_angle[T1-T2] contact_angle[T2-T3] contact_angle[T3-T4]");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::hand_mm), "");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::motor_side_mm), "motor_side_mm");
  EXPECT_EQ(names("1x-P-2x", SizedQuantity::tip_angle), "");
}

TEST(Dimensions, OfASheathThatLeadsToNoFingerAreThatOfItsContact) {
  EXPECT_EQ(names("M-Y1+1x-Y1-2x", SizedQuantity::sheath_angle), "contact_angle[a-h1]");
}

// Two joints for all, and a thumb of its own.
Hardware with_joints() {
  Hardware hardware;
  hardware.finger_parts = {{{10, 80, 82}, {8, 90, 44}}, 5};
  hardware.fingers.push_back({1, {}, {}, {}, {}, {}, 1, {{{12, 60, 58}}, 10}});
  return hardware;
}

TEST(Dimensions, OfAHandAreItsArms) {
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::arm_mm), "");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::arm_mm, with_joints()), "arm_mm[1] arm_mm[2]");
  EXPECT_EQ(names("M-1-T-2-F", SizedQuantity::closing, with_joints()), "");
  const auto arms =
      dimensions_of(expand(parse_routing("M-1-T-2-F")), with_joints(), SizedQuantity::arm_mm);
  EXPECT_EQ(arms.at(0).nominal, 12);
  EXPECT_EQ(arms.at(1).nominal, 10);
}

TEST(Dimensions, OfAnArmKeepTheRatiosOfTheFingersJoints) {
  Hardware hardware = with_joints();
  set(hardware, {SizedQuantity::arm_mm, 2, {}, {}}, 15);
  const FingerParts parts = finger_parts(hardware, 2);
  ASSERT_EQ(parts.joints.size(), 2U);
  EXPECT_EQ(parts.joints[0].arm_mm, 15);
  EXPECT_EQ(parts.joints[1].arm_mm, 12);
  EXPECT_EQ(parts.joints[1].range_deg, 90);
  EXPECT_EQ(parts.force_N, 5);
  EXPECT_EQ(finger_parts(hardware, 1), with_joints().fingers[0].parts);
  EXPECT_EQ(finger_parts(hardware, 3), with_joints().finger_parts);
}

TEST(Dimensions, BeginWithWhatTheHardwareSays) {
  Hardware hardware;
  hardware.fingers.push_back({2, {}, 1.5, {}, {}, 80.0, 2});
  hardware.contacts.push_back({"T2", "T1", {}, 2.5});
  const Network network = expand(parse_routing("M-1-T-2b-F"));
  const auto tips = dimensions_of(network, hardware, SizedQuantity::tip_angle);
  ASSERT_EQ(tips.size(), 1U);  // that of finger 1 is its contact's
  EXPECT_EQ(tips[0].dimension.finger, 2);
  EXPECT_EQ(tips[0].nominal, 1.5);
  const auto contacts = dimensions_of(network, hardware, SizedQuantity::contact_angle);
  EXPECT_EQ(contacts.at(1).nominal, 2.5);
  EXPECT_EQ(contacts.at(3).nominal, 1.5);
  EXPECT_EQ(dimensions_of(network, hardware, SizedQuantity::strand_mm).at(1).nominal, 80);
  EXPECT_EQ(dimensions_of(network, hardware, SizedQuantity::closing).at(1).nominal, 2);
  EXPECT_EQ(dimensions_of(network, hardware, SizedQuantity::closing).at(0).nominal, 1);
}

TEST(Dimensions, AreSetWhereTheyAreReadFrom) {
  const Network network = expand(parse_routing("M-1-T-2-T-3-M"));
  for (const QuantityRow& about : quantity_table()) {
    Hardware hardware;
    hardware.fingers.push_back({3, {}, {}, {}, {}, {}, 1});
    double value = 2;
    for (const PlacedDimension& placed : dimensions_of(network, hardware, about.quantity)) {
      set(hardware, placed.dimension, value += 0.25);
    }
    value = 2;
    for (const PlacedDimension& placed : dimensions_of(network, hardware, about.quantity)) {
      EXPECT_EQ(placed.nominal, value += 0.25) << to_text(placed.dimension);
    }
    EXPECT_NO_THROW(validate(hardware));
  }
}

TEST(SizeSpace, HasAVariableForEachDimensionThatIsVaried) {
  const SizeSpace space = space_of("M-1-T-2-M", {"tip_angle=1..4", "sheath_angle[2]= 3 .. 9"});
  EXPECT_EQ(variables(space), "tip_angle[1] tip_angle[2] sheath_angle[2]");
  EXPECT_EQ(space.variables[2].bounds.low, 3);
  EXPECT_EQ(space.variables[2].bounds.high, 9);
}

TEST(SizeSpace, BoundsOfOneDimensionRuleOverThoseOfAll) {
  const SizeSpace space = space_of("M-1-T-2-M", {"tip_angle[2]=2..3", "tip_angle=1..4"});
  EXPECT_EQ(variables(space), "tip_angle[1] tip_angle[2]");
  EXPECT_EQ(space.variables[0].bounds.high, 4);
  EXPECT_EQ(space.variables[1].bounds.high, 3);
}

// It begins with the mean of what they are and stays within the bounds of all.
TEST(SizeSpace, MakesOneVariableOfWhatStaysEqual) {
  Hardware hardware;
  for (int f = 1; f <= 3; ++f) hardware.fingers.push_back({f, {}, 1.0 + f * f, {}, {}, {}, {}});
  const SizeSpace space =
      space_of("M-1-P-2-P-3-M", {"sheath_angle=3..9", "tip_angle=1..4", "tip_angle[3]=2..6"},
               {"tips", "sheath_angle[2,3]"}, hardware);
  EXPECT_DOUBLE_EQ(space.variables[2].nominal, 1 + (1 + 4 + 9) / 3.0);
  EXPECT_EQ(variables(space), "sheath_angle[1] sheath_angle[2,3] tip_angle[1,2,3]");
  EXPECT_EQ(space.variables[2].bounds.low, 2);
  EXPECT_EQ(space.variables[2].bounds.high, 4);
}

TEST(SizeSpace, TakesEqualityAsTransitive) {
  EXPECT_EQ(variables(space_of("M-1-P-2-P-3-M", {"sheath_angle=3..9"},
                               {"sheath_angle[1,2]", "sheath_angle[2,3]"})),
            "sheath_angle[1,2,3]");
}

TEST(SizeSpace, TakesAContactInEitherOrderUnlessTwoJoinItsSegments) {
  EXPECT_EQ(variables(space_of("M-1-T-2-F", {"contact_angle[T3-T2]=1..2"})),
            "contact_angle[T2-T3]");
  EXPECT_EQ(variables(space_of("M-1-T-2-F", {"contact_angle[T2-T1]=1..2"})),
            "contact_angle[T1-T2]");
  EXPECT_EQ(variables(space_of("M-Y1+1-Y1-1", {"contact_angle[T2-T1]=1..2"})),
            "contact_angle[T2-T1]");
  EXPECT_EQ(variables(space_of("M-Y1+1-Y1-1",
                               {"contact_angle[T1-T2]=1..2", "contact_angle[T2-T1]=1..3"})),
            "contact_angle[T1-T2] contact_angle[T2-T1]");
  EXPECT_EQ(error_of("M-1-T-2-F", {"contact_angle[T1-T2]=1..2", "contact_angle[T2-T1]=1..3"}),
            "vary 'contact_angle[T2-T1]=1..3': what vary 'contact_angle[T1-T2]=1..2' varies is "
            "varied again");
}

TEST(SizeSpace, SetsAContactUnderTheNameThatTheHardwareHas) {
  Hardware hardware;
  hardware.contacts = {{"T2", "T1", 0.1, {}}};
  const SizeSpace space = space_of("M-1-F", {"contact_angle[T1-T2]=1..2"}, {}, hardware);
  set(hardware, space.dimensions.at(0).dimension, 1.5);
  ASSERT_EQ(hardware.contacts.size(), 1U);
  EXPECT_EQ(hardware.contacts[0].angle_rad, 1.5);
}

TEST(SizeSpace, IsRefusedWhereNothingCanBeVariedSo) {
  EXPECT_EQ(error_of("M-1-T-2-F", {"sheath_angle[2]=3..9"}),
            "vary 'sheath_angle[2]=3..9': expected dimensions of M-1-T-2-F: sheath_angle[1], "
            "tip_angle[1], tip_angle[2], strand_mm[1], strand_mm[2], closing[1], closing[2], "
            "contact_angle[a-T1], contact_angle[T1-T2], contact_angle[T2-T3], "
            "contact_angle[T3-T4], motor_side_mm");
  EXPECT_EQ(error_of("M-1-T-2-M", {"sheath_angle=3..9", "sheath_angle=3..8"}),
            "vary 'sheath_angle=3..8': what vary 'sheath_angle=3..9' varies is varied again");
  EXPECT_EQ(
      error_of("M-1-T-2-F", {"tip_angle[1]=1..4", "contact_angle[T2-T1]=1..2"}),
      "varied dimension 'tip_angle[1]': expected no contact_angle of the same contacts beside it");
  EXPECT_EQ(error_of("M-1-T-2-F", {"tip_angle=1..4"}, {"sheaths"}),
            "equal 'sheaths': expected dimensions that are varied");
  EXPECT_EQ(error_of("M-1-T-2-F", {"tip_angle[1]=1..2", "tip_angle[2]=3..4"}, {"tips"}),
            "equal 'tips': expected bounds that tip_angle[1,2] have in common");
}

TEST(VariedRange, IsRefusedWithWhatWasExpected) {
  const std::string shape = ": expected a dimension and its bounds, such as sheath_angle[1]=3..9";
  for (const char* text : {"", "tip_angle", "tip_angle=3", "tip_angle=3..", "tip_angle=..3",
                           "tip_angle=1..x", "tip_angle=1..inf", "tip_angle=nan..2"}) {
    EXPECT_EQ(input_error([&] { parse_varied(text); }), "vary '" + std::string(text) + "'" + shape);
  }
  EXPECT_EQ(input_error([&] { parse_varied("tip_angle=4..1"); }),
            "vary 'tip_angle=4..1': tip_angle = 4..1: expected the least and the greatest, from 0 "
            "to 1000 rad");
  EXPECT_EQ(input_error([&] { parse_varied("closing[1]=0..2"); }),
            "vary 'closing[1]=0..2': closing = 0..2: expected the least and the greatest, from "
            "0.001 to 1000");
  for (const char* name :
       {"angle", "tip_angle[", "tip_angle[0]", "tip_angle[1,]", "tip_angle[65]", "tip_angle[1,1]",
        "contact_angle", "contact_angle[T1]", "contact_angle[T1-Q]", "hand_mm[1]", "tip_angle[]"}) {
    const std::string text = std::string(name) + "=1..2";
    const std::string said = input_error([&] { parse_varied(text); });
    EXPECT_TRUE(said.starts_with("vary '" + text + "': dimension '" + name + "': expected "))
        << said;
  }
}

// A comma in brackets parts fingers, another one groups.
TEST(EqualGroups, AreSeparatedByCommasOutsideBrackets) {
  std::vector<std::string> names;
  for (const EqualGroup& group : parse_equal("tips, sheath_angle[2,3],strand_mm[1,2]")) {
    names.push_back(to_text(group.name));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"tip_angle", "sheath_angle[2,3]", "strand_mm[1,2]"}));
}

TEST(EqualGroup, IsRefusedWithWhatWasExpected) {
  for (const char* text : {"", "fingers", "tips,", "sheath_angle[2", "tips;sheaths"}) {
    EXPECT_EQ(input_error([&] { parse_equal(text); }),
              "equal '" + std::string(text) +
                  "': expected tips, sheaths, strands, or dimensions of one quantity such as "
                  "sheath_angle[2,3,4]");
  }
}

}  // namespace
}  // namespace reeve::testing
