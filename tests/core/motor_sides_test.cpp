#include "core/motor_sides.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/notation.hpp"

namespace reeve {
namespace {

// "a-T1 b-T4"
std::string sides_of(const std::string& word) {
  const Network network = expand(parse_routing(word));
  std::string text;
  for (const MotorSide& side : motor_sides(network)) {
    text += (text.empty() ? "" : " ") + segment_name(network.segments[side.motor_side]) + "-" +
            segment_name(network.segments[side.hand]);
  }
  return text;
}

TEST(MotorSides, AreBesideTheSegmentBehindTheirSheath) {
  const std::map<std::string, std::string> sides{{"M-1-T-2-F", "a-T1"},
                                                 {"M-1-T-2-M", "a-T1 b-T4"},
                                                 {"F-1-P-2-F", "a-T2 b-T3"},
                                                 {"M-1-P-2-M", "a-T1 b-T2 c-T3 d-T4"},
                                                 {"1-T-2-P-1", "a-T4 b-T1"},
                                                 {"1-P-2-P-1", "a-T2 b-T3 c-T4 d-T1"},
                                                 {"M-F", "a-h1"},
                                                 {"M-1-F+M-2-F", "a-T1 b-T3"}};
  for (const auto& [word, expected] : sides) EXPECT_EQ(sides_of(word), expected) << word;
}

TEST(MotorSides, AreFoundByTheirStrand) {
  const Network network = expand(parse_routing("1-T-2-P-1"));
  EXPECT_EQ(segment_name(*motor_side_at(network, *segment_named("T1"))), "b");
  EXPECT_FALSE(motor_side_at(network, *segment_named("T2")));
}

}  // namespace
}  // namespace reeve
