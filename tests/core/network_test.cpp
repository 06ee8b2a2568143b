#include "core/network.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"

namespace reeve {
namespace {

// "a |sheath 1| T1 |tip 1 tube| T2"; behind a loop's last contact stands its first segment again.
std::string to_text(const Contact& contact) {
  const std::string finger = contact.finger == 0 ? "" : " " + std::to_string(contact.finger);
  const std::string kind = std::string(" ") + contact_kind_name(contact.kind);
  switch (contact.place) {
    case ContactPlace::tip:
      return " |tip" + finger + kind + "| ";
    case ContactPlace::hand_join:
      return " |join" + finger + kind + "| ";
    case ContactPlace::carriage:
      return " |pulley" + finger + kind + "| ";
    case ContactPlace::sheath:
      return " |sheath" + finger + (contact.kind == ContactKind::sheath ? "" : kind) + "| ";
    case ContactPlace::block:
      return " |" + std::string(contact_kind_name(contact.kind)) + " #" +
             std::to_string(contact.block) + "| ";
  }
  return "";
}

std::string to_text(const TendonEnd& end) {
  if (end.tie == EndTie::none) return "";
  return (end.tie == EndTie::tail ? "tail #" : "becket #") + std::to_string(end.block) + " ";
}

std::string to_text(const Network& network, const TendonSpan& tendon) {
  std::string text = to_text(tendon.left) + segment_name(network.segments[tendon.first_segment]);
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    text += to_text(network.contacts[tendon.first_contact + k]);
    text += segment_name(network.segments[ends_of(tendon, k).right]);
  }
  const std::string right = to_text(tendon.right);
  if (!right.empty()) text += " " + right.substr(0, right.size() - 1);
  return text;
}

std::string expanded(const std::string& word) {
  const Network network = expand(parse_routing(word));
  std::string text;
  for (const TendonSpan& tendon : network.tendons) {
    text += (text.empty() ? "" : " + ") + to_text(network, tendon);
  }
  return text;
}

TEST(Network, TiesTendonsToBlocksAndTheirPassesToTheirSheaves) {
  EXPECT_EQ(expanded("M-Y1+1x-Y1-2x"), "a |sheath| h1 tail #0 + T1 |block #0| T3");
  EXPECT_EQ(
      expanded("M-B-Y1-B-Y1k+Y1-1x"),
      "a |sheath| h1 |join bearing| h2 |block #0| h3 |join bearing| h4 becket #0 + tail #0 T1");
  EXPECT_EQ(
      expanded("M-1-Y1+2-Y1-3-T-2"),
      "a |sheath 1| T1 |tip 1 tube| T2 tail #0 + T4 |block #0| T5 |tip 3 tube| T6 |join tube| "
      "T3 |tip 2 tube| T4");
}

TEST(Network, NumbersBarsBehindBlocks) {
  const std::string word = "1x-W1-2x+3x-W2/2:1-4x+W1-Y1-W2+Y1-M";
  EXPECT_EQ(
      expanded(word),
      "T1 |bar #1| T3 + T5 |bar #2| T7 + tail #1 h1 |block #0| h2 tail #2 + tail #0 h3 |sheath| a");
  const Network network = expand(parse_routing(word));
  std::vector<std::string> names;
  for (const Block& block : network.blocks) names.push_back(block_name(block));
  EXPECT_EQ(names, (std::vector<std::string>{"Y1", "W1", "W2"}));
  EXPECT_EQ(network.blocks[1].arms, (ArmRatio{1, 1}));
  EXPECT_EQ(network.blocks[2].arms, (ArmRatio{2, 1}));
}

TEST(Network, HasTheBlocksThatAreNamed) {
  const Network network = expand(parse_routing("M-Y7+W2-Y7-1x+2x-W2-3x"));
  ASSERT_EQ(network.blocks.size(), 2U);
  EXPECT_EQ(block_name(network.blocks[0]), "Y7");
  EXPECT_EQ(block_name(network.blocks[1]), "W2");
  EXPECT_EQ(block_count(parse_routing("M-Y7+W2-Y7-1x+2x-W2-3x")).blocks, 1);
}

TEST(Network, TendonsThatBlocksTieTogetherShareATree) {
  const Network network = expand(parse_routing("M-Y1+M-F+1x-Y1-Y2+3x-Y3-F+2x-Y2-F+M-Y3"));
  std::vector<std::size_t> trees;
  for (const TendonSpan& tendon : network.tendons) trees.push_back(tendon.tree);
  EXPECT_EQ(trees, (std::vector<std::size_t>{0, 1, 0, 3, 0, 3}));
  EXPECT_FALSE(is_tied(network, network.tendons[1]));
  EXPECT_TRUE(is_tied(network, network.tendons[3]));
}

TEST(Network, FollowsTheTendonOfEachPublishedRouting) {
  EXPECT_EQ(expanded("M-1-T-2-F"),
            "a |sheath 1| T1 |tip 1 tube| T2 |join tube| T3 |tip 2 tube| T4");
  EXPECT_EQ(expanded("M-1-T-2-M"),
            "a |sheath 1| T1 |tip 1 tube| T2 |join tube| T3 |tip 2 tube| T4 |sheath 2| b");
  EXPECT_EQ(expanded("F-1-P-2-F"),
            "T1 |tip 1 tube| T2 |sheath 1| a |pulley bearing| b |sheath 2| T3 |tip 2 tube| T4");
  EXPECT_EQ(expanded("M-1-P-2-F"),
            "a |sheath 1| T1 |tip 1 tube| T2 |sheath 1| b |pulley bearing| c |sheath 2| T3 "
            "|tip 2 tube| T4");
  EXPECT_EQ(expanded("M-1-P-2-M"),
            "a |sheath 1| T1 |tip 1 tube| T2 |sheath 1| b |pulley bearing| c |sheath 2| T3 "
            "|tip 2 tube| T4 |sheath 2| d");
  EXPECT_EQ(expanded("1-T-2-P-1"),
            "T2 |join tube| T3 |tip 2 tube| T4 |sheath 2| a |pulley bearing| b |sheath 1| T1 "
            "|tip 1 tube| T2");
  EXPECT_EQ(expanded("1-P-2-P-1"),
            "T2 |sheath 1| a |pulley bearing| b |sheath 2| T3 |tip 2 tube| T4 |sheath 2| c "
            "|pulley bearing| d |sheath 1| T1 |tip 1 tube| T2");
}

TEST(Network, TestBenchesAreRoutingsToo) {
  EXPECT_EQ(expanded("M-F"), "a |sheath| h1");
  EXPECT_EQ(expanded("M-T-F"), "a |sheath| h1 |join tube| h2");
  EXPECT_EQ(expanded("M-B-F"), "a |sheath| h1 |join bearing| h2");
  EXPECT_EQ(expanded("M-P-F"), "a |sheath| h1 |sheath| b |pulley bearing| c |sheath| h2");
  EXPECT_EQ(expanded("M-M"), "a |sheath| h1 |sheath| b");
}

TEST(Network, AStretchBetweenTwoJoinsIsAStretchAtTheHand) {
  EXPECT_EQ(expanded("F-T-1-T-B-2b-M"),
            "h1 |join tube| T1 |tip 1 tube| T2 |join tube| h2 |join bearing| T3 |tip 2 bearing| T4 "
            "|sheath 2| a");
}

TEST(Network, ALoopOfOneFingerClosesOnItself) {
  EXPECT_EQ(expanded("1-T-1"), "T2 |join tube| T1 |tip 1 tube| T2");
  EXPECT_EQ(expanded("1b-P-1b"),
            "T2 |sheath 1| a |pulley bearing| b |sheath 1| T1 |tip 1 bearing| T2");
}

TEST(Network, CountsMotorSidesAndHandStretchesOverAllTendons) {
  EXPECT_EQ(expanded("2-P-2+M-T-1-F+M-F"),
            "T4 |sheath 2| a |pulley bearing| b |sheath 2| T3 |tip 2 tube| T4 + "
            "c |sheath| h1 |join tube| T1 |tip 1 tube| T2 + d |sheath| h2");
}

TEST(Network, AFixedEndTouchesNothing) {
  EXPECT_EQ(expanded("F-F"), "h1");
  EXPECT_EQ(expanded("F-1-F"), "T1 |tip 1 tube| T2");
}

TEST(Network, SpansOfTendonsTileTheArrays) {
  const Network network = expand(parse_routing("M-1-F+2-P-2"));
  ASSERT_EQ(network.tendons.size(), 2U);
  EXPECT_EQ(network.tendons[0].segments, 3U);
  EXPECT_EQ(network.tendons[0].contacts, 2U);
  EXPECT_FALSE(network.tendons[0].closed);
  EXPECT_EQ(network.tendons[1].first_segment, 3U);
  EXPECT_EQ(network.tendons[1].first_contact, 2U);
  EXPECT_EQ(network.tendons[1].segments, 4U);
  EXPECT_EQ(network.tendons[1].contacts, 4U);
  EXPECT_TRUE(network.tendons[1].closed);
  EXPECT_EQ(network.fingers, 2);
}

TEST(Network, TheLastContactOfALoopLeadsBackToItsFirstSegment) {
  const TendonSpan loop{10, 4, 20, 4, true};
  EXPECT_EQ(ends_of(loop, 0).left, 10U);
  EXPECT_EQ(ends_of(loop, 0).right, 11U);
  EXPECT_EQ(ends_of(loop, 3).left, 13U);
  EXPECT_EQ(ends_of(loop, 3).right, 10U);
}

TEST(Network, RebuildingForgetsTheRoutingBefore) {
  Network network = expand(parse_routing("1-P-2-P-1+M-3-F"));
  expand(parse_routing("M-1-F"), network);
  EXPECT_EQ(network.segments.size(), 3U);
  EXPECT_EQ(network.contacts.size(), 2U);
  EXPECT_EQ(network.tendons.size(), 1U);
  EXPECT_EQ(network.fingers, 1);
  EXPECT_EQ(segment_name(network.segments[0]), "a");
}

TEST(Network, LettersGoOnAfterZ) {
  EXPECT_EQ(segment_name(Segment{SegmentKind::motor_side, 26, 0}), "z");
  EXPECT_EQ(segment_name(Segment{SegmentKind::motor_side, 27, 0}), "aa");
  EXPECT_EQ(segment_name(Segment{SegmentKind::motor_side, 52, 0}), "az");
  EXPECT_EQ(segment_name(Segment{SegmentKind::motor_side, 702, 0}), "zz");
  EXPECT_EQ(segment_name(Segment{SegmentKind::motor_side, 703, 0}), "aaa");
}

TEST(Network, NamesOfStrandsAndHandStretches) {
  EXPECT_EQ(segment_name(Segment{SegmentKind::strand, 4, 2}), "T4");
  EXPECT_EQ(segment_name(Segment{SegmentKind::hand, 12, 0}), "h12");
}

TEST(Network, HasSegmentsByNameOrNone) {
  for (const std::string text : {"T1", "T12", "a", "ab", "h1"}) {
    ASSERT_TRUE(segment_named(text)) << text;
    EXPECT_EQ(segment_name(*segment_named(text)), text);
  }
  for (const std::string text : {"", "T", "T0", "T01", "T123456", "A", "h0", "t1", "a1"}) {
    EXPECT_FALSE(segment_named(text)) << text;
  }
}

}  // namespace
}  // namespace reeve
