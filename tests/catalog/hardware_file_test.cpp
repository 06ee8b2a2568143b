#include "catalog/hardware_file.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "catalog/hardware_tables.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Mistake;
using testing::TemporaryFolder;

HardwareFile hardware_file_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_hardware_file(folder.write("h.toml", text));
}

std::string error_in_hardware(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_hardware_file(folder.write("h.toml", text)); });
}

HardwareFile written_and_read(const HardwareFile& file) {
  return hardware_file_of(hardware_toml(file.hardware, file.uncertainty, file.vary));
}

void expect_defaults(const HardwareFile& file) {
  const Hardware paper;
  EXPECT_EQ(file.hardware.tube, paper.tube);
  EXPECT_EQ(file.hardware.bearing, paper.bearing);
  EXPECT_EQ(file.hardware.sheath, paper.sheath);
  EXPECT_EQ(file.hardware.strand_mm, paper.strand_mm);
  EXPECT_TRUE(file.hardware.fingers.empty());
  EXPECT_TRUE(file.hardware.contacts.empty());
  EXPECT_EQ(file.uncertainty.tube_mu.low, 0.05);
  EXPECT_EQ(file.uncertainty.tube_mu.high, 0.20);
  EXPECT_EQ(file.uncertainty.sheath_angle_relative, 0.2);
}

TEST(HardwareFile, IsThePapersHardwareWhereNothingIsGiven) {
  expect_defaults(hardware_file_of(""));
  expect_defaults(hardware_file_of("# only a comment\n"));
  expect_defaults(hardware_file_of("\xEF\xBB\xBF"));
  expect_defaults(hardware_file_of("[tube]\n[finger]\n[uncertainty]\n"));
}

TEST(HardwareFile, GivesEveryKeyOfTheExampleToCore) {
  const HardwareFile file =
      read_hardware_file(std::string(REEVE_CATALOG_DIR) + "/hardware/example.toml");
  const Hardware& hardware = file.hardware;
  EXPECT_EQ(hardware.sheath.angle_rad, 2 * std::numbers::pi);
  EXPECT_EQ(hardware.fingers,
            (std::vector<FingerHardware>{{2, 0.09, std::numbers::pi, 0.18, 7.0, 90, 0.8}}));
  // Its contact is commented out, so that the file serves every routing.
  EXPECT_TRUE(hardware.contacts.empty());
}

TEST(HardwareFile, ReadsEveryNumberIntoItsOwnPlace) {
  const HardwareFile file = hardware_file_of(
      "tube = { mu = 0.01, angle_rad = 1.1 }\nbearing = { mu = 0.02, angle_rad = 1.2 }\n"
      "sheath = { mu = 0.03, angle_rad = 1.3 }\n"
      "[lengths]\nstrand_mm = 11\nmotor_side_mm = 12\nhand_mm = 13\n"
      "[uncertainty]\ntube_mu = [0.1, 0.2]\nsheath_mu = [0, 1]\nbearing_mu_relative = 0.3\n"
      "sheath_angle_relative = 0.4\ncontact_relative = 0.05\nbearing_contact_relative = 0.2\n");
  EXPECT_EQ(file.hardware.scatter, (ContactScatter{0.05, 0.2}));
  EXPECT_EQ(file.hardware.tube, (ContactLaw{0.01, 1.1}));
  EXPECT_EQ(file.hardware.bearing, (ContactLaw{0.02, 1.2}));
  EXPECT_EQ(file.hardware.sheath, (ContactLaw{0.03, 1.3}));
  EXPECT_EQ(file.hardware.strand_mm, 11);
  EXPECT_EQ(file.hardware.motor_side_mm, 12);
  EXPECT_EQ(file.hardware.hand_mm, 13);
  EXPECT_EQ(file.uncertainty.tube_mu.low, 0.1);
  EXPECT_EQ(file.uncertainty.tube_mu.high, 0.2);
  EXPECT_EQ(file.uncertainty.sheath_mu.low, 0);
  EXPECT_EQ(file.uncertainty.sheath_mu.high, 1);
  EXPECT_EQ(file.uncertainty.bearing_mu_relative, 0.3);
  EXPECT_EQ(file.uncertainty.sheath_angle_relative, 0.4);
}

TEST(HardwareFile, HasALawOfBlocksOnlyWhereItIsGiven) {
  EXPECT_FALSE(hardware_file_of("[bearing]\nmu = 0.02\n").hardware.block);
  const Hardware given =
      hardware_file_of("block = { mu = 0.04, angle_rad = 1.4 }\nbearing = { mu = 0.02 }\n")
          .hardware;
  EXPECT_EQ(given.block, (ContactLaw{0.04, 1.4}));
  EXPECT_EQ(given.bearing.mu, 0.02);
}

TEST(HardwareFile, TakesFromTheBearingsWhatIsNotGivenOfABlock) {
  const Hardware hardware =
      hardware_file_of("[block]\nmu = 0.04\n[bearing]\nangle_rad = 2\n").hardware;
  EXPECT_EQ(hardware.block, (ContactLaw{0.04, 2}));
}

TEST(HardwareFile, TakesTheBendsOfASheathInDegrees) {
  const Hardware hardware =
      hardware_file_of("[sheath]\nbend_deg = 90\n[finger.2]\nsheath_bend_deg = 45\n").hardware;
  EXPECT_DOUBLE_EQ(hardware.sheath.angle_rad, std::numbers::pi / 2);
  EXPECT_EQ(hardware.sheath.mu, 0.18);
  EXPECT_DOUBLE_EQ(*hardware.fingers.at(0).sheath_angle_rad, std::numbers::pi / 4);
  EXPECT_EQ(error_in_hardware("[sheath]\nangle_rad = 1\nbend_deg = 57\n"),
            "h.toml:3:1: bend_deg stands beside angle_rad: expected one of them: both are the sum "
            "of the sheath's bends");
  EXPECT_EQ(error_in_hardware("[finger.1]\nsheath_bend_deg = 5\nsheath_angle_rad = 1\n"),
            "h.toml:2:1: sheath_bend_deg stands beside sheath_angle_rad: expected one of them: "
            "both are the sum of the sheath's bends");
  EXPECT_EQ(error_in_hardware("[sheath]\nbend_deg = 60000\n"),
            "h.toml:1:2: hardware: sheath.angle_rad = 1047.1975511965977: expected a number from 0 "
            "to 1000 rad");
}

TEST(HardwareFile, KeepsTheLengthOfASheathWhichChangesNoFriction) {
  const HardwareFile file = hardware_file_of("[sheath]\nlength_mm = 800\n");
  EXPECT_EQ(file.hardware.sheath.length_mm, 800);
  EXPECT_EQ(file.hardware.sheath.exponent(), Hardware{}.sheath.exponent());
  EXPECT_EQ(written_and_read(file).hardware.sheath.length_mm, 800);
  EXPECT_FALSE(hardware_file_of("").hardware.sheath.length_mm);
  EXPECT_EQ(
      error_in_hardware("[sheath]\nlength_mm = 0\n"),
      "h.toml:1:2: hardware: sheath.length_mm = 0: expected a number from 0.001 to 1000000 mm");
}

TEST(HardwareFile, AddsTheWobbleOfASheathInProportionToItsLength) {
  const std::string given =
      "[sheath]\nmu = 0.2\nangle_rad = 0.25\nlength_mm = 15000\nwobble_rad_per_m = 0.01\n";
  const HardwareFile file = hardware_file_of(given);
  EXPECT_DOUBLE_EQ(file.hardware.sheath.exponent(), 0.2 * (0.25 + 0.15));
  EXPECT_EQ(written_and_read(file).hardware.sheath, file.hardware.sheath);
  // A finger that has its own bends keeps the wobble of the sheath.
  const Hardware own = hardware_file_of(given + "[finger.1]\nsheath_angle_rad = 0\n").hardware;
  const Network network = expand(parse_routing("M-1x"));
  EXPECT_DOUBLE_EQ(mechanics(network, own).phi.at(0), 0.2 * 0.15);
  EXPECT_EQ(error_in_hardware("[sheath]\nwobble_rad_per_m = 0.01\n"),
            "h.toml:2:20: sheath.wobble_rad_per_m = 0.01: expected a length_mm of the sheath "
            "beside it, on which the wobble adds up");
}

TEST(HardwareFile, TakesAWholeNumberAndWindowsLineEnds) {
  EXPECT_EQ(hardware_file_of("[tube]\r\nmu = 1\r\n").hardware.tube.mu, 1.0);
}

// A large angle is right with a small coefficient, in whatever order the two stand.
TEST(HardwareFile, ChecksCoefficientAndAngleTogether) {
  EXPECT_EQ(hardware_file_of("[tube]\nangle_rad = 100\nmu = 0.01\n").hardware.tube.exponent(), 1.0);
  EXPECT_EQ(error_in_hardware("[tube]\nangle_rad = 100\n"),
            "h.toml:1:2: hardware: tube: mu * angle = 18: expected at most 10");
}

TEST(HardwareFile, NamesThePlaceOfABadNumber) {
  const std::vector<Mistake> mistakes = {
      {"[tube]\nmu = -0.1\n", "h.toml:2:6: tube.mu = -0.1: expected a finite number, not negative"},
      {"[tube]\nmu = nan\n", "h.toml:2:6: tube.mu = nan: expected a finite number, not negative"},
      {"[tube]\nangle_rad = inf\n",
       "h.toml:2:13: tube.angle_rad = inf: expected a finite number, not negative"},
      {"[tube]\nmu = \"0.1\"\n",
       "h.toml:2:6: tube.mu = \"0.1\": expected a finite number, not negative"},
      {"[tube]\nmu = true\n", "h.toml:2:6: tube.mu = true: expected a finite number, not negative"},
      {"[tube]\nmu = 11\n", "h.toml:1:2: hardware: tube.mu = 11: expected a number from 0 to 10"},
      {"[block]\nmu = 11\n", "h.toml:1:2: hardware: block.mu = 11: expected a number from 0 to 10"},
      {"[block]\nangle_rad = 99\nmu = 9\n",
       "h.toml:1:2: hardware: block: mu * angle = 891: expected at most 10"},
      {"[lengths]\nstrand_mm = 0\n",
       "h.toml:1:2: hardware: lengths.strand_mm = 0: expected a number from 0.001 to 1000000 mm"},
      {"[finger.2]\nclosing = 0\n",
       "h.toml:1:9: hardware: finger.2.closing = 0: expected a number from 0.001 to 1000"},
      {"[finger.2]\nsheath_angle_rad = 99\n",
       "h.toml:1:9: hardware: finger.2 sheath: mu * angle = 17.82: expected at most 10"},
      {"[spools]\nb = 0\n",
       "h.toml:2:1: hardware: spools.b = 0: expected a number from 0.001 to 1000"},
      {"[spools]\nb = -2000\n",
       "h.toml:2:1: hardware: spools.b = -2000: expected a number from -1000 to -0.001"},
      {"[spools]\nb = nan\n", "h.toml:2:5: spools.b = nan: expected a finite number"},
      {"[spools]\nx9 = 0.5\n",
       "h.toml:2:1: hardware: spools 'x9': expected a motor-side segment such as a"},
      {"[spools]\nT1 = 0.5\n",
       "h.toml:2:1: hardware: spools 'T1': expected a motor-side segment such as a"},
      {"[tendon]\nEA_N = 0\n",
       "h.toml:2:1: hardware: tendon.EA_N = 0: expected a number from 1 to 1000000000 N"},
      {"[tendon]\nEI = 3\n",
       "h.toml:2:1: unknown key 'tendon.EI': expected EA_N, travel_mm, or a table [tendon.1] to "
       "[tendon.128] with stiffness_N_mm or slack_mm"},
      {"[tendon]\nstiffness_N_mm = 4\n",
       "h.toml:2:1: unknown key 'tendon.stiffness_N_mm': expected EA_N, travel_mm, or a table "
       "[tendon.1] to [tendon.128] with stiffness_N_mm or slack_mm"},
      {"[tendon]\nEA_N = nan\n",
       "h.toml:2:1: hardware: tendon.EA_N = nan: expected a number from 1 to 1000000000 N"},
      {"[tendon]\nEA_N = 2000\n[tendon.2]\nstiffness_N_mm = 0\n",
       "h.toml:4:1: hardware: tendon.2.stiffness_N_mm = 0: expected a number from 0.001 to 1000000 "
       "N/mm"},
      {"[tendon]\nEA_N = 2000\n[tendon.2]\nstiffness_N_mm = -3\n",
       "h.toml:4:1: hardware: tendon.2.stiffness_N_mm = -3: expected a number from 0.001 to 1000000 "
       "N/mm"},
      {"[tendon]\nEA_N = 2000\n[tendon.2]\nstiffness_N_mm = nan\n",
       "h.toml:4:1: hardware: tendon.2.stiffness_N_mm = nan: expected a number from 0.001 to 1000000 "
       "N/mm"},
      {"[tendon]\nEA_N = 2000\n[tendon.2]\nstiffness_N_mm = '4'\n",
       "h.toml:4:18: tendon.2.stiffness_N_mm = \"4\": expected a number"},
      {"[tendon]\ntravel_mm = 30\n[tendon.2]\nslack_mm = -1\n",
       "h.toml:4:1: hardware: tendon.2.slack_mm = -1: expected a number from 0 to 1000000 mm"},
      {"[tendon.2]\nstiffness_N_mm = 5\n",
       "h.toml:2:1: hardware: tendon.2.stiffness_N_mm = 5: expected EA_N in [tendon]: the spring "
       "gives way beside the tendon's own EA/L"},
      {"[tendon.2]\nslack_mm = 5\n",
       "h.toml:2:1: hardware: tendon.2.slack_mm = 5: expected travel_mm in [tendon]: the carriage "
       "travel that slack is a part of"},
      {"[uncertainty]\ntube_mu = [0.2, 0.1]\n",
       "h.toml:2:11: uncertainty.tube_mu = [0.2, 0.1]: expected two friction coefficients, the "
       "least and the greatest, such as [0.05, 0.20], at most 10"},
      {"[uncertainty]\ntube_mu = [0.2]\n",
       "h.toml:2:11: uncertainty.tube_mu = (an array): expected two friction coefficients, the "
       "least and the greatest, such as [0.05, 0.20]"},
      {"[uncertainty]\nsheath_mu = [0.1, nan]\n",
       "h.toml:2:19: uncertainty.sheath_mu[2] = nan: expected a finite number, not negative"},
      {"[uncertainty]\nbearing_mu_relative = 50\n",
       "h.toml:2:23: uncertainty.bearing_mu_relative = 50: expected a half-width from 0 to 1, as a "
       "part of the value"},
      {"[uncertainty]\ncontact_relative = 4\n",
       "h.toml:2:20: uncertainty.contact_relative = 4: expected a standard deviation from 0 to 0.3, "
       "as a part of the value"},
  };
  for (const Mistake& mistake : mistakes)
    EXPECT_EQ(error_in_hardware(mistake.text), mistake.message);
}

TEST(HardwareFile, HasSpoolsAndWritesThem) {
  const HardwareFile file = hardware_file_of("[spools]\nb = 0.5\nd = 2\n");
  EXPECT_EQ(file.hardware.spools, (std::vector<SpoolHardware>{{"b", 0.5}, {"d", 2}}));
  EXPECT_EQ(written_and_read(file).hardware.spools, file.hardware.spools);
}

TEST(HardwareFile, HasSpringsAndSlackAndWritesThem) {
  const HardwareFile file = hardware_file_of(
      "[tendon]\nEA_N = 2e4\ntravel_mm = 30\n[tendon.1]\nstiffness_N_mm = 5\n"
      "[tendon.3]\nslack_mm = 10\n");
  const TendonParts expected{2e4, 30, {{1, 5, {}}, {3, {}, 10}}};
  EXPECT_EQ(file.hardware.tendon, expected);
  EXPECT_EQ(written_and_read(file).hardware.tendon, expected);
}

TEST(HardwareFile, HasBoundsOfDimensionsWithTheirPlaces) {
  const VaryTable vary = hardware_file_of(
                             "[vary]\nsheath_angle = [3, 9.5]\n\"tip_angle[1]\" = [1, 4]\n"
                             "equal = [\"tips\", \"sheath_angle[2,3]\"]\n")
                             .vary;
  ASSERT_EQ(vary.bounds.size(), 2U);
  EXPECT_EQ(vary.bounds[0].name, "sheath_angle");
  EXPECT_EQ(vary.bounds[0].low, 3);
  EXPECT_EQ(vary.bounds[0].high, 9.5);
  EXPECT_TRUE(vary.bounds[0].place.ends_with("h.toml:2:1: vary")) << vary.bounds[0].place;
  EXPECT_EQ(vary.bounds[1].name, "tip_angle[1]");
  ASSERT_EQ(vary.equal.size(), 2U);
  EXPECT_EQ(vary.equal[1].text, "sheath_angle[2,3]");
  EXPECT_TRUE(vary.equal[1].place.ends_with("h.toml:4:18: vary")) << vary.equal[1].place;
}

TEST(HardwareFile, MayNameTheTwoContactsOfALoopThatJoinTheSameStrands) {
  const HardwareFile file =
      hardware_file_of("[contact.T1-T2]\nmu = 0.1\n[contact.T2-T1]\nangle_rad = 2\n");
  ASSERT_EQ(file.hardware.contacts.size(), 2U);
  EXPECT_EQ(written_and_read(file).hardware.contacts, file.hardware.contacts);
}

TEST(HardwareFile, IsWrittenWithBoundsOfDimensions) {
  const HardwareFile file = hardware_file_of(
      "[vary]\nhand_mm = [0.1, 9]\n\"contact_angle[T2-T3]\" = [1, 4]\nequal = [\"tips\"]\n");
  const HardwareFile again = written_and_read(file);
  ASSERT_EQ(again.vary.bounds.size(), 2U);
  EXPECT_EQ(again.vary.bounds[0].low, 0.1);
  EXPECT_EQ(again.vary.bounds[1].name, "contact_angle[T2-T3]");
  ASSERT_EQ(again.vary.equal.size(), 1U);
  EXPECT_EQ(again.vary.equal[0].text, "tips");
}

TEST(HardwareFile, NamesThePlaceOfBadBounds) {
  const std::vector<Mistake> mistakes = {
      {"[vary]\ntip_angle = 3\n",
       "h.toml:2:13: vary.tip_angle = 3: expected the least and the greatest, such as [3, 9]"},
      {"[vary]\ntip_angle = [3]\n",
       "h.toml:2:13: vary.tip_angle = (an array): expected the least and the greatest, such as "
       "[3, 9]"},
      {"[vary]\ntip_angle = [3, -1]\n",
       "h.toml:2:17: vary.tip_angle[2] = -1: expected a finite number, not negative"},
      {"[vary]\nequal = \"tips\"\n", "h.toml:2:9: vary.equal = \"tips\": expected an array"},
      {"vary = 3\n", "h.toml:1:8: vary = 3: expected a table"},
  };
  for (const Mistake& mistake : mistakes)
    EXPECT_EQ(error_in_hardware(mistake.text), mistake.message);
}

TEST(HardwareFile, NamesUnknownTablesAndKeysAndTheKnownOnes) {
  const std::vector<Mistake> mistakes = {
      {"[tub]\nmu = 1\n",
       "h.toml:1:2: unknown key 'tub': expected one of tube, bearing, block, sheath, lengths, "
       "finger, contact, spools, tendon, uncertainty, hand, motor, vary; did you mean tube?"},
      {"[tube]\nmu_s = 1\n",
       "h.toml:2:1: unknown key 'tube.mu_s': expected one of mu, angle_rad, known"},
      {"tube = 0.18\n", "h.toml:1:8: tube = 0.18: expected a table"},
      {"[[tube]]\nmu = 1\n", "h.toml:1:1: tube = (an array): expected a table"},
      {"[finger]\nmu = 1\n",
       "h.toml:2:1: unknown table 'finger.mu': expected finger.1 to finger.64"},
      {"[finger.02]\n", "h.toml:1:9: unknown table 'finger.02': expected finger.1 to finger.64"},
      {"[finger.65]\n", "h.toml:1:9: unknown table 'finger.65': expected finger.1 to finger.64"},
      {"[finger.1]\nmu = 1\n",
       "h.toml:2:1: unknown key 'finger.1.mu': expected one of tip_mu, tip_angle_rad, sheath_mu, "
       "sheath_angle_rad, sheath_bend_deg, strand_mm, closing, joints, force_N"},
      {"[contact.aT1]\nmu = 1\n",
       "h.toml:1:10: contact 'aT1': expected the two segments beside it, such as "
       "[contact.\"a-T1\"]"},
      {"[contact.a-Q1]\nmu = 1\n",
       "h.toml:1:10: hardware: contact: segment 'Q1': expected a strand (T1), a motor-side segment "
       "(a) or a stretch at the hand (h1)"},
      {"[contact.a-T1]\nmu = 1\n[contact.T1-a]\nmu = 2\n",
       "h.toml:3:10: contact 'T1-a': expected each contact once"},
      {"[tube]\nmu = 1\nmu = 2\n",
       "h.toml:3:6: not valid TOML: Error while parsing key-value pair: cannot redefine existing "
       "integer 'mu'"},
  };
  for (const Mistake& mistake : mistakes)
    EXPECT_EQ(error_in_hardware(mistake.text), mistake.message);
}

TEST(HardwareFile, RefusesWhatIsNoReadableFile) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& name) {
    return folder.error_of([&] { read_hardware_file(folder.path() / name); });
  };
  std::filesystem::create_directory(folder.path() / "sub");
  EXPECT_EQ(error("none.toml"), "none.toml: cannot be read: No such file or directory");
  EXPECT_EQ(error("sub"), "sub: is a directory: expected a TOML file");
}

TEST(HardwareFile, RefusesMoreThanOneMebibyte) {
  const TemporaryFolder folder;
  const std::string line(1023, '#');
  std::string text;
  for (int i = 0; i < 1024; ++i) text += line + "\n";
  EXPECT_NO_THROW(read_hardware_file(folder.write("h.toml", text)));
  EXPECT_EQ(folder.error_of([&] { read_hardware_file(folder.write("h.toml", text + "\n")); }),
            "h.toml: is larger than 1 MiB: expected a TOML file of some lines");
}

}  // namespace
}  // namespace reeve
