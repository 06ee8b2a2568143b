// Bad sweeps: one line that names the culprit, exit code 2, nothing written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

BadLine swept(const std::string& range, const std::string& message, Arguments more = {}) {
  Arguments line{"rank", "TR1", "TR7", "--out", "out", "--sweep", range};
  line.insert(line.end(), more.begin(), more.end());
  return {line, message};
}

BadLine explored(const std::string& range, const std::string& message, Arguments more = {}) {
  Arguments line{"explore", "--out", "out", "--sweep", range};
  line.insert(line.end(), more.begin(), more.end());
  return {line, message};
}

const std::string bounds =
    "mu= and a lesser and a greater number from 0 to 1 with .. between them, such as mu=0.02..0.3";

TEST(BadSweep, IsNamedWithWhatWasExpected) {
  const std::string which =
      "one of mu, tube_mu, sheath_mu, bearing_mu, sheath_angle, and its range, such as mu=0.02..0.3";
  expect_all_bad({
      swept("", "--sweep '': expected " + which),
      explored("friction=0..1", "--sweep 'friction=0..1': expected " + which),
      swept("mu", "--sweep 'mu': expected " + bounds),
      explored("mu=0.3..0.1", "--sweep 'mu=0.3..0.1': expected " + bounds),
      swept("mu=0..1.5", "--sweep 'mu=0..1.5': expected " + bounds),
      swept("mu=0..x", "--sweep 'mu=0..x': expected " + bounds),
      explored("sheath_angle=1..60",
               "expected sheath_angle= and a lesser and a greater number from "
               "0 to 50 rad"),
  });
}

TEST(BadSweep, OfWhatFrictionDoesNotMoveIsNamed) {
  const std::string message =
      "--sweep 'mu': expected a ranked objective that depends on friction, such as uniformity or "
      "efficiency";
  expect_all_bad({
      swept("mu=0..0.3", message, {"--objectives", "sheaths,knots"}),
      explored("mu=0..0.3", message, {"--objectives", "sheaths"}),
  });
}

TEST(BadSweep, BeyondWhatAContactCanBeIsNamed) {
  expect_all_bad({
      swept(
          "sheath_mu=0..1",
          "--sweep 'sheath_mu': at its upper end: steep.toml:1:2: hardware: sheath: mu * angle = ",
          {"--hardware", "steep.toml"}),
  });
}

}  // namespace
}  // namespace reeve::testing
