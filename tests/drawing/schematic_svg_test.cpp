#include "drawing/schematic/schematic_svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "drawing/svg.hpp"
#include "numerics/random.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/svg.hpp"

namespace reeve {
namespace {

using testing::count;
using testing::expect_well_formed;

// The stroke widths of the segments, by name.
std::map<std::string, double> widths(const std::string& svg) {
  static const std::regex segment(
      R"re(data-segment="([a-zA-Z0-9]+)" stroke="[^"]*" stroke-width="([0-9.]+)")re");
  std::map<std::string, double> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), segment), end; at != end; ++at) {
    found[at->str(1)] = std::stod(at->str(2));
  }
  return found;
}

struct Drawn {
  Network network;
  TensionState state;
  std::string svg;

  explicit Drawn(const std::string& word, Grasp grasp = {}, Direction direction = Direction::pull)
      : network(expand(parse_routing(word))),
        state(tensions(network, mechanics(network, Hardware{}), grasp, direction)) {
    const GraspView view{grasp, direction, state};
    svg = schematic_svg(schematic(network, word, view));
  }
};

TEST(SchematicSvg, DrawsEverySegmentOnceAndAnArrowWhereItSlides) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const testing::Trial trial = testing::random_trial(seed, {1, 7, true, true});
    SCOPED_TRACE(to_text(trial));
    const Drawn drawn(to_word(trial.routing), trial.grasp, trial.direction);
    expect_well_formed(drawn.svg);
    for (const Segment& segment : drawn.network.segments) {
      EXPECT_EQ(count(drawn.svg, "data-segment=\"" + segment_name(segment) + "\""), 1U)
          << segment_name(segment);
      EXPECT_EQ(count(drawn.svg, ">" + segment_name(segment) + "</tspan>"), 1U)
          << segment_name(segment);
    }
    const auto sliding = static_cast<std::size_t>(std::count_if(
        drawn.state.slip.begin(), drawn.state.slip.end(), [](double s) { return s != 0; }));
    EXPECT_EQ(count(drawn.svg, "class=\"reeve-slides\""), sliding);
  }
}

TEST(SchematicSvg, DrawsMoreTensionAsAWiderLine) {
  for (const Direction direction : {Direction::pull, Direction::release}) {
    const Drawn drawn("M-1-P-2-F+M-3-T-4-M", hold({3}), direction);
    const std::map<std::string, double> width = widths(drawn.svg);
    ASSERT_EQ(width.size(), drawn.network.segments.size());
    for (std::size_t i = 0; i < drawn.network.segments.size(); ++i) {
      for (std::size_t k = 0; k < drawn.network.segments.size(); ++k) {
        const double one = width.at(segment_name(drawn.network.segments[i]));
        const double other = width.at(segment_name(drawn.network.segments[k]));
        if (drawn.state.tension[i] > drawn.state.tension[k]) {
          EXPECT_GE(one, other);
        }
      }
      EXPECT_GT(width.at(segment_name(drawn.network.segments[i])), 1);
      EXPECT_LE(width.at(segment_name(drawn.network.segments[i])), 7);
    }
  }
}

TEST(SchematicSvg, DashesASlackTendonAndSaysThatTheOtherJams) {
  const Drawn drawn("M-1-F+M-2-F", hold({1}));
  EXPECT_EQ(count(drawn.svg, "stroke-dasharray"), 3U + 1U);  // b, T3, T4, and the legend
  EXPECT_NE(drawn.svg.find("jams: the carriage"), std::string::npos);
}

TEST(SchematicSvg, MarksHeldFingersInWordsAndShape) {
  const Drawn drawn("1-P-2-P-3-P-1", hold({1, 3}));
  EXPECT_EQ(count(drawn.svg, ">held</text>"), 2U);
  EXPECT_EQ(count(drawn.svg, "class=\"reeve-object\""), 2U);
  EXPECT_NE(drawn.svg.find("fingers 1, 3 held"), std::string::npos);
}

TEST(SchematicSvg, WithoutAStateShowsThePartsAlone) {
  const Network network = expand(parse_routing("M-1-P-2-F"));
  const std::string svg = schematic_svg(schematic(network, "TR4"));
  expect_well_formed(svg);
  EXPECT_EQ(count(svg, "reeve-slides"), 0U);
  EXPECT_EQ(count(svg, ">slides<"), 0U);
  EXPECT_EQ(count(svg, ">1.00<"), 0U);
  std::set<double> distinct;
  for (const auto& [name, width] : widths(svg)) distinct.insert(width);
  EXPECT_EQ(distinct.size(), 1U);
}

TEST(SchematicSvg, EscapesNamesThatUsersGive) {
  const Network network = expand(parse_routing("M-1-F"));
  const std::string svg = schematic_svg(schematic(network, "<b>&\"'\x01 glove"), "a\"b");
  expect_well_formed(svg);
  EXPECT_NE(svg.find("&lt;b&gt;&amp;&quot;&#39;  glove"), std::string::npos);
  EXPECT_NE(svg.find("id=\"a&quot;b-title\""), std::string::npos);
}

TEST(SchematicSvg, NamesItselfToAScreenReader) {
  const Drawn drawn("M-1-T-2-F", hold({1}));
  EXPECT_NE(drawn.svg.find("role=\"img\" aria-labelledby=\"schematic-title schematic-desc\""),
            std::string::npos);
  EXPECT_NE(drawn.svg.find("<title id=\"schematic-title\">M-1-T-2-F</title>"), std::string::npos);
  EXPECT_NE(drawn.svg.find("Tensions: a 1.000 T1 0.323"), std::string::npos);
}

TEST(SchematicSvg, BeginsEveryIdentifierWithThePrefix) {
  const Network network = expand(parse_routing("M-1-T-2-F"));
  const std::string svg = schematic_svg(schematic(network, "TR1"), "tr1");
  EXPECT_EQ(count(svg, " id=\""), count(svg, " id=\"tr1-"));
  EXPECT_EQ(count(svg, "url(#"), 0U);
}

TEST(SchematicSheet, HoldsAllOverOneLegend) {
  const Network one = expand(parse_routing("M-1-T-2-F"));
  const Network other = expand(parse_routing("1-P-2-P-1"));
  const std::string svg =
      schematic_sheet({schematic(one, "one", false), schematic(other, "other", false),
                       schematic(one, "third", false)},
                      2, "three");
  expect_well_formed(svg);
  EXPECT_EQ(count(svg, "<svg "), 1U);
  EXPECT_EQ(count(svg, "aria-label=\""), 3U);
  EXPECT_EQ(count(svg, ">sheath</text>"), 1U);
}

TEST(SvgNumber, RoundsToTheNearestHundredth) {
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    const double value = 1000 * normal(seed, 1, 0) * std::pow(10, -4 * uniform(seed, 1, 1));
    const std::string text = svg::number(value);
    EXPECT_NEAR(std::stod(text), value, 0.005000001) << text;
    const std::size_t point = text.find('.');
    EXPECT_TRUE(point == std::string::npos || (text.size() - point <= 3 && text.back() != '0'))
        << text;
  }
}

TEST(SvgNumber, IsShortAndNeverMinusZero) {
  EXPECT_EQ(svg::number(12), "12");
  EXPECT_EQ(svg::number(0.126), "0.13");
  EXPECT_EQ(svg::number(2.5), "2.5");
  EXPECT_EQ(svg::number(-0.001), "0");
  EXPECT_EQ(svg::number(100), "100");
  EXPECT_EQ(svg::number(0.07), "0.07");
  EXPECT_EQ(svg::number(-1234567.5), "-1234567.5");
  EXPECT_EQ(svg::number(1e20), "100000000000000000000");
}

}  // namespace
}  // namespace reeve
