// `reeve export` from outside. What MuJoCo makes of the files: tests/mujoco.
#include <gtest/gtest.h>

#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

TEST(Export, WritesTheSameToAFileAndToStdout) {
  const TemporaryFolder folder;
  const ProcessResult shown = reeve("export TR7");
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  const std::string file = (folder.path() / "tr7.xml").string();
  const ProcessResult written = reeve({"export", "1-P-2-P-1", "--format", "mjcf", "-o", file});
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read_text(file), shown.out);
}

std::string head(const Arguments& arguments) {
  const std::string text = reeve(arguments).out;
  return text.substr(0, text.find("-->"));
}

TEST(Export, SaysAtItsHeadWhatItIsOf) {
  const std::string file = std::string(REEVE_CATALOG_DIR) + "/hardware/three_finger_hand.toml";
  const std::string plain = head({"export", "1-P-2-P-1"});
  EXPECT_TRUE(has(plain, "The routing TR7 (1-P-2-P-1) without friction"));
  EXPECT_TRUE(has(plain, "\nHardware: the paper's, by default.\n"));
  EXPECT_FALSE(has(plain, "Several trees"));
  const std::string hand = head({"export", "M-1-F+M-2-F+M-3-F", "--hardware", file});
  EXPECT_TRUE(has(hand, "The routing M-1-F+M-2-F+M-3-F without"));
  EXPECT_TRUE(has(hand, "\nHardware: " + file + ".\n"));
  EXPECT_TRUE(has(hand, "\nSeveral trees of tendons hang on the carriage"));
  EXPECT_TRUE(has(head({"export", "ExoGlovePoly"}), "\nHardware: the mechanism's own"));
}

TEST(Export, SaysAtItsHeadWhatOfTheHardwareItLeavesOut) {
  const TemporaryFolder folder;
  folder.write("hand.toml", "[finger.7]\nclosing = 2\n");
  const std::string file = (folder.path() / "hand.toml").string();
  const std::string said = head({"export", "TR1", "--hardware", file});
  EXPECT_TRUE(has(said,
                  "\nNote: [finger.7] of the hardware changes nothing: no routing here has a "
                  "finger 7.\n"));
}

// The name of a file may hold what would end a comment.
TEST(Export, IsXmlWhateverTheHardwareIsCalled) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a--b-->c.toml").string();
  folder.write("a--b-->c.toml", "");
  const std::string text = reeve({"export", "TR7", "--hardware", file}).out;
  const std::size_t begin = text.find("<!--") + 4;
  const std::size_t hyphens = text.find("--", begin);
  EXPECT_EQ(text.compare(hyphens, 3, "-->"), 0) << text.substr(begin, 300);
  EXPECT_TRUE(has(text, "a- -b- ->c.toml")) << text.substr(begin, 300);
}

TEST(Export, AMechanismHasItsOwnHardwareUnlessAnotherIsGiven) {
  const std::string own = reeve("export ExoGlovePoly").out;
  const std::string other =
      reeve({"export", "ExoGlovePoly", "--hardware",
             std::string(REEVE_CATALOG_DIR) + "/hardware/three_finger_hand.toml"})
          .out;
  EXPECT_NE(own, other);
  EXPECT_TRUE(has(other, "finger_1_joint_1"));
}

TEST(Export, RefusesWhatItCannotExport) {
  const auto complaint = [](Arguments arguments) {
    arguments.insert(arguments.begin(), "export");
    const ProcessResult result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_TRUE(has(complaint({"M-1-Q"}), "M-1-Q"));
  EXPECT_TRUE(has(complaint({"F-1-F"}), "motor"));
  EXPECT_TRUE(has(complaint({"Y1-P-Y2+1x-Y1-T-Y2-2x"}), "free to move"));
  EXPECT_TRUE(has(complaint({"TR7", "--format", "urdf"}), "mjcf"));
  EXPECT_TRUE(has(complaint({"TR7", "-o", ""}), "a file"));
}

}  // namespace
}  // namespace reeve::testing
