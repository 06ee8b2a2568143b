// A hand from end to end: what the commands say of it, alike, and what docs/hand.md prints.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

const std::string hand_file = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
constexpr const char* design_of_the_document = "M-1b-T-2b-B-3b-M";

Json hand_json(Arguments arguments) {
  arguments.insert(arguments.end(), {"--hardware", hand_file, "--format", "json"});
  const ProcessResult result = reeve(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out);
}

// M pulls fingers 1 and 2 of one tendon, which share its two ends; M2 pulls finger 3.
TEST(HandOfTheCommands, SaysWhatEachMotorDoesAlone) {
  const Json hand = hand_json({"show", "M-1-T-2-M+M2-3-F"})["hand"];
  const auto excursion = [&](std::size_t f) { return hand["fingers"][f]["excursion_mm"]; };
  const Json& alone = hand["motors_alone"];
  ASSERT_EQ(alone.size(), 2U);
  EXPECT_EQ(alone[0]["closed"], Json({1, 1, 0}));
  EXPECT_EQ(alone[1]["closed"], Json({0, 0, 1}));
  EXPECT_NEAR(alone[0]["stroke_mm"], excursion(0).get<double>() + excursion(1).get<double>(), 1e-9);
  EXPECT_NEAR(alone[1]["stroke_mm"], 2 * excursion(2).get<double>(), 1e-9);
  EXPECT_FALSE(hand_json({"show", "M-1-T-2-T-3-F"})["hand"].contains("motors_alone"));
}

// The other end of a tendon does not yield.
TEST(HandOfTheCommands, NeedsTwiceTheStrokeOfAMotorAloneOnATendonOfTwo) {
  const Json hand = hand_json({"show", "M-1-T-2-T-3-M2"})["hand"];
  for (const Json& motor : hand["motors_alone"]) {
    EXPECT_EQ(motor["closed"], Json({1, 1, 1}));
    EXPECT_NEAR(motor["stroke_mm"], 2 * hand["stroke"].get<double>(), 1e-9);
  }
}

// The 95 % quantile is over draws that do not hold it.
TEST(HandOfTheCommands, NotesACoefficientThatTheDrawsOfItsForceAreNotAbout) {
  const TemporaryFolder folder;
  const std::string hand =
      "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90, lever_mm = 60 }]\n";
  folder.write("within.toml", hand);
  folder.write("outside.toml", hand + "[sheath]\nmu = 0\n");
  const ProcessOptions there{.directory = folder.path()};
  for (const char* command : {"show M-1x", "rank M-1x", "explore --fingers 1 --parts paper"}) {
    const auto notes = [&](const std::string& file) {
      Arguments arguments(command);
      arguments.insert(arguments.end(), {"--hardware", file});
      return has(reeve(arguments, there).out,
                 "the nominal friction coefficient of sheaths, 0, is outside its range");
    };
    EXPECT_TRUE(notes("outside.toml")) << command;
    EXPECT_FALSE(notes("within.toml")) << command;
  }
}

TEST(HandOfTheCommands, IsTheSameInShowRankAndExplore) {
  const TemporaryFolder folder;
  const Json shown = hand_json({"show", design_of_the_document})["hand"];
  const Json ranked = hand_json({"rank", design_of_the_document})["designs"][0]["hand"];
  const Json explored = Json::parse(reeve({"explore",
                                           "--fingers",
                                           "3",
                                           "--parts",
                                           "full",
                                           "--distinct-fingers",
                                           "--hardware",
                                           hand_file,
                                           "--objectives",
                                           "motor_force,stroke",
                                           "--constraint",
                                           "sheaths<=2",
                                           "--constraint",
                                           "motor_force<=80",
                                           "--constraint",
                                           "stroke<=90",
                                           "--format",
                                           "json",
                                           "--out",
                                           folder.path().string()})
                                        .out);
  EXPECT_EQ(explored["top"][0]["routing"], design_of_the_document);
  for (const char* key : {"motor_force", "fingertip_force", "stroke", "closure", "motor_power"}) {
    EXPECT_EQ(ranked[key], shown[key]) << key;
    EXPECT_EQ(explored["top"][0]["hand"][key], shown[key]) << key;
  }
  EXPECT_NEAR(shown["motor_force"], shown["motor"]["force_N"], 1e-9);
  EXPECT_NEAR(shown["stroke"], shown["motor"]["stroke_mm"], 1e-9);
  EXPECT_NEAR(shown["motor_power"], shown["motor"]["power_W"], 1e-9);
  for (const Json& design : explored["top"]) {
    EXPECT_LE(design["hand"]["motor_force"], 80);
    EXPECT_LE(design["hand"]["stroke"], 90);
  }
}

TEST(HandOfTheCommands, IsThatOfThePullWhateverIsShown) {
  const Json pulling = hand_json({"show", "M-1-T-2-T-3-F"})["hand"];
  EXPECT_EQ(hand_json({"show", "M-1-T-2-T-3-F", "--direction", "release"})["hand"], pulling);
}

TEST(HandOfTheCommands, ThatPressesNothingAsksForNoForceAndNamesNoFinger) {
  const TemporaryFolder folder;
  const std::string idle =
      folder
          .write("idle.toml",
                 "[hand]\nforce_N = 0\njoints = [{ arm_mm = 8, range_deg = 90, lever_mm = 60 }]\n")
          .string();
  const ProcessResult shown = reeve({"show", "TR7", "--hardware", idle});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_TRUE(has(shown.out, "Motor force 0 N: no finger is to press"));
  EXPECT_FALSE(has(shown.out, "sets it, at"));
}

// Each line of the section, in the document behind four spaces.
TEST(HandOfTheDocument, IsWhatTheCommandPrints) {
  const std::string document =
      read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "hand.md");
  const std::string out = reeve({"show", design_of_the_document, "--hardware", hand_file}).out;
  std::istringstream section(out.substr(out.find("held  finger 1")));
  int lines = 0;
  for (std::string line; std::getline(section, line); ++lines) {
    if (line.empty() || line.starts_with("Hand")) continue;
    EXPECT_TRUE(has(document, "    " + line + "\n")) << line;
  }
  EXPECT_GT(lines, 10);
}

}  // namespace
}  // namespace reeve::testing
