// Drawings, byte for byte as they stand in expected/.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/golden.hpp"

namespace reeve::testing {
namespace {

// The drawing of the words in the grasp is the file.
void expect_drawing(const std::vector<std::string>& words, const std::filesystem::path& file) {
  const TemporaryFolder folder;
  const std::string drawing = (folder.path() / "drawing.svg").string();
  std::vector<std::string> arguments{"show"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  arguments.insert(arguments.end(), {"--svg", drawing});
  output_of(arguments);
  expect_text(read_text(drawing), file);
}

const auto figures = std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures";

TEST(GoldenSchematic, OfTheSevenInThePapersGrasp) {
  for (const std::string name : {"tr1", "tr2", "tr3", "tr4", "tr5", "tr6", "tr7"}) {
    expect_drawing({name, "--held", "1"}, file_of("schematic_" + name + ".svg"));
  }
}

TEST(GoldenSchematic, OfFiveFingersReleasing) {
  expect_drawing({"M-1b-T-4-B-2-P-5-T-3-F", "--held", "2,3", "--direction", "release"},
                 file_of("schematic_five_fingers.svg"));
}

TEST(GoldenSchematic, OfFloatingBlocksBarsAndAnchoredTips) {
  const std::vector<std::vector<std::string>> drawings{
      {"tree_of_blocks", "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", "1"},
      {"bars", "1x-W1/2:1-2x+3x-W2-4x+W1-Y1-W2+Y1-M+5x-M", "3"},
      {"tackle", "M-Y1-B-Y1-B-Y1-B-Y1k+Y1-1x", "none"},
      {"tackle_on_tackle", "M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x", "none"},
      {"tail_at_a_finger", "M-1-Y1+2-Y1-3-T-2", "2"},
      {"slider", "1x-P-2x", "none"}};
  for (const std::vector<std::string>& drawing : drawings) {
    expect_drawing({drawing[1], "--held", drawing[2]}, file_of("schematic_" + drawing[0] + ".svg"));
  }
}

TEST(GoldenSchematic, OfThePulleyAtTheHandIsTheFigureOfTheDocuments) {
  expect_drawing({"M-Y1+F-1-Y1-2-F", "--held", "1"}, figures / "pulley-at-the-hand.svg");
}

TEST(GoldenSchematic, OfTwoRoutingsIsThePictureOfTheReadme) {
  for (const std::string name : {"tr1", "tr3"}) {
    expect_drawing({name, "--held", "1"}, figures / (name + "-held-1.svg"));
  }
}

// The sheet in docs/schematics.md is what the program draws.
TEST(GoldenSchematic, OfTheCatalogueIsTheSheetOfTheDocuments) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "sheet.svg").string();
  output_of({"check", "--svg", file});
  expect_text(read_text(file), figures / "schematics.svg");
}

}  // namespace
}  // namespace reeve::testing
