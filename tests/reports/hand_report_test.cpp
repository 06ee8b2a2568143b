// What is said of a hand where there is nothing to say a number of.
#include "reports/hand_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/finger_guides.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "reports/document/document.hpp"
#include "reports/motor_words.hpp"
#include "studies/shown_hand.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

using testing::hand_of;
using testing::simple_finger;

Hardware hardware_of(double stroke_mm, int fingers) {
  std::vector<FingerParts> parts;
  for (int f = 1; f <= fingers; ++f) parts.push_back(simple_finger(7 + f, 90, 60, 5));
  Hardware hardware = hand_of(parts);
  hardware.motor.force_N = 80;
  hardware.motor.stroke_mm = stroke_mm;
  hardware.motor.spool_radius_mm = 8;
  return hardware;
}

ShownHand shown_of(const std::string& word, double stroke_mm, int fingers) {
  const Hardware hardware = hardware_of(stroke_mm, fingers);
  const Network network = expand(parse_routing(word));
  return *studies::shown_hand(network, word, Model{hardware}, single_grasps(fingers));
}

std::string said_of(const std::string& word, double stroke_mm, int fingers) {
  Document document;
  for (const Section& section : reports::hand_sections(shown_of(word, stroke_mm, fingers))) {
    document.add(section);
  }
  return text(document);
}

Json motor_of(const std::string& word, double stroke_mm, int fingers) {
  Json json;
  reports::add_hand(json, shown_of(word, stroke_mm, fingers));
  return json["motor"];
}

TEST(HandSections, HaveNoNumbersWhereNoMotorForceIsEnough) {
  const std::string said = said_of("M-1-M+M-2-M", 60, 2);
  EXPECT_TRUE(testing::has(said, "No motor force is enough"));
  EXPECT_TRUE(testing::has(said, "wanted (N)  at 80 N\n"));
  EXPECT_FALSE(testing::has(said, "at - N"));
  EXPECT_FALSE(testing::has(said, "- of it"));
}

// Returns the line that says why no motor force is enough.
std::string why_no_force(const std::string& word, const std::string& held,
                         const Hardware& hardware) {
  const Network network = expand(parse_routing(word));
  const Grasp grasp =
      parse_grasp(held, network.fingers, carriage_count(network), motor_ends(network));
  Document document;
  for (const Section& section :
       reports::hand_sections(*studies::shown_hand(network, word, Model{hardware}, {{grasp, 1}}))) {
    document.add(section);
  }
  const std::string said = text(document);
  const std::size_t begin = said.find("No motor force is enough");
  return begin == std::string::npos ? "" : said.substr(begin, said.find('\n', begin) - begin);
}

TEST(HandSections, SayWhyAFingerGetsNoPull) {
  const auto since = [](const std::string& held, const std::string& reason) {
    return "No motor force is enough: with held " + held + " finger 1 gets no pull, since " +
           reason;
  };
  Hardware hardware = hardware_of(60, 2);
  EXPECT_EQ(why_no_force("1x-M+2x-M", "a", hardware), since("a", "its ends at motors are locked"));
  EXPECT_EQ(why_no_force("1x-M+2x-M2", "none@0,1", hardware),
            since("none@0,1", "its carriages stand still"));
  EXPECT_EQ(why_no_force("1x-M+2x-M", "2", hardware), since("2", "the carriage is blocked"));
  EXPECT_EQ(why_no_force("M-1e", "none", hardware), since("none", "its extensor holds it back"));
  EXPECT_EQ(why_no_force("M-1x+M-1e", "none", hardware),
            since("none", "its extensor holds it back"));
  hardware.spools = {{"b", -0.8}};  // lets out less than the flexor takes
  EXPECT_EQ(why_no_force("M-1x+M-1e", "none", hardware),
            since("none", "its extensor holds it back"));
  hardware.spools.clear();
  hardware.tendon = {.EA_N = 20000, .own = {{.tendon = 2, .stiffness_N_mm = 5}}};
  EXPECT_EQ(why_no_force("1x-M+2x-M", "2", hardware),
            since("2", "the carriage is blocked, if springs in series do not stretch"));
  hardware.tendon = {.travel_mm = 20, .own = {{.tendon = 1, .slack_mm = 20}}};
  EXPECT_EQ(why_no_force("1x-M+2x-M", "none", hardware),
            since("none", "its tendon is still slack after the whole carriage travel"));
  EXPECT_EQ(why_no_force("2x-W1-3x+W1-M+W1-1x", "none", hardware_of(60, 3)),
            since("none", "its tendon is still slack after the whole carriage travel"));
}

TEST(HandJson, NamesTheLockedEndsAndTravelsOfItsGrasps) {
  const auto grasp_of = [](const std::string& word, const std::string& held) {
    const Network network = expand(parse_routing(word));
    const Grasp grasp =
        parse_grasp(held, network.fingers, carriage_count(network), motor_ends(network));
    Json json;
    reports::add_hand(json,
                      *studies::shown_hand(network, word, Model{hardware_of(60, 2)}, {{grasp, 1}}));
    return json["grasps"][0];
  };
  EXPECT_EQ(grasp_of("1x-M+2x-M", "a")["locked"].dump(), "[\"a\"]");
  EXPECT_EQ(grasp_of("1x-M+2x-M2", "none@1,0.5")["carriages"].dump(), "[1.0,0.5]");
  EXPECT_FALSE(grasp_of("1x-M+2x-M", "none").contains("locked"));
}

TEST(HandSections, HaveAColumnForEachOfSeveralMotorsAndNoPartsOfTheirWork) {
  const std::string said = said_of("M-1-F+M2-2-F", 60, 2);
  EXPECT_TRUE(testing::has(said, "finger 2  M (N)  M2 (N)  limiting finger"));
  EXPECT_TRUE(testing::has(said, "at motor forces (N)"));
  EXPECT_FALSE(testing::has(said, "friction takes"));
  const Json motor = motor_of("M-1-F+M2-2-F", 60, 2);
  EXPECT_TRUE(motor["friction_J"].is_null());
  EXPECT_TRUE(motor["fingers_J"].is_null());
  EXPECT_TRUE(motor["work_J"].is_number());
}

TEST(MotorLines, SayThatAStrokeLeavesOutTheStretchOfSprings) {
  MotorParts motor;
  motor.stroke_mm = 40;
  MotorForce force{
      .nominal_N = 50, .p95_N = 60, .draws = 10, .stroke_mm = 30, .leaves_out_springs = true};
  const auto line = [&] { return reports::motor_lines(force, motor).at(1); };
  EXPECT_EQ(line().text,
            "The motor's stroke of 40 mm is enough, if springs in series do not stretch: 75.0 % "
            "of it is needed");
  EXPECT_TRUE(line().caveat);
  force.leaves_out_springs = false;
  EXPECT_EQ(line().text, "The motor's stroke of 40 mm is enough: 75.0 % of it is needed");
  EXPECT_FALSE(line().caveat);
}

TEST(MotorLines, SayThatForcesAndMotorsLeaveOutTheStretchOfSprings) {
  const MotorForce force{.nominal_N = 50,
                         .p95_N = 60,
                         .draws = 10,
                         .leaves_out_springs = true,
                         .motors = {{50, 30}, {40, 20}}};
  const std::vector<DocumentLine> lines = reports::motor_lines(force, {});
  EXPECT_EQ(lines.front().text,
            "Motor force: 50.0 N nominal, 60.0 N in 95 % of 10 draws, if springs in series do not "
            "stretch");
  EXPECT_EQ(lines.back().text,
            "Motors, if springs in series do not stretch: M 50.0 N over 30.0 mm, M2 40.0 N over "
            "20.0 mm");
}

// Springs lengthen the stroke: one that is too short without them is too short with them.
TEST(MotorForceJson, DoesNotCallAStrokeEnoughThatLeavesOutSprings) {
  MotorParts motor;
  MotorForce force{.stroke_mm = 30, .leaves_out_springs = true};
  const auto is_enough = [&](double stroke_mm) {
    motor.stroke_mm = stroke_mm;
    return reports::motor_force_json(force, motor)["stroke_is_enough"].dump();
  };
  EXPECT_EQ(is_enough(40), "null");
  EXPECT_EQ(is_enough(20), "false");
  force.leaves_out_springs = false;
  EXPECT_EQ(is_enough(40), "true");
}

ShownHand sprung_hand(const std::string& word, double stroke_mm, double stiffness_N_mm) {
  Hardware hardware = hardware_of(stroke_mm, 2);
  hardware.tendon = {.EA_N = 20000, .own = {{.tendon = 1, .stiffness_N_mm = stiffness_N_mm}}};
  const Network network = expand(parse_routing(word));
  return *studies::shown_hand(network, word, Model{hardware}, single_grasps(2));
}

std::string said_of(const ShownHand& hand) {
  Document document;
  for (const Section& section : reports::hand_sections(hand)) document.add(section);
  return text(document);
}

TEST(HandSections, SayWhatSpringsInSeriesTakeOfStrokeAndWork) {
  const ShownHand hand = sprung_hand("M-1-T-2-F", 40, 50);
  const double force_N = hand.demand.force_N;
  const std::string said = said_of(hand);
  EXPECT_TRUE(testing::has(said, fmt::format(" mm/s. Springs in series take {:.4g} mm of it, at "
                                             "{:.4g} N\n",
                                             force_N / 50, force_N)))
      << said;
  EXPECT_TRUE(testing::has(
      said, fmt::format(", springs in series {:.3g} J, friction takes ", force_N * force_N / 1e5)))
      << said;
  EXPECT_TRUE(testing::has(said,
                           "With 40 mm of stroke, of which springs in series take 1.6 mm at "
                           "80 N, the hand closes to "))
      << said;
  const double closing_mm = hand.demand.stroke_mm - force_N / 50;
  EXPECT_TRUE(testing::has(said, fmt::format("at a stroke of {:.4g} mm: ", closing_mm + 1.6)))
      << said;
  Json json;
  reports::add_hand(json, hand);
  EXPECT_NEAR(json["motor"]["force_reach"]["stroke_mm"].get<double>(), closing_mm + 1.6, 1e-9);
  EXPECT_NEAR(json["motor"]["stretch_mm"].get<double>(), force_N / 50, 1e-9);
  EXPECT_NEAR(json["motor"]["series_springs_J"].get<double>(), force_N * force_N / 1e5, 1e-9);
  EXPECT_FALSE(motor_of("M-1-T-2-F", 40, 2).contains("stretch_mm"));
}

TEST(HandSections, SayThatAStrokeLeavesOutSpringsThatAreTooSoft) {
  const ShownHand hand = sprung_hand("M-1-P-2-F", 10, 5);
  const std::string said = said_of(hand);
  EXPECT_TRUE(testing::has(said, " s, if springs in series do not stretch: ")) << said;
  EXPECT_TRUE(testing::has(said, "stroke, if springs in series do not stretch, the hand")) << said;
  EXPECT_TRUE(testing::has(said, " J, if springs in series do not stretch, of which the springs"))
      << said;
  Json json;
  reports::add_hand(json, hand);
  EXPECT_TRUE(json["motor"]["stretch_mm"].is_null());
  EXPECT_TRUE(json["motor"]["series_springs_J"].is_null());
}

TEST(HandSections, SayThatTheClosingByAShortStrokeIsNotKnownWhereTendonSlipsBack) {
  EXPECT_TRUE(testing::has(said_of(sprung_hand("M-1-P-2-F", 0.01, 2000)),
                           "With 0.01 mm of stroke it is not known how far the hand closes: "
                           "springs in series take all of it, or tendon slips back at them"));
}

TEST(HandSections, SayThatSpringsBesideSeveralEndsHideFriction) {
  const ShownHand hand = sprung_hand("M-1-P-2-F", 60, 2000);
  ASSERT_TRUE(hand.demand.stretch);
  EXPECT_TRUE(testing::has(said_of(hand),
                           " J, and friction and fingers are not told apart, since "
                           "several ends hang on the motor beside springs in "
                           "series; power"));
  Json json;
  reports::add_hand(json, hand);
  EXPECT_TRUE(json["motor"]["friction_J"].is_null());
}

TEST(HandSections, NameTheShareOfSlackThatTheMotorForceIsOf) {
  Hardware hardware = hardware_of(60, 2);
  hardware.tendon = {.EA_N = 20000,
                     .travel_mm = 50,
                     .own = {{.tendon = 1, .stiffness_N_mm = 5}, {.tendon = 2, .slack_mm = 5}}};
  const Network network = expand(parse_routing("1x-M+2x-M"));
  const ShownHand hand =
      *studies::shown_hand(network, "1x-M+2x-M", Model{hardware}, {{Grasp{}, 1}});
  EXPECT_TRUE(testing::has(said_of(hand),
                           " N, if springs in series do not stretch, with the shares of tendons "
                           "with slack at a carriage travel of 50 mm: finger "))
      << said_of(hand);
  Json json;
  reports::add_hand(json, hand);
  EXPECT_EQ(json["motor"]["slack_shared_at_mm"], 50);
  EXPECT_FALSE(motor_of("M-1-T-2-F", 40, 2).contains("slack_shared_at_mm"));
}

// The tendon without a finger is tied at both ends.
TEST(HandSections, GiveNoStrokeOfACarriageThatCannotMove) {
  const std::string said = said_of("M-F+M-1-F+M-2-M", 30, 2);
  EXPECT_TRUE(testing::has(said, "No stroke: the carriage is blocked, and no finger can close\n"));
  EXPECT_FALSE(testing::has(said, "Stroke 0"));
  EXPECT_FALSE(testing::has(said, "stroke of 30 mm"));
  const Json motor = motor_of("M-F+M-1-F+M-2-M", 30, 2);
  for (const char* key : {"stroke_mm", "speed_mm_s", "spool_rpm"}) {
    EXPECT_TRUE(motor[key].is_null()) << key;
  }
  EXPECT_EQ(motor["closure"], 0);
}

TEST(HandSections, NameTheFingersThatCloseLeastWhereOthersCloseMore) {
  const auto said_of_stroke = [](const std::string& word) {
    const std::string said = said_of(word, 5, 3);
    const std::size_t begin = said.find("With 5 mm of stroke");
    return said.substr(begin, said.find('\n', begin) - begin);
  };
  EXPECT_TRUE(said_of_stroke("M-1-T-2-T-3-F").ends_with(" of its range"));
  EXPECT_TRUE(said_of_stroke("M-1-F+M-2-T-3-F").ends_with(": fingers 2, 3 close least"));
  EXPECT_TRUE(said_of_stroke("M-1-T-2-F+M-3-M").ends_with(": fingers 1, 2 close least"));
  EXPECT_TRUE(said_of_stroke("M-1-F+M-2-F+M-3-F").ends_with(": finger 3 closes least"));
}

// Two fingers alike, guides at their joints, and the first joint stopped by an object.
ShownHand guided_hand() {
  FingerParts parts = testing::three_joint_finger();
  for (FingerJoint& joint : parts.joints) joint.guide = JointGuide::tube;
  parts.joints[0].object_deg = 60;
  const Network network = expand(parse_routing("M-1-T-2-F"));
  return *studies::shown_hand(network, "M-1-T-2-F", Model{hand_of({parts, parts})},
                              single_grasps(2));
}

TEST(HandSections, ShowTheClosingOfFingersThatAreAlikeOnce) {
  const ShownHand hand = guided_hand();
  ASSERT_EQ(hand.closings.size(), 1U);
  EXPECT_EQ(hand.closings[0].fingers, (std::vector<int>{1, 2}));
  Document document;
  for (const Section& section : reports::hand_sections(hand)) document.add(section);
  EXPECT_TRUE(testing::has(text(document), "Hand: closing of fingers 1, 2 in free motion"));
  EXPECT_TRUE(testing::has(text(document), "Joints stop in this order: joint 1 at "));
  EXPECT_TRUE(testing::has(text(document), "mm (object)"));
  EXPECT_TRUE(testing::has(text(document), "object 1 (N mm)"));
}

// The closing of a finger with phalanges; its joints without an object stop at 80 deg.
ShownHand touching_hand(const std::vector<std::optional<double>>& objects_deg) {
  FingerParts parts{{}, 5};
  for (const std::optional<double>& object_deg : objects_deg) {
    FingerJoint joint{parts.joints.empty() ? 30. : 6., 80, 60, 20};
    joint.object_deg = object_deg;
    joint.phalanx_mm = parts.joints.empty() ? 40 : 30;
    parts.joints.push_back(joint);
  }
  return *studies::shown_hand(expand(parse_routing("M-1-F")), "M-1-F", Model{hand_of({parts})},
                              single_grasps(1));
}

std::string closing_of(const ShownHand& hand) {
  Document document;
  document.add(reports::hand_sections(hand).back());
  return text(document);
}

// A newton turns joint 2 with 6 N mm, which 0.4 N hold 15 mm from it, and joint 1 with 30 N mm.
TEST(HandSections, GiveContactForcesOfFurtherPull) {
  const double first = (30 - 0.4 * (15 + 40 * std::cos(in_rad(30)))) / 20;
  EXPECT_TRUE(testing::has(
      closing_of(touching_hand({20, 30})),
      fmt::format(
          "Once all have stopped, each newton of pull adds {:.2f} N at contact 1, 0.40 N at "
          "contact 2\n",
          first)));
  EXPECT_TRUE(testing::has(closing_of(guided_hand()), "of pull adds 8.28 N mm at object 1\n"))
      << closing_of(guided_hand());
}

// Joint 2 presses its phalanx so hard that phalanx 1 is pushed off its object.
TEST(HandSections, SayThatFurtherPullLosesAContact) {
  EXPECT_TRUE(testing::has(closing_of(touching_hand({20, 30, 30})),
                           "N at contact 3; a contact whose force falls to 0 is lost\n"))
      << closing_of(touching_hand({20, 30, 30}));
}

TEST(HandSections, SayWhyThereAreNoContactForces) {
  const char* const why =
      "-: no contact forces, since a joint nearer to the palm than an object would give way";
  EXPECT_TRUE(testing::has(closing_of(touching_hand({std::nullopt, 5})), why));
  EXPECT_FALSE(testing::has(closing_of(touching_hand({20, 30})), why));
}

TEST(HandJson, HasThePosturesOfClosingAndOpening) {
  Json json;
  reports::add_hand(json, guided_hand());
  const Json& closing = json["closings"][0];
  EXPECT_EQ(closing["closing"].size(), closing["opening"].size());
  EXPECT_NEAR(closing["closing"].back()["flexion_deg"][0].get<double>(), 60, 1e-12);
  EXPECT_TRUE(closing["closing"].back()["contact_N"].is_null());
  for (const Json& posture : closing["opening"]) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(
          posture["torque_Nmm"][j].get<double>(),
          posture["tension_N"][j].get<double>() * testing::three_joint_finger().joints[j].arm_mm);
    }
  }
  EXPECT_EQ(closing["stops"].size(), 3U);
  Json plain;
  reports::add_hand(plain, shown_of("M-1-M+M-2-M", 60, 2));
  EXPECT_FALSE(plain.contains("closings"));
}

// Friction along the finger costs motor force, and what the springs and fingers get is less.
TEST(HandDemand, CountsTheFrictionAtGuidesAsFriction) {
  const MotorDemand guided = guided_hand().demand;
  FingerParts parts = testing::three_joint_finger();
  const Network network = expand(parse_routing("M-1-T-2-F"));
  const MotorDemand plain =
      studies::shown_hand(network, "M-1-T-2-F", Model{hand_of({parts, parts})}, single_grasps(2))
          ->demand;
  EXPECT_GT(guided.force_N, plain.force_N);
  EXPECT_DOUBLE_EQ(guided.frictionless_N, plain.frictionless_N);
  EXPECT_DOUBLE_EQ(guided.stroke_mm, plain.stroke_mm);
  EXPECT_GT(guided.friction_J / guided.work_J, plain.friction_J / plain.work_J);
}

}  // namespace
}  // namespace reeve
