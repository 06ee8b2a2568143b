#include "core/routing.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"

namespace reeve {
namespace {

TEST(Routing, CountsTheFingersOfAllTendons) {
  EXPECT_EQ(finger_count(parse_routing("M-1-T-2-F+3-P-3+M-F")), 3);
  EXPECT_EQ(finger_count(parse_routing("M-1-T-2-F+3-P-3").tendons[0]), 2);
  EXPECT_EQ(finger_count(parse_routing("M-F")), 0);
}

TEST(Routing, IsActuatedByAnMOrAP) {
  for (const char* word : {"M-1-F", "F-1-M", "F-1-P-2-F", "1-P-1", "M-F"}) {
    EXPECT_TRUE(is_actuated(parse_routing(word))) << word;
  }
  for (const char* word : {"F-1-F", "1-T-1", "F-1-B-2-F", "F-F"}) {
    EXPECT_FALSE(is_actuated(parse_routing(word))) << word;
  }
}

TEST(Routing, IsActuatedOnlyIfEveryTendonIs) {
  EXPECT_FALSE(is_actuated(parse_routing("M-1-F+F-2-F")));
  EXPECT_FALSE(is_actuated(parse_routing("2-T-2+M-1-F")));
  EXPECT_TRUE(is_actuated(parse_routing("2-P-2+M-1-F")));
}

TEST(Routing, ATreeIsActuatedByAnyOfItsTendons) {
  EXPECT_TRUE(is_actuated(parse_routing("M-Y1+1x-Y1-2x")));
  EXPECT_TRUE(is_actuated(parse_routing("F-1-Y1+M-2-Y1-F")));
  EXPECT_FALSE(is_actuated(parse_routing("F-Y1+1x-Y1-2x")));
  EXPECT_FALSE(is_actuated(parse_routing("M-Y1+1x-Y1-2x+F-Y2+3x-Y2-4x")));
}

TEST(Routing, CountsBlocksAndBarsAndTheFingersThatAreTied) {
  const Routing routing = parse_routing("1x-W1-2x+3x-W2-4x+W1-Y1-W2+Y1-M");
  EXPECT_EQ(block_count(routing).blocks, 1);
  EXPECT_EQ(block_count(routing).bars, 2);
  EXPECT_EQ(finger_count(routing), 4);
}

TEST(Routing, PartsOnTheCarriageAreMAndP) {
  EXPECT_TRUE(is_on_carriage(TokenKind::motor_end));
  EXPECT_TRUE(is_on_carriage(TokenKind::movable_pulley));
  for (const TokenKind kind :
       {TokenKind::fixed_end, TokenKind::finger, TokenKind::tube_join, TokenKind::bearing_join}) {
    EXPECT_FALSE(is_on_carriage(kind));
  }
}

TEST(Routing, EveryTokenIsAnEndAFingerOrAJoin) {
  EXPECT_TRUE(is_end(TokenKind::motor_end) && is_end(TokenKind::fixed_end));
  EXPECT_FALSE(is_end(TokenKind::finger) || is_join(TokenKind::finger));
  for (const TokenKind kind :
       {TokenKind::tube_join, TokenKind::bearing_join, TokenKind::movable_pulley}) {
    EXPECT_TRUE(is_join(kind) && !is_end(kind));
  }
  EXPECT_FALSE(is_join(TokenKind::motor_end) || is_join(TokenKind::fixed_end));
}

}  // namespace
}  // namespace reeve
