#include "core/grasp.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

std::string message(const std::string& text, int fingers) {
  return testing::input_error([&] { parse_grasp(text, fingers); });
}

std::string set_message(const std::string& text, int fingers) {
  return testing::input_error([&] { parse_grasps(text, fingers); });
}

TEST(Grasp, KnowsTheFingersThatItHolds) {
  const Grasp grasp = hold({1, 3, 64});
  EXPECT_TRUE(grasp.holds(1) && grasp.holds(3) && grasp.holds(64));
  EXPECT_FALSE(grasp.holds(2) || grasp.holds(63));
  EXPECT_EQ(held_fingers(grasp), (std::vector<int>{1, 3, 64}));
  EXPECT_EQ(held_fingers(Grasp{}), std::vector<int>{});
}

TEST(Grasp, IsWrittenAsItsFingersInOrder) {
  EXPECT_EQ(to_text(Grasp{}), "none");
  EXPECT_EQ(to_text(hold({2})), "2");
  EXPECT_EQ(to_text(hold({3, 1, 64})), "1,3,64");
}

TEST(Grasp, ReadsWhatItWrites) {
  for (const std::string text : {"none", "1", "2,4", "1,2,3,4"}) {
    EXPECT_EQ(to_text(parse_grasp(text, 4)), text);
  }
  EXPECT_EQ(parse_grasp("3,1", 4), hold({1, 3}));
}

TEST(GraspError, NamesTheItemAndTheFingersThatThereAre) {
  const auto expected = [](const std::string& text, const std::string& item) {
    return "held '" + text + "': '" + item +
           "': expected none, or finger numbers from 1 to 3 such as 1,2";
  };
  for (const std::string item :
       {"4", "0", "-1", "one", "1.5", " 1", "1 ", "", "NONE", "99999999999999999999"}) {
    EXPECT_EQ(message(item, 3), expected(item, item));
    EXPECT_EQ(message("2," + item, 3), expected("2," + item, item));
  }
  EXPECT_EQ(message("1,none", 3), "held '1,none': 'none': expected it alone, or '1' without it");
  EXPECT_EQ(message("1;2", 3), expected("1;2", "1;2"));
}

TEST(GraspError, SaysWhatThereIsOfFewFingers) {
  EXPECT_EQ(message("1", 0), "held '1': '1': expected none: there is no finger");
  EXPECT_EQ(message("2", 1), "held '2': '2': expected none or 1");
}

TEST(GraspError, NamesAFingerThatIsNamedTwice) {
  EXPECT_EQ(message("1,2,1", 3), "held '1,2,1': finger 1 is named twice");
}

TEST(GraspSet, SingleIsNoneHeldAndEachFingerHeld) {
  EXPECT_EQ(to_text(single_grasps(3)), "none/1/2/3");
  EXPECT_EQ(to_text(parse_grasps("single", 2)), "none/1/2");
}

TEST(GraspSet, AllIsEverySetThatLeavesSomethingToClose) {
  EXPECT_EQ(to_text(all_grasps(2)), "none/1/2");
  EXPECT_EQ(to_text(parse_grasps("all", 3)), "none/1/2/1,2/3/1,3/2,3");
  const GraspSet many = all_grasps(10);
  std::set<std::uint64_t> held;
  for (const WeightedGrasp& weighted : many) held.insert(weighted.grasp.held);
  EXPECT_EQ(held.size(), 1023U);
  EXPECT_EQ(many.size(), 1023U);
}

TEST(GraspSet, AllOfTooManyFingersIsRefused) {
  EXPECT_EQ(all_grasps(16).size(), 65535U);
  EXPECT_EQ(set_message("all", 17),
            "grasps 'all': 17 fingers have 2^17 grasps; expected at most 16 fingers, or another "
            "set");
}

TEST(GraspSet, PaperIsFingerOneHeld) {
  EXPECT_EQ(to_text(parse_grasps("paper", 4)), "1");
  EXPECT_EQ(to_text(paper_grasps()), "1");
}

TEST(GraspSet, ReadsHeldListsWithWeights) {
  const GraspSet grasps = parse_grasps("none:2/1/1,2:0.5", 3);
  ASSERT_EQ(grasps.size(), 3U);
  EXPECT_EQ(grasps[0].grasp, Grasp{});
  EXPECT_EQ(grasps[0].weight, 2);
  EXPECT_EQ(grasps[1].grasp, hold({1}));
  EXPECT_EQ(grasps[1].weight, 1);
  EXPECT_EQ(grasps[2].grasp, hold({1, 2}));
  EXPECT_EQ(grasps[2].weight, 0.5);
  EXPECT_EQ(to_text(grasps), "none:2/1/1,2:0.5");
}

TEST(Grasp, ReadsTheTravelsOfCarriagesThatItWrites) {
  for (const std::string text : {"none@1,-1", "1,2@1,0.5", "2@0,1"}) {
    EXPECT_EQ(to_text(parse_grasp(text, 2, 2)), text);
  }
  const Grasp grasp = parse_grasp("1@1,-0.5,0", 2, 3);
  EXPECT_TRUE(grasp.holds(1));
  EXPECT_EQ(carriage_travels(grasp), (std::vector<double>{1, -0.5, 0}));
  EXPECT_EQ(grasp.travel(2), -0.5);
  EXPECT_EQ(grasp.travel(4), 1);
  EXPECT_EQ(carriage_travels(hold({1})), std::vector<double>{});
  EXPECT_EQ(to_text(parse_grasps("none@1,-1:2/1", 2, 2)), "none@1,-1:2/1");
}

// In M-1-P-2-M+3x-M the sides b and c of the pulley move as one.
const MotorEnds ends{1, 0b110, 0b110, 8, 16};

TEST(Grasp, ReadsTheLockedEndsThatItWrites) {
  for (const std::string text : {"a", "1,a", "2,b,c", "b,c,d@1,0.5"}) {
    EXPECT_EQ(to_text(parse_grasp(text, 2, 2, ends)), text);
  }
  const Grasp grasp = parse_grasp("c,1,e", 2, 1, ends);
  EXPECT_TRUE(grasp.holds(1));
  EXPECT_EQ(locked_ends(grasp), (std::vector<std::string>{"b", "c", "e"}));
  EXPECT_TRUE(grasp.locks(3));
  EXPECT_FALSE(grasp.locks(4));
  EXPECT_EQ(locked_words(grasp), ", ends b, c, e locked");
  EXPECT_EQ(locked_words(hold({1})), "");
  EXPECT_EQ(to_text(parse_grasps("a:2/1", 2, 1, ends)), "a:2/1");
  EXPECT_EQ(motor_ends(expand(parse_routing("M-1-P-2-M+3x-M"))), ends);
  EXPECT_EQ(motor_ends(expand(parse_routing("1-P-2-P-1"))), (MotorEnds{3, 3, 12, 12}));
  EXPECT_FALSE(treats_fingers_alike(parse_grasps("a/b", 2, 1, ends), 2));
  EXPECT_FALSE(grasp_named("1,a", 3));
}

TEST(GraspError, LocksEndsOfTheRoutingAndNotAll) {
  const auto of_ends = [](const std::string& text, const MotorEnds& given) {
    return testing::input_error([&] { parse_grasp(text, 2, 1, given); });
  };
  EXPECT_EQ(of_ends("f", ends), "held 'f': 'f': expected a motor-side segment from a to e");
  EXPECT_EQ(of_ends("a,1,a", ends), "held 'a,1,a': a is named twice");
  EXPECT_EQ(of_ends("a,b,d,e", ends),
            "held 'a,b,d,e': every end at a motor is locked: expected one that moves");
  EXPECT_EQ(of_ends("1,a", {}),
            "held '1,a': 'a': expected no locked end: they are for one routing, or several whose "
            "ends at motors have the same names");
}

TEST(GraspError, TravelsOfCarriagesAreOneForEachMotor) {
  const std::string two =
      ": expected 2 travels from -100 to 100, one of each motor's carriage and one at least above "
      "0, such as @1,-1";
  for (const std::string travels : {"@", "@1", "@1,1,1", "@1,", "@1,x", "@0,0", "@-1,-1", "@1,101",
                                    "@1,nan", "@1,inf", "@1@1"}) {
    EXPECT_EQ(testing::input_error([&] { parse_grasp("1" + travels, 2, 2); }),
              "held '1" + travels + "': '" + travels + "'" + two);
  }
  EXPECT_EQ(message("1@1", 2),
            "held '1@1': '@1': expected no travels of carriages: they are for one routing, or "
            "several of the same number of motors, with more than one motor");
  EXPECT_FALSE(grasp_named("1@1", 3));
}

TEST(GraspSetError, NamesTheItemWhoseWeightIsWrong) {
  for (const std::string item :
       {"1:0", "1:9.9e-7", "1:-1", "1:nan", "1:inf", "1:1.1e6", "1:", "1:x", "1:1:1", "1:2 "}) {
    EXPECT_EQ(set_message("none/" + item, 2),
              "grasps 'none/" + item + "': '" + item +
                  "': expected a held list and a weight from 1e-6 to 1e6, such as 1,2:0.5");
  }
}

TEST(GraspSet, TakesTheLeastAndTheGreatestWeightThatItNames) {
  EXPECT_EQ(parse_grasps("1:1e-6", 2).at(0).weight, 1e-6);
  EXPECT_EQ(parse_grasps("1:1e6", 2).at(0).weight, 1e6);
}

TEST(GraspSetError, NamesTheFingerThatDoesNotExist) {
  EXPECT_EQ(set_message("none/3", 2),
            "grasps 'none/3': '3': expected none, or finger numbers from 1 to 2 such as 1,2");
  EXPECT_EQ(set_message("", 2),
            "grasps '': '': expected none, or finger numbers from 1 to 2 such as 1,2");
}

TEST(GraspSet, TreatsFingersAlikeIfRenamingThemChangesNothing) {
  EXPECT_TRUE(treats_fingers_alike(single_grasps(4), 4));
  EXPECT_TRUE(treats_fingers_alike(all_grasps(4), 4));
  EXPECT_TRUE(treats_fingers_alike(parse_grasps("none:3/1,2/1,3/2,3", 3), 3));
  EXPECT_FALSE(treats_fingers_alike(paper_grasps(), 2));
  EXPECT_FALSE(treats_fingers_alike(parse_grasps("none/1:2/2", 2), 2));
  EXPECT_FALSE(treats_fingers_alike(parse_grasps("1,2/2,3", 3), 3));
}

TEST(GraspSet, TreatsMotorsAlikeIfRenamingThemChangesNothing) {
  EXPECT_TRUE(treats_motors_alike(single_grasps(2)));
  EXPECT_TRUE(treats_motors_alike(parse_grasps("none@1,1/1@0,2/1@2,0", 2, 2)));
  EXPECT_FALSE(treats_motors_alike(parse_grasps("none@1,-1", 2, 2)));
  EXPECT_FALSE(treats_motors_alike(parse_grasps("1@0,2/1@2,0:3", 2, 2)));
  EXPECT_FALSE(treats_motors_alike(parse_grasps("none@1,1,0/none@1,0,1", 2, 3)));
}

TEST(GraspSetError, RefusesAGraspThatIsGivenTwice) {
  EXPECT_THROW(parse_grasps("1/2/1:0.5", 2), InputError);
  EXPECT_THROW(parse_grasps("1,2/2,1", 3), InputError);
}

TEST(Grasp, IsNamedByTheFingersThatThereAreOrNotAtAll) {
  EXPECT_EQ(grasp_named("none", 3), Grasp{});
  EXPECT_EQ(grasp_named("1,3", 3), hold({1, 3}));
  for (const std::string text : {"", "4", "1,1", "1,", "one"}) {
    EXPECT_FALSE(grasp_named(text, 3)) << text;
  }
}

}  // namespace
}  // namespace reeve
