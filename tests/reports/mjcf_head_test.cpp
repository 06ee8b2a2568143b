// What the first lines of an exported file say; the rest of it: tests/mujoco.
#include <gtest/gtest.h>

#include <string>

#include "core/notation.hpp"
#include "reports/mujoco/mjcf.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

TEST(MjcfHead, SaysWhatOfTheHardwareIsAboutNoFingerOfTheRouting) {
  const auto head_with = [](int finger) {
    Hardware hardware;
    hardware.fingers.push_back({finger, {}, {}, {}, {}, {}, 2});
    const std::string text = reports::mjcf(parse_routing("M-1-T-2-F"), hardware);
    return text.substr(0, text.find("-->"));
  };
  EXPECT_TRUE(testing::has(head_with(7),
                           "\nNote: [finger.7] of the hardware changes nothing: no routing here "
                           "has a finger 7.\n"));
  EXPECT_FALSE(testing::has(head_with(2), "Note"));
}

}  // namespace
}  // namespace reeve
