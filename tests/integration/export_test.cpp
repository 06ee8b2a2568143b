// `reeve export` from outside. What MuJoCo makes of the files: tests/mujoco.
#include <gtest/gtest.h>

#include <string>

#include "tests/integration/explored.hpp"

namespace reeve::testing {
namespace {

TEST(Export, WritesTheSameToAFileAndToStdout) {
  const TemporaryFolder folder;
  const ProcessResult shown = reeve({"export", "TR7"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  const std::string file = (folder.path() / "tr7.xml").string();
  const ProcessResult written = reeve({"export", "1-P-2-P-1", "--format", "mjcf", "-o", file});
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read_text(file), shown.out);
}

TEST(Export, AMechanismHasItsOwnHardwareUnlessAnotherIsGiven) {
  const std::string own = reeve({"export", "ExoGlovePoly"}).out;
  const std::string other =
      reeve({"export", "ExoGlovePoly", "--hardware",
             std::string(REEVE_CATALOG_DIR) + "/hardware/three_finger_hand.toml"})
          .out;
  EXPECT_NE(own, other);
  EXPECT_NE(other.find("finger_1_joint_1"), std::string::npos);
}

TEST(Export, RefusesWhatItCannotExport) {
  const auto complaint = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "export");
    const ProcessResult result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_NE(complaint({"M-1-Q"}).find("M-1-Q"), std::string::npos);
  EXPECT_NE(complaint({"F-1-F"}).find("motor"), std::string::npos);
  EXPECT_NE(complaint({"Y1-P-Y2+1x-Y1-T-Y2-2x"}).find("free to move"), std::string::npos);
  EXPECT_NE(complaint({"TR7", "--format", "urdf"}).find("mjcf"), std::string::npos);
  EXPECT_NE(complaint({"TR7", "-o", ""}).find("a file"), std::string::npos);
}

}  // namespace
}  // namespace reeve::testing
