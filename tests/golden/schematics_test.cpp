// Drawings, byte for byte as they stand in expected/.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/golden.hpp"

namespace reeve::testing {
namespace {

TEST(GoldenSchematic, OfTheSevenInThePapersGrasp) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  for (const char* name : {"tr1", "tr2", "tr3", "tr4", "tr5", "tr6", "tr7"}) {
    output_of({"show", name, "--held", "1", "--svg", file});
    expect_text(read_text(file), file_of(std::string("schematic_") + name + ".svg"));
  }
}

TEST(GoldenSchematic, OfFiveFingersReleasing) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  output_of(
      {"show", "M-1b-T-4-B-2-P-5-T-3-F", "--held", "2,3", "--direction", "release", "--svg", file});
  expect_text(read_text(file), file_of("schematic_five_fingers.svg"));
}

TEST(GoldenSchematic, OfFloatingBlocksBarsAndAnchoredTips) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  const std::vector<std::vector<std::string>> drawings{
      {"tree_of_blocks", "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", "1"},
      {"bars", "1x-W1/2:1-2x+3x-W2-4x+W1-Y1-W2+Y1-M+5x-M", "3"},
      {"tackle", "M-Y1-B-Y1-B-Y1-B-Y1k+Y1-1x", "none"},
      {"tackle_on_tackle", "M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x", "none"},
      {"tail_at_a_finger", "M-1-Y1+2-Y1-3-T-2", "2"},
      {"slider", "1x-P-2x", "none"}};
  for (const std::vector<std::string>& drawing : drawings) {
    output_of({"show", drawing[1], "--held", drawing[2], "--svg", file});
    expect_text(read_text(file), file_of("schematic_" + drawing[0] + ".svg"));
  }
}

TEST(GoldenSchematic, OfThePulleyAtTheHandIsTheFigureOfTheDocuments) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  output_of({"show", "M-Y1+F-1-Y1-2-F", "--held", "1", "--svg", file});
  expect_text(read_text(file), std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" /
                                   "pulley-at-the-hand.svg");
}

TEST(GoldenSchematic, OfTwoRoutingsIsThePictureOfTheReadme) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  for (const char* name : {"tr1", "tr3"}) {
    output_of({"show", name, "--held", "1", "--svg", file});
    expect_text(read_text(file), std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" /
                                     (std::string(name) + "-held-1.svg"));
  }
}

// The sheet in docs/schematics.md is what the program draws.
TEST(GoldenSchematic, OfTheCatalogueIsTheSheetOfTheDocuments) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "sheet.svg").string();
  output_of({"check", "--svg", file});
  expect_text(read_text(file),
              std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" / "schematics.svg");
}

}  // namespace
}  // namespace reeve::testing
