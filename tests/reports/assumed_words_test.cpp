#include "reports/assumed_words.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "tests/support/has.hpp"

namespace reeve::reports {
namespace {

using testing::has;

FingerHardware finger_numbered(int number) {
  FingerHardware finger;
  finger.finger = number;
  return finger;
}

TEST(AssumedText, HasFrictionBendsAndTheLaw) {
  Model model;
  EXPECT_EQ(
      assumed_text(model),
      "Assumed, by default: tubes mu 0.18 over 180 deg, bearings mu 0.001 over 180 deg, sheaths mu 0.18 "
      "over 360 deg; only capstan friction");
  model.hardware.fingers = {finger_numbered(1)};
  EXPECT_TRUE(has(assumed_text(model), ", 1 finger with own values where a routing has them;"));
  model.hardware.contacts = {{"T1", "T2", 0.1, {}}, {"a", "T1", 0.1, {}}};
  EXPECT_TRUE(has(assumed_text(model), ", 1 finger and 2 contacts with own values where "));
}

TEST(AssumedText, SaysWhoseHardwareItIs) {
  Model model;
  model.hardware.origin =
      std::make_shared<const HardwareOrigin>(HardwareOrigin{"rigs/thumb.toml with --mu 0.1", {}});
  EXPECT_TRUE(has(assumed_text(model), "Assumed, by thumb.toml with --mu 0.1: tubes mu 0.18"));
}

TEST(AngleNotes, QuestionAnglesThatLookLikeDegrees) {
  Hardware hardware;
  EXPECT_TRUE(angle_notes(hardware).empty());
  hardware.sheath.angle_rad = 8 * std::numbers::pi;
  EXPECT_TRUE(angle_notes(hardware).empty());
  hardware.bearing.angle_rad = 180;
  EXPECT_EQ(angle_notes(hardware),
            std::vector<std::string>{"the angle of the bearings is 180 rad, 28.6 turns: are "
                                     "degrees meant? 180 deg are 3.142 rad"});
}

TEST(AngleNotes, QuestionThoseOfFingersAndContacts) {
  Hardware hardware;
  hardware.block = ContactLaw{0.001, 90};
  hardware.fingers = {finger_numbered(2)};
  hardware.fingers.front().tip_angle_rad = 170;
  hardware.fingers.front().sheath_angle_rad = 270;
  hardware.contacts = {{"T1", "T2", std::nullopt, 45}};
  const std::vector<std::string> notes = angle_notes(hardware);
  ASSERT_EQ(notes.size(), 4U);
  EXPECT_TRUE(has(notes[0], "the angle of the blocks is 90 rad"));
  EXPECT_TRUE(has(notes[1], "the angle of the tip of finger 2 is 170 rad"));
  EXPECT_TRUE(has(notes[2], "the angle of the sheaths of finger 2 is 270 rad"));
  EXPECT_TRUE(has(notes[3], "the angle of contact T1-T2 is 45 rad"));
}

}  // namespace
}  // namespace reeve::reports
