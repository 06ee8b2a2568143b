// Schematics with floating blocks, bars, beckets and anchored tips.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "tests/support/drawn_geometry.hpp"
#include "tests/support/drawn_lines.hpp"
#include "tests/support/random_rigging.hpp"
#include "tests/support/svg.hpp"

namespace reeve {
namespace {

using testing::count;
using testing::crossings;
using testing::expect_sound;

// Differentials and tackles of hands in print.
const std::vector<std::string> in_print{"M-Y1+1x-Y1-2x",
                                        "1x-P-2x",
                                        "M-Y1+F-1-Y1-2-F",
                                        "M-Y1+F-1b-Y1-2b-F",
                                        "M-B-Y1-B-Y1k+Y1-1x",
                                        "M-B-Y1-B-Y1-B-Y1k+Y1-1x",
                                        "M-Y1-B-Y1-B-Y1-B-Y1k+Y1-1x",
                                        "1x-W1-2x+3x-W2-4x+W1-W3-W2+W3-M+5x-M",
                                        "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x",
                                        "1x-W1-2x+3x-W2-4x+W1-Y1-W2+Y1-M+5x-M",
                                        "M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x",
                                        "M-Y2-B-Y1k+Y2-Y1-F+Y1-1x",
                                        "M-Y1+1x-W1/2:1-2x+W1-Y1-3x",
                                        "1-Y1-1+2-Y1-2+Y1-M"};

SchematicLayout drawn(const std::string& word) {
  return layout(expand(parse_routing(word)), {word, "", {}, true, true});
}

TEST(FloatingSchematic, OfPublishedHandsHasNoOverlap) {
  for (const std::string& word : in_print) {
    expect_sound(parse_routing(word), {});
    expect_sound(parse_routing(word), hold({1}));
  }
}

TEST(FloatingSchematic, OfRandomRoutingsHasNoOverlap) {
  for (std::uint64_t seed = 1; seed <= 600 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_rigging(dice);
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(FloatingSchematic, OfManyFingersAndBlocksHasNoOverlap) {
  for (std::uint64_t seed = 1; seed <= 15 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    expect_sound(testing::random_rigging(dice, {9, 6}), {});
  }
}

TEST(FloatingSchematic, OfUnusualPullsHasNoOverlap) {
  for (const char* word :
       {"M-1-Y1+2-Y1-3-T-2", "F-1-Y1+M-2-Y1-F", "M-Y1+M-Y1+1x-Y1-2x", "M-Y1-B-Y1-B-Y1k+Y1-1x",
        "Y1-Y1+1x-Y1-M", "F-1x+2x-M+F-F", "M-B-T-Y1-B-T-Y1k+Y1-T-B-F", "M-Y1k+Y1-Y2k+Y2-F"}) {
    expect_sound(parse_routing(word), {});
  }
}

// Of all of these there is a drawing without crossings, fingers in the order of their numbers.
TEST(FloatingSchematic, OfPublishedHandsHasNoCrossing) {
  for (const std::string& word : in_print) EXPECT_EQ(crossings(drawn(word)), 0U) << word;
}

TEST(FloatingSchematic, CrossesOnceWhereOnceIsTheLeast) {
  EXPECT_EQ(crossings(drawn("M-Y1+1x-Y1-3x+2x-M")), 1U);
  EXPECT_EQ(crossings(drawn("1x-P-3x+2x-P-4x")), 1U);
}

TEST(FloatingSchematic, HangsTheBlocksOfFingersNearestToThem) {
  const SchematicLayout tree = drawn("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x");
  ASSERT_EQ(tree.blocks.size(), 3U);
  const double first = tree.blocks[0].axles.front().y;
  EXPECT_LT(tree.blocks[1].axles.front().y, first);
  EXPECT_EQ(tree.blocks[1].axles.front().y, tree.blocks[2].axles.front().y);
  EXPECT_EQ(tree.blocks[0].apex, 1);
}

// A tackle pulls a finger: its block hangs at the finger, its sheaves side by side below the tail.
TEST(FloatingSchematic, TurnsATackleOver) {
  const SchematicLayout tackle = drawn("M-Y1-B-Y1-B-Y1-B-Y1k+Y1-1x");
  const DrawnBlock& block = tackle.blocks.front();
  EXPECT_EQ(block.apex, -1);
  ASSERT_EQ(block.axles.size(), 3U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(block.axles[i].y, block.axles[0].y);
    EXPECT_GE(block.axles[i].x - block.axles[i - 1].x, 2 * block.sheave);
  }
  EXPECT_LT(block.tails.front().y, block.axles.front().y);
}

// T_left : T_right = a : b at arms b : a.
TEST(FloatingSchematic, DrawsTheArmsOfABarToScale) {
  for (const auto& [word, ratio] :
       {std::pair{"M-W1+1x-W1-2x", 1.0}, std::pair{"M-W1+1x-W1/2:1-2x", 2.0},
        std::pair{"M-W1+1x-W1/3:4-2x", 0.75}, std::pair{"M-W1+1x-W1/1:8-2x", 0.125}}) {
    const SchematicLayout hand = drawn(word);
    const DrawnBlock& bar = hand.blocks.front();
    const double pivot = bar.tails.front().x;
    // The first finger's strand ends at the left arm.
    const double left = std::abs(hand.segments[2].path.back().at.x - pivot);
    const double right = std::abs(hand.segments[3].path.front().at.x - pivot);
    EXPECT_EQ(hand.segments[2].name, "T1");
    EXPECT_NEAR(right / left, ratio, 1e-9) << word;
  }
}

TEST(FloatingSchematic, ShowsTheRatioOfUnequalArmsOnly) {
  const auto has = [](const std::string& word, const std::string& text) {
    const std::vector<DrawnText> texts = drawn(word).texts;
    return std::any_of(texts.begin(), texts.end(),
                       [&](const DrawnText& drawn) { return drawn.text == text; });
  };
  EXPECT_TRUE(has("M-W1+1x-W1-2x", "W1"));
  EXPECT_TRUE(has("M-W1+1x-W1/2:1-2x", "W1 2:1"));
  EXPECT_TRUE(has("M-Y1+1x-Y1-2x", "Y1"));
}

// As they are drawn.
DrawnParts parts_in(const SchematicLayout& layout) {
  DrawnParts parts;
  for (const DrawnContact& contact : layout.contacts) {
    parts.tubes = parts.tubes || contact.kind == ContactKind::tube;
    parts.bearings = parts.bearings || contact.kind == ContactKind::bearing;
    parts.sheaths = parts.sheaths || contact.kind == ContactKind::sheath;
  }
  for (const DrawnEnd& end : layout.ends) {
    parts.fixed = parts.fixed || end.hold == EndHold::fixed;
    parts.tied = parts.tied || end.hold == EndHold::tied;
    parts.anchors = parts.anchors || end.hold == EndHold::anchored;
  }
  for (const DrawnBlock& block : layout.blocks) (block.is_bar ? parts.bars : parts.blocks) = true;
  return parts;
}

TEST(FloatingSchematic, SaysWhichPartsAreDrawn) {
  const auto expect_parts = [](const Routing& routing) {
    const Network network = expand(routing);
    ASSERT_EQ(drawn_parts(network), parts_in(layout(network, {}))) << to_word(routing);
  };
  for (const std::string& word : in_print) expect_parts(parse_routing(word));
  for (const char* word : {"M-1-F", "M-1-M", "1-P-1", "M-1b-P-2b-F", "M-T-F", "F-B-M", "F-1-P-2-F"})
    expect_parts(parse_routing(word));
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    testing::Dice dice(seed);
    expect_parts(testing::random_rigging(dice));
  }
}

TEST(FloatingSchematic, IsTheSameFromPlacesThatGraspsShare) {
  const Network network = expand(parse_routing("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4b-M"));
  const Places shared = places(network);
  for (const Grasp& grasp : {Grasp{}, hold({2}), hold({1, 4})}) {
    const TensionState state = tensions(network, mechanics(network, {}), grasp);
    const GraspView view{grasp, Direction::pull, state};
    EXPECT_EQ(schematic_svg(schematic(network, shared, "shared", view)),
              schematic_svg(schematic(network, "shared", view)));
  }
}

TEST(FloatingSchematic, ExplainsOnlyThePartsThatAreThere) {
  const auto explained = [](const std::string& word) {
    const DrawnParts parts = drawn(word).parts;
    return std::vector<bool>{parts.anchors, parts.blocks, parts.bars};
  };
  EXPECT_EQ(explained("M-1-F"), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(explained("M-1x"), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(explained("M-Y1+F-1-Y1-F"), (std::vector<bool>{false, true, false}));
  EXPECT_EQ(explained("M-W1+1x-W1-2x"), (std::vector<bool>{true, false, true}));
}

std::string legend_of(const std::string& word, bool slack) {
  const SchematicLayout drawn =
      layout(expand(parse_routing(word)), {word, "", {}, true, true, slack});
  std::string names;
  for (const LegendItem& item : drawn.legend.items) {
    constexpr std::array letters{'t', 'b', 's', 'F', 'M', 'x', 'e', 'Y', 'W', '>', '0'};
    names += letters.at(static_cast<std::size_t>(item.symbol));
  }
  return names;
}

TEST(SchematicLegend, ListsWhatIsDrawnAndNothingElse) {
  EXPECT_EQ(legend_of("M-1-F", false), "tsFM>");
  EXPECT_EQ(legend_of("M-1-F", true), "tsFM>0");
  EXPECT_EQ(legend_of("M-1b-M", false), "bsM>");
  EXPECT_EQ(legend_of("1-P-2-P-1", false), "tbs>");
  EXPECT_EQ(legend_of("M-W1+1x-W1-2x", false), "sMxW>");
  EXPECT_EQ(legend_of("M-Y1+1x-Y1-2x", false), "sMxY>");
  EXPECT_EQ(legend_of("M-1x+M2-1e", false), "sMxe>");
}

TEST(FloatingSvg, DrawsEverySegmentOnceAndAnArrowForWhatMoves) {
  std::size_t moving = 0;
  for (std::uint64_t seed = 1; seed <= 800; ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_rigging(dice);
    if (!is_actuated(routing)) continue;
    const Network network = expand(routing);
    const Grasp grasp = testing::random_grasp(dice, network.fingers);
    const Direction direction = dice.chance(0.5) ? Direction::pull : Direction::release;
    TensionState state;
    TensionSolver().solve(network, mechanics(network, Hardware{}), grasp, direction, state);
    if (!state.in_range) continue;
    SCOPED_TRACE(to_word(routing) + ", held " + to_text(grasp));
    const GraspView view{grasp, direction, state};
    const std::string svg = schematic_svg(schematic(network, to_word(routing), view));
    testing::expect_well_formed(svg);
    for (const Segment& segment : network.segments) {
      EXPECT_EQ(count(svg, "data-segment=\"" + segment_name(segment) + "\""), 1U);
    }
    const auto nonzero = [](const std::vector<double>& values) {
      return static_cast<std::size_t>(
          std::count_if(values.begin(), values.end(), [](double v) { return v != 0; }));
    };
    EXPECT_EQ(count(svg, "class=\"reeve-slides\""), nonzero(state.slip));
    EXPECT_EQ(count(svg, "class=\"reeve-moves\""), nonzero(state.block_travel));
    moving += nonzero(state.block_travel);
  }
  EXPECT_GT(moving, 100U);
}

// From top to bottom where a block moves that way.
std::string arrow_of_block(const std::string& word, Grasp grasp, Direction direction) {
  const Network network = expand(parse_routing(word));
  const TensionState state = tensions(network, mechanics(network, Hardware{}), grasp, direction);
  const std::string svg = schematic_svg(schematic(network, word, {grasp, direction, state}));
  const std::size_t at = svg.find("reeve-moves");
  if (at == std::string::npos) return "none";
  double x = 0;
  double from = 0;
  double to = 0;
  std::sscanf(svg.c_str() + svg.find("d=\"M", at), "d=\"M%lf %lfL%*f %lf", &x, &from, &to);
  return from < to ? "down" : "up";
}

TEST(FloatingSvg, PointsWhereTheBlockGoes) {
  EXPECT_EQ(arrow_of_block("M-Y1+1x-Y1-2x", {}, Direction::pull), "down");
  EXPECT_EQ(arrow_of_block("M-Y1+1x-Y1-2x", {}, Direction::release), "up");
  // An inverted one, pulled away from its finger.
  EXPECT_EQ(arrow_of_block("M-B-Y1-B-Y1k+Y1-1x", {}, Direction::pull), "down");
  EXPECT_EQ(arrow_of_block("M-B-Y1-B-Y1k+Y1-1x", {}, Direction::release), "up");
}

}  // namespace
}  // namespace reeve
