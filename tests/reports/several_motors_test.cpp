// What reports say of routings with several motors.
#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"
#include "reports/jam_words.hpp"
#include "reports/mujoco/mjcf.hpp"
#include "reports/show_report.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

using testing::has;

ShownRouting shown(const std::string& word, const std::string& grasps, const Model& model = {}) {
  const Routing routing = parse_routing(word);
  return shown_routing(routing, model,
                       parse_grasps(grasps, finger_count(routing), carriage_count(routing)),
                       Direction::pull, {});
}

TEST(ShowJson, HasTheTensionOfEachMotorAndHowItsCarriageTravels) {
  const Json json = to_json(shown("1x-M+2x-M2", "none@1,0.5/none"));
  EXPECT_EQ(json["grasps"][0]["carriages"].dump(), "[1.0,0.5]");
  EXPECT_NEAR(json["grasps"][0]["motors"][0], 2.0 / 3, 1e-15);
  EXPECT_NEAR(json["grasps"][0]["motors"][1], 1.0 / 3, 1e-15);
  EXPECT_FALSE(json["grasps"][1].contains("carriages"));
  EXPECT_EQ(json["grasps"][1]["motors"].dump(), "[0.5,0.5]");
  EXPECT_EQ(json["motor_sides"][1]["motor"], 2);
}

TEST(ShowJson, SaysNothingOfMotorsIfThereIsOne) {
  const Json json = to_json(shown("1x-M+2x-M", "none"));
  EXPECT_FALSE(json["grasps"][0].contains("motors"));
  EXPECT_FALSE(json["motor_sides"][0].contains("motor"));
}

Model with_spool(const std::string& segment, double ratio) {
  Model model;
  model.hardware.spools = {{segment, ratio}};
  return model;
}

TEST(ShowJson, HasTheSpoolOfAnEndAndTheMotorsForceThroughIt) {
  const Json json = to_json(shown("1x-M+2x-M2", "none", with_spool("b", 0.5)));
  EXPECT_EQ(json["motor_sides"][1]["spool"], 0.5);
  EXPECT_FALSE(json["motor_sides"][0].contains("spool"));
  EXPECT_NEAR(json["grasps"][0]["motors"][0], 0.8, 1e-15);
  EXPECT_NEAR(json["grasps"][0]["motors"][1], 0.2, 1e-15);
  EXPECT_NEAR(json["travel"], 2 / 1.5, 1e-9);
  EXPECT_EQ(to_json(with_spool("b", 0.5).hardware)["spools"].dump(), R"({"b":0.5})");
  const ShownRouting one_motor = shown("1x-M+2x-M", "none", with_spool("b", 0.5));
  EXPECT_EQ(show_document(one_motor).sections[0].lines[1].text,
            "Motor-side segments, in walk order: a at T1, b at T3 (spool 0.5)");
}

std::string head_of(const ShownRouting& shown) {
  return text(Document{{show_document(shown).sections[0]}});
}

std::string page_of(const ShownRouting& shown) { return text(show_document(shown)); }

TEST(ShowDocument, SaysOfMotorsThatHaveNothingInCommonWhichOneStalls) {
  const std::string said = page_of(shown("1x-M+2x-M2", "none/1/2"));
  EXPECT_TRUE(has(said,
                  "It jams when finger 1 is held (M stalls), or finger 2 is held (M2 stalls) "
                  "(2 of 3 grasps, if all carriages travel alike)"))
      << said;
  EXPECT_TRUE(has(said,
                  "M and M2 have nothing in common: if one of them stalls, these tables stop "
                  "all carriages, but the others can go on, such as with held 1@0,1"))
      << said;
  EXPECT_TRUE(has(said, "\n1 (M stalls) ")) << said;
  EXPECT_TRUE(has(said, "\n2 (M2 stalls) ")) << said;
}

TEST(ShowDocument, SaysNothingOfOtherMotorsIfAllPullOneTendon) {
  const std::string said = page_of(shown("M-1-M2+2x-M", "none/1"));
  EXPECT_FALSE(has(said, "nothing in common")) << said;
  EXPECT_TRUE(has(said, "\n1 (jams)")) << said;
}

Model with_tendon(const TendonHardware& own) {
  Model model;
  model.hardware.tendon = {.EA_N = 1000, .travel_mm = 50, .own = {own}};
  return model;
}

TEST(SharedCarriage, IsSharedByTheSpringsAndSlackThatAreGiven) {
  const auto said = [](const TendonHardware& own) {
    return head_of(shown("1x-M+2x-M", "none", with_tendon(own)));
  };
  const std::string springs = said({.tendon = 1, .stiffness_N_mm = 5});
  EXPECT_TRUE(has(springs,
                  "their shares of its pull follow from the springs given, and assume no "
                  "slack; a slack tendon carries less; jams and motor force leave out the stretch "
                  "of springs"))
      << springs;
  const std::string slack = said({.tendon = 1, .slack_mm = 50});
  EXPECT_TRUE(has(slack,
                  "their shares of its pull follow from the slack given, and assume equal "
                  "stiffness; a softer tendon carries less"))
      << slack;
  EXPECT_TRUE(has(slack, "It jams when finger 2 is held (1 of 3 grasps)")) << slack;
  EXPECT_TRUE(has(said({.tendon = 1, .stiffness_N_mm = 5, .slack_mm = 5}),
                  "follow from the springs and the slack given; jams and motor force leave out "
                  "the stretch of springs"));
}

TEST(SharedCarriage, NamesTheCarriagesOfSeveralMotors) {
  EXPECT_TRUE(
      has(shared_carriage_text(expand(parse_routing("1x-M+2x-M2")), {}),
          "2 tendons hang on 2 carriages, which travel alike unless a grasp says otherwise"));
}

TEST(Mjcf, HasABodyAndAnActuatorForEachMotor) {
  const std::string two = mjcf(parse_routing("1x-M+2x-M2"), {});
  for (const char* part :
       {"<body name=\"carriage\"", "<body name=\"carriage_2\"",
        "<motor name=\"motor\" joint=\"carriage\"", "<motor name=\"motor_2\" joint=\"carriage_2\"",
        "ctrl=\"10 10\"", "Each motor pulls with the same force"}) {
    EXPECT_TRUE(has(two, part)) << part;
  }
}

}  // namespace
}  // namespace reeve
