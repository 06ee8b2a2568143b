// The geometry of schematics of random routings: every segment once and from contact to contact,
// nothing over anything else.
#include "drawing/schematic/schematic_layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "drawing/schematic/schematic_measures.hpp"
#include "tests/support/drawn_geometry.hpp"
#include "tests/support/drawn_lines.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::expect_sound;

TEST(SchematicLayout, OfTheSevenHasNoOverlap) {
  for (const char* word : {"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F", "M-1-P-2-M",
                           "1-T-2-P-1", "1-P-2-P-1"}) {
    expect_sound(parse_routing(word), hold({1}));
  }
}

TEST(SchematicLayout, OfRandomRoutingsHasNoOverlap) {
  for (std::uint64_t seed = 1; seed <= 600 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_routing(dice, {1, 5, dice.chance(0.7), true});
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(SchematicLayout, OfSeveralMotorsHasNoOverlap) {
  for (std::uint64_t seed = 1; seed <= 200 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing =
        testing::with_several_motors(dice, testing::random_routing(dice, {1, 5, true, true}));
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(SchematicLayout, DrawsTheCarriageOfEachMotor) {
  const auto motors = [](const std::string& word) {
    std::vector<int> drawn;
    const SchematicLayout all = layout(expand(parse_routing(word)), {"", "", {}, true, true});
    for (const DrawnCarriage& carriage : all.carriages) drawn.push_back(carriage.motor);
    return drawn;
  };
  EXPECT_EQ(motors("M-1-P-2-M"), std::vector<int>{1});
  EXPECT_EQ(motors("1x-M2+2x-M+3x-M3"), (std::vector<int>{2, 1, 3}));
  EXPECT_EQ(motors("M-1-P2-2-M"), (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(motors("F-1-F"), std::vector<int>{});
}

TEST(SchematicLayout, OfLargeHandsHasNoOverlap) {
  for (std::uint64_t seed = 1; seed <= 60 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_routing(dice, {8, 10, true, true});
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(SchematicLayout, KeepsFarJoinsOfManyFingersApart) {
  for (const char* word : {"M-1-T-3-T-2-T-5-T-4-F", "1-T-5-P-2-B-4-T-3-P-1",
                           "M-1b-B-4-T-2-P-5-B-3b-M", "M-F", "F-F", "M-T-M", "M-P-P-F", "1-T-1",
                           "1-P-1", "M-T-B-T-1-B-T-B-F", "M-1-F+M-2-F+M-3-F+M-4-F+M-5-F"}) {
    expect_sound(parse_routing(word), {});
  }
}

// Of five fingers, at 300 pixels across.
TEST(SchematicLayout, IsReadableAtThreeHundredPixels) {
  const SchematicLayout drawn =
      layout(expand(parse_routing("M-1-T-2-T-3-P-4-B-5-F")), {"", "", hold({1}), true, true});
  EXPECT_GE(measures::text_size * 300 / drawn.width, 8);
}

TEST(SchematicLayout, LeavesRoomForEveryNameAndTension) {
  const SchematicLayout drawn =
      layout(expand(parse_routing("M-1-T-2-T-3-P-4-B-5-F")), {"", "", {}, true, true});
  for (const DrawnSegment& segment : drawn.segments) {
    for (const std::string& shown : {segment.name, std::string("0.88"), std::string("<.01")}) {
      EXPECT_LE(measures::text_width(shown, measures::text_size, shown == segment.name),
                segment.label.right - segment.label.left)
          << shown;
    }
  }
}

// Beside the line below a sheath the label has one side, and above it the arrow has the same.
TEST(SchematicLayout, HasTheArrowOfASheathOnTheSideOfTheLabelBelow) {
  for (const char* word : {"M-1-P-2-M", "M-Y1+F-1-Y1-2-F"}) {
    const SchematicLayout drawn = layout(expand(parse_routing(word)), {});
    std::size_t looked_at = 0;
    for (const DrawnContact& sheath : drawn.contacts) {
      if (sheath.place != ContactPlace::sheath) continue;
      for (const DrawnSegment& segment : drawn.segments) {
        const Point end = (sheath.forward ? segment.path.front() : segment.path.back()).at;
        if (!testing::same(end, sheath.centre)) continue;
        EXPECT_EQ(sheath.arrow_side > 0, segment.label.left > end.x) << word << segment.name;
        ++looked_at;
      }
    }
    EXPECT_GT(looked_at, 0U);
  }
}

}  // namespace
}  // namespace reeve
