// The first line of what is shown of a routing, and the title of its drawing.
#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"
#include "reports/show_report.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

ShownRouting shown_as(const std::string& name, bool by_word) {
  ShownRouting shown =
      shown_routing(parse_routing("1x-M"), {}, single_grasps(1), Direction::pull, {});
  shown.name = name;
  shown.by_word = by_word;
  return shown;
}

std::string heading_of(const ShownRouting& shown) {
  return show_document(shown).sections[0].lines[0].text;
}

TEST(ShowHeading, IsTheNameThatWasGiven) {
  EXPECT_EQ(heading_of(shown_as("BowdenKnee", false)), "BowdenKnee  1x-M  (canonical M-1x)");
  EXPECT_TRUE(testing::has(show_svg(shown_as("BowdenKnee", false), nullptr), ">BowdenKnee: 1x-M<"));
}

TEST(ShowHeading, IsTheWordThatWasGivenThoughTheCatalogueHasANameForIt) {
  EXPECT_EQ(heading_of(shown_as("BowdenKnee", true)),
            "1x-M  (canonical M-1x; routing of BowdenKnee)");
  EXPECT_EQ(heading_of(shown_as("", true)), "1x-M  (canonical M-1x)");
  EXPECT_FALSE(testing::has(show_svg(shown_as("BowdenKnee", true), nullptr), "BowdenKnee"));
}

}  // namespace
}  // namespace reeve
