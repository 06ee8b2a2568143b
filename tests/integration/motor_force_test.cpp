// The motor force is one number: the same of the same hardware, whichever command tells it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

constexpr const char* sized_word = "M-1b-T-2b-B-3b-M";

std::string output_of(const std::vector<std::string>& arguments) {
  const ProcessResult result = reeve(Arguments(arguments));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

Json parsed(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--format", "json"});
  return Json::parse(output_of(arguments));
}

// A hand of which each finger has a bend of its own, as `size` leaves it.
class SizedHand {
 public:
  SizedHand() {
    sized = parsed({"size", sized_word, "--hardware",
                    REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml", "--goal", "motor_force",
                    "--vary", "sheath_angle=2..5", "--draws", "10", "--starts", "1",
                    "--evaluations", "20", "--save-hardware", file})["designs"][0]["sized"];
  }

  TemporaryFolder folder;
  std::string file = (folder.path() / "hand.toml").string();
  Json sized;
};

TEST(MotorForceOfTheCommands, IsOneNumber) {
  const SizedHand hand;
  const Json motor = hand.sized["motor"];
  EXPECT_GT(motor["p95_N"], motor["nominal_N"]);
  EXPECT_EQ(motor["nominal_N"], hand.sized["hand"]["motor_force"]);
  EXPECT_NEAR(motor["p95_N"], hand.sized["goal"], 1e-9);

  EXPECT_EQ(parsed({"show", sized_word, "--hardware", hand.file})["hand"]["motor"]["drawn"], motor);
  EXPECT_EQ(parsed({"rank", sized_word, "--hardware", hand.file})["motor"], motor);
  const Json drawn = parsed({"rank", sized_word, "--hardware", hand.file, "--uncertainty"});
  EXPECT_EQ(drawn["motor"], motor);
  EXPECT_EQ(drawn["designs"][0]["bands"]["motor_force"]["p95"], motor["p95_N"]);
  // No design meets the target; the motor force is that of all grasps all the same.
  const ProcessResult aimed = reeve(Arguments{
      "size", sized_word, "--hardware", hand.file, "--vary", "tip_angle[1]=3..3.2", "--target",
      "1=2,others=1", "--nominal", "--starts", "1", "--evaluations", "10", "--format", "json"});
  EXPECT_EQ(Json::parse(aimed.out)["designs"][0]["before"]["motor"], motor);
}

TEST(MotorForceOfTheCommands, IsThatOfTheFirstDesignInAnExploration) {
  const SizedHand hand;
  const std::string out = (hand.folder.path() / "out").string();
  const Json explored = parsed({"explore", "--fingers", "3", "--parts", "full",
                                "--distinct-fingers", "--hardware", hand.file, "--objectives",
                                "motor_force", "--constraint", "sheaths<=1", "--out", out});
  const std::string first = explored["top"][0]["routing"];
  EXPECT_EQ(parsed({"show", first, "--hardware", hand.file})["hand"]["motor"]["drawn"],
            explored["motor"]);
  EXPECT_EQ(explored["motor"]["nominal_N"], explored["top"][0]["hand"]["motor_force"]);
}

TEST(MotorForceOfTheCommands, IsJudgedByItsQuantileInOneSentence) {
  const std::string file = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
  const std::string shown = output_of({"show", sized_word, "--hardware", file});
  const Json motor = parsed({"show", sized_word, "--hardware", file})["hand"]["motor"]["drawn"];
  // The nominal 65.8 N would do, what 95 of 100 hands need would not.
  EXPECT_LT(motor["nominal_N"], 80);
  EXPECT_GT(motor["p95_N"], 80);
  EXPECT_EQ(motor["is_enough"], false);
  const std::string sentence = "The motor's 80 N is too little: 95 % of the draws need up to";
  EXPECT_TRUE(has(shown, sentence));
  EXPECT_FALSE(has(shown, "The motor's 80 N is enough"));
  EXPECT_TRUE(has(output_of({"rank", sized_word, "--hardware", file}), sentence));
}

// Both strands of M-1b-F pull with T_M e^{-0.18 · 2π}, and the motor takes in both excursions.
TEST(WantedPull, IsAHandWhoseLeverIsItsArm) {
  const TemporaryFolder folder;
  const std::string pull =
      "[bearing]\nmu = 0\n[hand]\nforce_N = 20\n"
      "joints = [{ arm_mm = 25, lever_mm = 25, range_deg = 57.29577951308232 }]\n";
  const std::string file = folder.write("pull.toml", pull).string();
  const Json motor = parsed({"show", "M-1b-F", "--hardware", file})["hand"]["motor"];
  EXPECT_NEAR(motor["force_N"], 10 * std::exp(0.18 * 2 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(motor["stroke_mm"], 2 * 25, 1e-6);

  // A pull of 20 N over 25 mm takes 0.5 J, whatever the routing.
  const std::string said = " is less than the 0.5 J that the fingers take: no routing can do it\n";
  folder.write("weak.toml", pull + "[motor]\nforce_N = 5\nstroke_mm = 60\n");
  folder.write("just.toml", pull + "[motor]\nforce_N = 10\nstroke_mm = 60\n");
  const ProcessOptions there{.directory = folder.path()};
  EXPECT_TRUE(
      has(reeve("show M-1b-F --hardware weak.toml", there).out, "\n5 N x 60 mm = 0.3 J" + said));
  EXPECT_FALSE(has(reeve("show M-1b-F --hardware just.toml", there).out, said));
  const ProcessResult none = reeve(
      "explore --fingers 1 --constraint motor_force<=5 --constraint stroke<=60 --hardware weak.toml",
      there);
  EXPECT_EQ(none.exit_code, 1) << none.err;
  EXPECT_TRUE(has(none.out, "\n5 N x 60 mm = 0.3 J" + said)) << none.out;
}

}  // namespace
}  // namespace reeve::testing
