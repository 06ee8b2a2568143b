// Results go to stdout, progress to a terminal only, and what cannot be printed is an error.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

using namespace std::chrono_literals;

TEST(Progress, IsSilentWhereStderrIsNoTerminal) {
  ProcessOptions options{.disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 1s)}};
  const Explored explored("--fingers 9 --top 10", options);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_EQ(explored.result.err, "");
}

TEST(Progress, ShowsShareRateAndTimeLeftOnATerminalAndWipesItself) {
  ProcessOptions options{.stderr_is_terminal = true};
  options.environment["TERM"] = "xterm";
  options.disturbance = Disturbance{SIGINT, [](const RunningProcess& process) {
                                      return process.err.find(" s left") != std::string::npos;
                                    }};
  const Explored explored("--fingers 9 --top 10", options);
  ASSERT_FALSE(explored.result.timed_out);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_TRUE(explored.result.err.starts_with("\rexploring [>")) << explored.result.err;
  EXPECT_TRUE(has(explored.result.err, "]   0 %, "));
  EXPECT_TRUE(has(explored.result.err, " a second, "));
  EXPECT_TRUE(explored.result.err.ends_with("\r\x1b[K")) << explored.result.err;
  // The table stays clean.
  EXPECT_EQ(explored.result.out.find('\x1b'), std::string::npos);
}

// Codes would be shown as they are.
TEST(Progress, IsSilentOnATerminalThatKnowsNoCodes) {
  ProcessOptions options{.stderr_is_terminal = true};
  options.environment["TERM"] = "dumb";
  options.disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 1s)};
  EXPECT_EQ(Explored("--fingers 9 --top 10", options).result.err, "");
}

TEST(Progress, LeavesNoTraceOfShortWork) {
  ProcessOptions options{.stderr_is_terminal = true};
  EXPECT_EQ(Explored("--fingers 2", options).result.err, "");
}

TEST(FullStdout, IsAnError) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path(), .stdout_to = "/dev/full"};
  for (const Arguments arguments : {"show TR1", "show TR1 --format dot", "rank --catalogue",
                                    "count", "check", "explore --out out"}) {
    SCOPED_TRACE(arguments[0]);
    const ProcessResult result = reeve(arguments, options);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err, "reeve: standard output cannot be written\n");
  }
}

TEST(FullStdout, IsAmongTheExitCodesOfTheHelp) {
  const std::string help = reeve("--help").out;
  EXPECT_TRUE(has(help, "3 interrupted, standard output cannot be written, not enough memory"));
}

TEST(FullStdout, IsAnErrorForHelpAndVersionToo) {
  ProcessOptions options{.stdout_to = "/dev/full"};
  EXPECT_EQ(reeve("--help", options).exit_code, 3);
  EXPECT_EQ(reeve("--version", options).exit_code, 3);
}

TEST(ClosedPipe, EndsTheProgramQuietly) {
  const ProcessResult result =
      run_process({"bash", "-c", "\"$0\" check | head -n 1 >/dev/null", reeve_path()});
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.exit_code, 0);
}

// The rule for every file that is written, as one sees it from the shell.
TEST(WrittenFile, GoesThroughDevicesLinksAndDescriptors) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/null", folder.path() / "null");
  std::filesystem::create_symlink("target", folder.path() / "link");
  ProcessOptions options{.directory = folder.path()};
  for (const Arguments& command :
       {Arguments("simulate --routings TR5 -o"), Arguments("show TR5 --svg"),
        Arguments("check --svg"),
        Arguments("size TR5 --vary sheath_angle=3..9 --nominal --save-hardware"),
        Arguments{"diagnose", readings, "--save-model"}}) {
    SCOPED_TRACE(command[0]);
    const auto with = [&](const std::string& file) {
      Arguments arguments = command;
      arguments.push_back(file);
      return reeve(arguments, options);
    };
    EXPECT_EQ(with("/dev/null").exit_code, 0);
    EXPECT_EQ(with("null").exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "null"));
    std::filesystem::remove(folder.path() / "target");
    EXPECT_EQ(with("link").exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
    const std::string written = read_text(folder.path() / "target");
    EXPECT_FALSE(written.empty());
    const ProcessResult out = with("/dev/stdout");
    EXPECT_EQ(out.exit_code, 0);
    EXPECT_EQ(out.out.substr(0, written.size()).substr(0, 40), written.substr(0, 40));
    const ProcessResult full = with("/dev/full");
    EXPECT_EQ(full.exit_code, 2);
    EXPECT_TRUE(has(full.err, "No space left on device"));
  }
}

TEST(Folder, ThatCannotBeMadeIsNamedWithTheReason) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder.path() / "a");
  std::filesystem::create_symlink("a", folder.path() / "b");
  ProcessOptions options{.directory = folder.path()};
  for (const Arguments& command :
       {Arguments{"explore"}, Arguments("show TR1"), Arguments("rank TR1 TR7"),
        Arguments{"compare", readings}, Arguments{"diagnose", readings}}) {
    SCOPED_TRACE(command[0]);
    for (const auto& [out, reason] : std::vector<std::pair<std::string, std::string>>{
             {"a", "Too many levels of symbolic links"},
             {"a/below", "Too many levels of symbolic links"},
             {std::string(300, 'n'), "File name too long"}}) {
      Arguments arguments = command;
      arguments.insert(arguments.end(), {"--out", out});
      const ProcessResult result = reeve(arguments, options);
      EXPECT_EQ(result.exit_code, 2);
      EXPECT_EQ(result.err, "reeve: --out '" + out +
                                "': expected a folder that can be written to: " + reason + "\n");
    }
  }
}

// Before the search, which may take hours.
TEST(Explore, RefusesAFolderInWhichOneOfItsFilesCannotBeWritten) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  const auto refusal = [&](const std::string& out) {
    const ProcessResult result = reeve({"explore", "--fingers", "16", "--out", out}, options);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  std::filesystem::create_directories(folder.path() / "a" / "designs.csv");
  EXPECT_EQ(refusal("a"),
            "reeve: --out 'a/designs.csv': expected the name of a file, not a folder\n");
  std::filesystem::create_directories(folder.path() / "b");
  folder.write("b/figures", "");
  EXPECT_EQ(
      refusal("b"),
      "reeve: --out 'b/figures': expected a folder that can be written to: Not a directory\n");
}

bool said_something(const RunningProcess& process) {
  return process.err.find('\n') != std::string::npos;
}

// In a folder with a pipe that nobody has at its other end.
class Pipe : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
    options_.directory = folder_.path();
  }

  TemporaryFolder folder_;
  ProcessOptions options_;
};

TEST_F(Pipe, ThatNobodyWritesToIsSaidToBeWaitedFor) {
  options_.disturbance = Disturbance{SIGTERM, said_something};
  for (const Arguments command : {"compare pipe", "show TR1 --hardware pipe"}) {
    const ProcessResult result = reeve(command, options_);
    EXPECT_EQ(result.signal, SIGTERM);
    EXPECT_EQ(result.err, "reeve: waiting for 'pipe': a pipe that nobody has written to yet\n");
  }
}

TEST_F(Pipe, ThatNobodyReadsIsSaidToBeWaitedFor) {
  options_.disturbance = Disturbance{SIGTERM, said_something};
  const ProcessResult result = reeve("show TR1 --svg pipe", options_);
  EXPECT_EQ(result.signal, SIGTERM);
  EXPECT_EQ(result.err, "reeve: waiting for 'pipe': a pipe that nobody reads yet\n");
}

// Whether that has been said or not.
TEST_F(Pipe, ThatNobodyReadsIsLeftOnCtrlC) {
  for (const bool is_said : {false, true}) {
    options_.disturbance =
        Disturbance{SIGINT, is_said ? said_something : after_it_catches(SIGINT, 700ms)};
    const ProcessResult result =
        reeve({"diagnose", std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_cause.csv",
               "--save-model", "pipe"},
              options_);
    EXPECT_EQ(result.exit_code, 3) << result.signal;
    EXPECT_TRUE(has(result.err, "reeve: interrupted"));
    if (is_said) {
      EXPECT_TRUE(has(result.err, ": nobody reads '"));
    }
  }
}

}  // namespace
}  // namespace reeve::testing
