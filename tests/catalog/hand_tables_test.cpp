#include "catalog/hand_tables.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "catalog/hardware_file.hpp"
#include "catalog/hardware_tables.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/example_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Mistake;
using testing::TemporaryFolder;

Hardware hardware_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_hardware_file(folder.write("h.toml", text)).hardware;
}

std::string error_in(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_hardware_file(folder.write("h.toml", text)); });
}

const std::string joint = "{ arm_mm = 8, range_deg = 90, lever_mm = 60 }";
const std::string hand_table = "[hand]\nforce_N = 5\njoints = [" + joint + "]\n";

TEST(HandTables, AreReadIntoTheirOwnPlaces) {
  const Hardware hardware = hardware_of(
      "[hand]\nforce_N = 1\njoints = [{ arm_mm = 2, range_deg = 3, lever_mm = 4, "
      "spring_Nmm_rad = 5, rest_deg = -6, held_deg = 2.5 }]\n"
      "[finger.2]\nforce_N = 7\n[finger.3]\njoints = [" +
      joint + ", " + joint +
      "]\n"
      "[motor]\nspool_radius_mm = 8\nclose_s = 9\nforce_N = 10\nstroke_mm = 11\n");
  EXPECT_EQ(hardware.finger_parts, (FingerParts{{{2, 3, 4, 5, -6, 2.5}}, 1.0}));
  ASSERT_EQ(hardware.fingers.size(), 2U);
  EXPECT_EQ(hardware.fingers[0].parts, (FingerParts{{}, 7.0}));
  EXPECT_EQ(hardware.fingers[1].parts, (FingerParts{{{8, 90, 60}, {8, 90, 60}}, {}}));
  EXPECT_EQ(hardware.motor, (MotorParts{8.0, 9, 10.0, 11.0}));
}

TEST(HandTables, LeaveOpenWhatIsNotGiven) {
  const Hardware hardware = hardware_of(hand_table);
  EXPECT_EQ(hardware.finger_parts, testing::simple_finger(8, 90, 60, 5));
  EXPECT_EQ(hardware.motor, MotorParts{});
  EXPECT_EQ(hardware.motor.close_s, 1);
}

TEST(HandTables, AreTakenAsAnArrayOfTablesToo) {
  const Hardware hardware = hardware_of(
      "[finger.1]\nforce_N = 5\n[[finger.1.joints]]\narm_mm = 8\nrange_deg = 90\nlever_mm = 60\n");
  EXPECT_EQ(hardware.fingers[0].parts, testing::simple_finger(8, 90, 60, 5));
}

TEST(HandTables, AreWrittenAsTheyAreRead) {
  Hardware hardware = testing::hand_of({testing::three_joint_finger(), FingerParts{{}, 0.1}});
  hardware.finger_parts = testing::simple_finger(8.1, 90.3, 1 / 3.0, 5);
  hardware.motor = {6.5, 0.8, 20.0, {}};
  const Hardware again = hardware_of(hardware_toml(hardware, {}));
  EXPECT_EQ(again.finger_parts, hardware.finger_parts);
  EXPECT_EQ(again.motor, hardware.motor);
  ASSERT_EQ(again.fingers.size(), 2U);
  EXPECT_EQ(again.fingers[0].parts, hardware.fingers[0].parts);
  EXPECT_EQ(again.fingers[1].parts, hardware.fingers[1].parts);
}

TEST(HandTables, ReadAndWriteTheGuidesOfJoints) {
  const Hardware hardware = hardware_of(
      "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90, lever_mm = 60, guide = "
      "\"tube\", mu = 0.1, wrap_deg = 20, object_deg = 40, phalanx_mm = 30 }, { arm_mm = 8, "
      "range_deg = 90, lever_mm = 60, guide = \"pulley\" }]\n");
  const std::vector<FingerJoint>& joints = hardware.finger_parts.joints;
  EXPECT_EQ(joints[0].guide, JointGuide::tube);
  EXPECT_EQ(joints[0].mu, 0.1);
  EXPECT_EQ(joints[0].wrap_deg, 20);
  EXPECT_EQ(joints[0].object_deg, 40);
  EXPECT_EQ(joints[0].phalanx_mm, 30);
  EXPECT_EQ(joints[1].guide, JointGuide::pulley);
  EXPECT_FALSE(joints[1].mu);
  EXPECT_EQ(hardware_of(hardware_toml(hardware, {})).finger_parts, hardware.finger_parts);
}

TEST(HandTables, AreNotWrittenWhereNothingIsSaidOfAHand) {
  const std::string text = hardware_toml(Hardware{}, {});
  EXPECT_EQ(text.find("[hand]"), std::string::npos);
  EXPECT_EQ(text.find("[motor]"), std::string::npos);
}

TEST(HandTables, OfTheExampleAreAHandOfThreeFingers) {
  const Hardware hardware =
      read_hardware_file(std::string(REEVE_CATALOG_DIR) + "/hardware/three_finger_hand.toml")
          .hardware;
  EXPECT_EQ(hardware.finger_parts.joints.size(), 3U);
  EXPECT_EQ(hardware.fingers[0].parts.joints.size(), 2U);
  EXPECT_EQ(hardware.fingers[0].parts.force_N, 2 * *hardware.finger_parts.force_N);
  EXPECT_TRUE(hardware.motor.force_N);
}

std::string hand_with(int joints) {
  std::string list;
  for (int i = 0; i < joints; ++i) list += (i == 0 ? "" : ", ") + joint;
  return "[hand]\nforce_N = 5\njoints = [" + list + "]\n";
}

TEST(HandTables, HaveUpToSixteenJointsOfAFinger) {
  EXPECT_EQ(hardware_of(hand_with(16)).finger_parts.joints.size(), 16U);
}

TEST(HandTables, NameThePlaceOfAMistake) {
  const std::string not_so_many =
      "hand.joints = (an array): expected from 1 to 16 joints, such as [{ arm_mm = 9, range_deg = "
      "80, lever_mm = 75 }]";
  const std::string in_joint = "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90, ";
  const std::vector<Mistake> mistakes = {
      {in_joint + "lever_mm = 0 }]\n",
       "h.toml:1:2: hardware: hand.joints[1].lever_mm = 0: expected a number from 0.01 to 1000 mm"},
      {in_joint + "lever_mm = 60, held_deg = 91 }]\n",
       "h.toml:1:2: hardware: hand.joints[1].held_deg = 91: expected a number from 0 to 90 deg"},
      {in_joint + "lever_mm = 60, object_deg = 20, held_deg = 70 }]\n",
       "h.toml:1:2: hardware: hand.joints[1].held_deg = 70: expected a number from 0 to 20 deg"},
      {in_joint + "lever_mm = 60, spring_Nmm_rad = -1 }]\n",
       "h.toml:1:2: hardware: hand.joints[1].spring_Nmm_rad = -1: expected a number from 0 to "
       "1000000 N mm/rad"},
      {in_joint + "lever_mm = inf }]\n",
       "h.toml:3:52: hand.joints[1].lever_mm = inf: expected a finite number"},
      {"[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90 }]\n",
       "h.toml:3:11: missing key 'lever_mm' in 'hand.joints[1]': expected the fingertip force's "
       "lever about the joint, in mm"},
      {in_joint + "lever = 60 }]\n",
       "h.toml:3:41: unknown key 'hand.joints[1].lever': expected one of arm_mm, range_deg, "
       "lever_mm, spring_Nmm_rad, rest_deg, held_deg, guide, mu, wrap_deg, object_deg, "
       "phalanx_mm; did you mean lever_mm?"},
      {hand_with(0), "h.toml:3:10: " + not_so_many},
      {hand_with(17), "h.toml:3:10: " + not_so_many},
      {"[hand]\nforce_N = 5\njoints = [8]\n", "h.toml:3:11: hand.joints[1] = 8: expected a table"},
      {"[hand]\nforce_N = -5\njoints = [" + joint + "]\n",
       "h.toml:1:2: hardware: hand.force_N = -5: expected a number from 0 to 100000 N"},
      {hand_table + "[finger.1]\nclosing = 0.8\n",
       "h.toml:5:1: closing stands beside joints: expected one of them: how far fingers with joints "
       "close follows from these"},
      {"[finger.1]\njoints = [" + joint + "]\n",
       "h.toml:1:9: hardware: finger.1: its joints are given, and no force_N: expected the force "
       "wanted at the fingertip, there or in [hand]"},
      {"[motor]\nstroke_mm = 60\n",
       "h.toml:1:2: motor says something of a hand, and no finger has joints: expected joints in "
       "[hand] or in [finger.1], [finger.2], …"},
      {"[finger.2]\nforce_N = 6\n",
       "h.toml:2:1: finger.2.force_N says something of a hand, and no finger has joints: expected "
       "joints in [hand] or in [finger.1], [finger.2], …"},
      {hand_table + "[motor]\nclose_s = 0\n",
       "h.toml:4:2: hardware: motor.close_s = 0: expected a number from 0.001 to 3600 s"},
      {hand_table + "[motor]\nspool_mm = 6\n",
       "h.toml:5:1: unknown key 'motor.spool_mm': expected one of spool_radius_mm, close_s, force_N, "
       "stroke_mm"},
  };
  for (const Mistake& mistake : mistakes) EXPECT_EQ(error_in(mistake.text), mistake.message);
}

}  // namespace
}  // namespace reeve
