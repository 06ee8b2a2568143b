// docs/projects.md: its commands run as they stand there, and say what stands below them.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

struct DocumentedCommand {
  std::string command;
  std::vector<std::string> lines;  // of what it prints
};

// In a block of code: "./run …", over several lines with a backslash, then what it prints.
std::vector<DocumentedCommand> documented_commands() {
  std::istringstream in(read_text(fs::path(REEVE_SOURCE_DIR) / "docs" / "projects.md"));
  std::vector<DocumentedCommand> commands;
  bool goes_on = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("    ")) continue;
    line.erase(0, 4);
    if (goes_on) {
      commands.back().command += " " + line;
    } else if (line.starts_with("./run ")) {
      commands.push_back({line.substr(6), {}});
    } else {
      commands.back().lines.push_back(line);
      continue;
    }
    std::string& command = commands.back().command;
    goes_on = command.ends_with("\\");
    if (goes_on) command.pop_back();
  }
  return commands;
}

// By a shell, which reads quotes as the reader's does.
ProcessResult run_documented(const std::string& command, const fs::path& folder) {
  ProcessOptions options{.directory = folder};
  return run_process({"/bin/sh", "-c", std::string(REEVE_EXECUTABLE) + " " + command}, options);
}

TEST(Projects, RunAsTheyStandInTheDocument) {
  const TemporaryFolder folder;
  fs::create_directory_symlink(fs::path(REEVE_SOURCE_DIR) / "catalog", folder.path() / "catalog");
  const std::vector<DocumentedCommand> commands = documented_commands();
  ASSERT_GE(commands.size(), 6U);
  fs::create_directory(folder.path() / "out");
  for (const DocumentedCommand& documented : commands) {
    SCOPED_TRACE(documented.command);
    const ProcessResult result = run_documented(documented.command, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_FALSE(documented.lines.empty());
    for (const std::string& line : documented.lines) {
      EXPECT_TRUE(has(("\n" + result.out), "\n" + line + "\n")) << line << "\n\n" << result.out;
    }
  }
  for (const char* page : {"out/prosthesis", "out/thumb", "out/glove"}) {
    EXPECT_TRUE(fs::exists(folder.path() / page / "index.html")) << page;
  }
}

}  // namespace
}  // namespace reeve::testing
