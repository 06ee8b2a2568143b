// What is asked of a hand and cannot be answered: one line, exit code 2.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

const std::string needed =
    " needs a hand; expected the joints of its fingers, or a pull wanted of them, in the file of "
    "--hardware or --model (docs/hand.md)";

BadLine with_file(Arguments arguments, const std::string& file, const std::string& message) {
  arguments.insert(arguments.end(), {"--hardware", file});
  return {std::move(arguments), message};
}

TEST(BadHand, IsMissingThoughItsObjectivesAreAskedFor) {
  expect_all_bad({
      {"rank TR1 --objectives uniformity,motor_force", "--objectives: motor_force" + needed},
      {"rank TR1 --score uniformity=1,stroke=0.1", "--score: stroke" + needed},
      {"explore --out out --objectives fingertip_force",
       "--objectives: fingertip_force_mean" + needed},
      {"explore --out out --constraint stroke<=60", "--constraint 'stroke<=60': stroke" + needed},
  });
}

TEST(BadHand, LacksAFingerOfTheRouting) {
  const std::string message =
      "one_finger.toml: hardware: finger 2 has no joints; expected joints in [finger.2], or in [hand] for all "
      "fingers";
  expect_all_bad({
      with_file("show TR1", "one_finger.toml", message),
      with_file("rank TR1 TR7", "one_finger.toml", message),
      with_file("explore --out out", "one_finger.toml", message),
      with_file(
          "show TR1", "one_force.toml",
          "one_force.toml: hardware: finger 2 has no force_N; expected force_N in [finger.2], "
          "or in [hand] for all fingers"),
      with_file("export TR1", "one_finger_more.toml",
                "one_finger_more.toml:4:9: hardware: finger 2 has no joints; expected joints in "
                "[finger.2]"),
  });
}

TEST(BadHand, IsNamedByFileLineAndColumn) {
  expect_all_bad({
      with_file("show TR1", "bad_joint.toml",
                "bad_joint.toml:3:11: missing key 'range_deg' in 'hand.joints[1]'"),
      with_file("explore --out out", "bad_force.toml",
                "bad_force.toml:1:2: hardware: hand.force_N = -1: expected a number from 0 to "
                "100000 N"),
  });
}

TEST(BadHand, HasAnImpossibleGuide) {
  expect_all_bad({
      with_file("show TR1", "guide_name.toml",
                "guide_name.toml:3:64: hand.joints[1].guide = \"rope\": expected \"pulley\" or "
                "\"tube\""),
      with_file("show TR1", "no_guide.toml",
                "no_guide.toml:3:11: missing key 'guide' in 'hand.joints[1]': expected \"pulley\" "
                "or \"tube\""),
      with_file("show TR1", "guide_mu.toml",
                "guide_mu.toml:1:2: hardware: hand.joints[1].mu = 3: expected a number from 0 to "
                "1"),
      with_file("show TR1", "object.toml",
                "object.toml:1:2: hardware: hand.joints[1].object_deg = 100: expected a number "
                "from 0 to 90 deg"),
      with_file("show TR1", "wraps.toml",
                "wraps.toml:1:2: hardware: hand.joints: sum of mu * wrap of the closed finger = "
                "13.79: expected at most 10"),
  });
}

}  // namespace
}  // namespace reeve::testing
