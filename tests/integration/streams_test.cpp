// Results go to stdout, progress to a terminal only, and what cannot be printed is an error.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"

namespace reeve::testing {
namespace {

using namespace std::chrono_literals;

TEST(Progress, IsSilentWhereStderrIsNoTerminal) {
  ProcessOptions options;
  options.disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 1s)};
  const Explored explored({"--fingers", "9", "--top", "10"}, options);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_EQ(explored.result.err, "");
}

TEST(Progress, ShowsShareRateAndTimeLeftOnATerminalAndWipesItself) {
  ProcessOptions options;
  options.stderr_is_terminal = true;
  options.environment["TERM"] = "xterm";
  options.disturbance = Disturbance{SIGINT, [](const RunningProcess& process) {
                                      return process.err.find(" s left") != std::string::npos;
                                    }};
  const Explored explored({"--fingers", "9", "--top", "10"}, options);
  ASSERT_FALSE(explored.result.timed_out);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_TRUE(explored.result.err.starts_with("\rexploring [>")) << explored.result.err;
  EXPECT_NE(explored.result.err.find("]   0 %, "), std::string::npos);
  EXPECT_NE(explored.result.err.find(" a second, "), std::string::npos);
  EXPECT_TRUE(explored.result.err.ends_with("\r\x1b[K")) << explored.result.err;
  // The table stays clean.
  EXPECT_EQ(explored.result.out.find('\x1b'), std::string::npos);
}

// Codes would be shown as they are.
TEST(Progress, IsSilentOnATerminalThatKnowsNoCodes) {
  ProcessOptions options;
  options.stderr_is_terminal = true;
  options.environment["TERM"] = "dumb";
  options.disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 1s)};
  EXPECT_EQ(Explored({"--fingers", "9", "--top", "10"}, options).result.err, "");
}

TEST(Progress, LeavesNoTraceOfShortWork) {
  ProcessOptions options;
  options.stderr_is_terminal = true;
  EXPECT_EQ(Explored({"--fingers", "2"}, options).result.err, "");
}

TEST(FullStdout, IsAnError) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = folder.path();
  options.stdout_to = "/dev/full";
  for (const Arguments& arguments :
       {Arguments{"show", "TR1"}, Arguments{"show", "TR1", "--format", "dot"},
        Arguments{"rank", "--catalog"}, Arguments{"count"}, Arguments{"check"},
        Arguments{"explore", "--out", "out"}}) {
    SCOPED_TRACE(arguments[0]);
    const ProcessResult result = reeve(arguments, options);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err, "reeve: standard output cannot be written\n");
  }
}

TEST(FullStdout, IsAnErrorForHelpAndVersionToo) {
  ProcessOptions options;
  options.stdout_to = "/dev/full";
  EXPECT_EQ(reeve({"--help"}, options).exit_code, 3);
  EXPECT_EQ(reeve({"--version"}, options).exit_code, 3);
}

TEST(ClosedPipe, EndsTheProgramQuietly) {
  const ProcessResult result =
      run_process({"bash", "-c", "\"$0\" check | head -n 1 >/dev/null", REEVE_EXECUTABLE});
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.exit_code, 0);
}

}  // namespace
}  // namespace reeve::testing
